//! Schemas of protocol types in the requests `val3/…`, because `lsp_types` does not derive schemas. The names in the
//! schema are those of the protocol.

use std::borrow::Cow;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};

/// Position in a document. The session determines the unit of `character`.
#[derive(JsonSchema)]
#[schemars(rename = "Position")]
#[expect(dead_code, reason = "only its schema is used")]
pub(crate) struct PositionSchema {
    /// Line, from 0.
    line: u32,
    /// Offset in the line, from 0.
    character: u32,
}

/// Range in a document; its end is exclusive.
#[derive(JsonSchema)]
#[schemars(rename = "Range")]
#[expect(dead_code, reason = "only its schema is used")]
pub(crate) struct RangeSchema {
    start: PositionSchema,
    end: PositionSchema,
}

/// Range in a file.
#[derive(JsonSchema)]
#[schemars(rename = "Location")]
#[expect(dead_code, reason = "only its schema is used")]
pub(crate) struct LocationSchema {
    uri: String,
    range: RangeSchema,
}

/// URI of a document.
#[derive(JsonSchema)]
#[schemars(rename = "TextDocumentIdentifier")]
#[expect(dead_code, reason = "only its schema is used")]
pub(crate) struct DocumentSchema {
    uri: String,
}

/// Position in a file.
#[derive(JsonSchema)]
#[schemars(rename = "TextDocumentPositionParams", rename_all = "camelCase")]
#[expect(dead_code, reason = "only its schema is used")]
pub(crate) struct DocumentPositionSchema {
    text_document: DocumentSchema,
    position: PositionSchema,
}

/// `WorkspaceEdit` of the protocol, which describes its properties.
pub(crate) struct WorkspaceEditSchema;

impl JsonSchema for WorkspaceEditSchema {
    fn schema_name() -> Cow<'static, str> {
        "WorkspaceEdit".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({ "type": "object", "description": "Edit of files, as the protocol describes it." })
    }
}
