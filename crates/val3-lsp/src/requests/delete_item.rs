//! `val3/delete`: the edit that deletes a program, data, a library or a type, and the remaining uses.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use tower_lsp::lsp_types::request::Request;
use tower_lsp::lsp_types::{Location, TextDocumentPositionParams, WorkspaceEdit};

use crate::convert::workspace_edit;
use crate::schema::protocol;
use crate::snapshot::{Refusal, Snapshot};

/// The request. Its parameters are the position of the name in its declaration.
pub(crate) enum Delete {}

impl Request for Delete {
    type Params = TextDocumentPositionParams;
    type Result = Deletion;
    const METHOD: &'static str = "val3/delete";
}

/// The edit, and the remaining uses.
#[derive(Debug, Serialize, Deserialize, JsonSchema)]
pub(crate) struct Deletion {
    #[schemars(with = "protocol::WorkspaceEditSchema")]
    edit: WorkspaceEdit,
    /// Locations that use the deleted item.
    #[schemars(with = "Vec<protocol::LocationSchema>")]
    uses: Vec<Location>,
}

pub(crate) fn delete(snapshot: &Snapshot, at: &TextDocumentPositionParams) -> Result<Deletion, Refusal> {
    let at = snapshot.position(at)?;
    let found = val3_ide::delete_item(snapshot.db(), at)?;
    Ok(Deletion {
        edit: workspace_edit(snapshot, &found.change)?,
        uses: found.uses.into_iter().map(|place| snapshot.location(place)).collect(),
    })
}
