//! `textDocument/references`

use tower_lsp::lsp_types::{Location, ReferenceParams};

use crate::snapshot::{Refusal, Snapshot};

pub(crate) fn references(snapshot: &Snapshot, params: &ReferenceParams) -> Result<Option<Vec<Location>>, Refusal> {
    let at = snapshot.position(&params.text_document_position)?;
    let found = val3_ide::references(snapshot.db(), at, params.context.include_declaration);
    let found = found.into_iter().filter(|place| snapshot.is_shown(place.file));
    Ok(Some(found.map(|place| snapshot.location(place)).collect()))
}
