//! `workspace/symbol`

use tower_lsp::lsp_types::{SymbolInformation, WorkspaceSymbolParams, WorkspaceSymbolResponse};

use crate::convert::symbol_kind;
use crate::snapshot::{Refusal, Snapshot};

/// Names that a client gets at most; more letters find others.
const LIMIT: usize = 256;

#[allow(deprecated, reason = "the type has a field that is no longer used")]
pub(crate) fn workspace_symbol(
    snapshot: &Snapshot,
    params: &WorkspaceSymbolParams,
) -> Result<Option<WorkspaceSymbolResponse>, Refusal> {
    let found = val3_ide::workspace_symbols(snapshot.db(), &params.query, LIMIT);
    let symbol = |found: val3_ide::WorkspaceSymbol| SymbolInformation {
        name: found.name.to_string(),
        kind: symbol_kind(found.kind),
        tags: None,
        deprecated: None,
        location: snapshot.location(found.place),
        container_name: Some(found.container),
    };
    Ok(Some(WorkspaceSymbolResponse::Flat(found.into_iter().map(symbol).collect())))
}
