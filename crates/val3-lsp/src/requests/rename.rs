//! `textDocument/prepareRename` and `rename`

use tower_lsp::lsp_types::{PrepareRenameResponse, RenameParams, TextDocumentPositionParams, WorkspaceEdit};

use crate::convert::workspace_edit;
use crate::snapshot::{Refusal, Snapshot};

pub(crate) fn prepare(
    snapshot: &Snapshot,
    params: &TextDocumentPositionParams,
) -> Result<Option<PrepareRenameResponse>, Refusal> {
    let at = snapshot.position(params)?;
    let (range, placeholder) = val3_ide::prepare_rename(snapshot.db(), at)?;
    let range = snapshot.range(at.file, range);
    Ok(Some(PrepareRenameResponse::RangeWithPlaceholder { range, placeholder }))
}

pub(crate) fn rename(snapshot: &Snapshot, params: &RenameParams) -> Result<Option<WorkspaceEdit>, Refusal> {
    let at = snapshot.position(&params.text_document_position)?;
    let change = val3_ide::rename(snapshot.db(), at, &params.new_name)?;
    Ok(Some(workspace_edit(snapshot, &change)?))
}
