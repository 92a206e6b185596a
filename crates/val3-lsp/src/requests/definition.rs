//! `textDocument/definition`, `declaration`, `typeDefinition` and `implementation`

use tower_lsp::lsp_types::{GotoDefinitionParams, GotoDefinitionResponse};
use val3_analysis::db::Db;
use val3_ide::{FilePosition, NavigationTarget};

use crate::convert::targets;
use crate::snapshot::{Refusal, Snapshot};

type DefinitionResult = Result<Option<GotoDefinitionResponse>, Refusal>;

pub(crate) fn definition(snapshot: &Snapshot, params: &GotoDefinitionParams) -> DefinitionResult {
    jump(snapshot, params, val3_ide::definition)
}

pub(crate) fn declaration(snapshot: &Snapshot, params: &GotoDefinitionParams) -> DefinitionResult {
    jump(snapshot, params, val3_ide::declarations)
}

pub(crate) fn type_definition(snapshot: &Snapshot, params: &GotoDefinitionParams) -> DefinitionResult {
    jump(snapshot, params, val3_ide::type_definition)
}

pub(crate) fn implementation(snapshot: &Snapshot, params: &GotoDefinitionParams) -> DefinitionResult {
    jump(snapshot, params, val3_ide::implementations)
}

fn jump(
    snapshot: &Snapshot,
    params: &GotoDefinitionParams,
    find: fn(&dyn Db, FilePosition) -> Vec<NavigationTarget>,
) -> DefinitionResult {
    let at = snapshot.position(&params.text_document_position_params)?;
    Ok(Some(targets(snapshot, at.file, &find(snapshot.db(), at))))
}
