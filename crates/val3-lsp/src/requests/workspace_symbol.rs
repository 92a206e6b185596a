//! `workspace/symbol` and `workspaceSymbol/resolve`

use serde::{Deserialize, Serialize};
use tower_lsp::lsp_types::{
    Location, OneOf, SymbolInformation, WorkspaceLocation, WorkspaceSymbol, WorkspaceSymbolParams,
    WorkspaceSymbolResponse,
};
use val3_syntax::{TextRange, TextSize};

use crate::convert::symbol_kind;
use crate::snapshot::{Refusal, Snapshot};

/// Result limit; the user finds further names by typing more letters.
const LIMIT: usize = 256;

/// Byte range of a name. Lines are computed only when a symbol is chosen.
#[derive(Serialize, Deserialize)]
struct SymbolData {
    start: u32,
    end: u32,
}

pub(crate) fn workspace_symbol(
    snapshot: &Snapshot,
    params: &WorkspaceSymbolParams,
) -> Result<Option<WorkspaceSymbolResponse>, Refusal> {
    let found = val3_ide::workspace_symbols(snapshot.db(), &params.query, LIMIT).into_iter();
    let found = found.filter(|found| snapshot.is_shown(found.place.file));
    Ok(Some(match snapshot.session.client.resolves_symbols {
        true => WorkspaceSymbolResponse::Nested(found.map(|found| unresolved(snapshot, found)).collect()),
        false => WorkspaceSymbolResponse::Flat(found.map(|found| whole(snapshot, found)).collect()),
    }))
}

#[allow(deprecated, reason = "the type has a field that is no longer used")]
fn whole(snapshot: &Snapshot, found: val3_ide::WorkspaceSymbol) -> SymbolInformation {
    SymbolInformation {
        name: found.name.to_string(),
        kind: symbol_kind(found.kind),
        tags: None,
        deprecated: None,
        location: snapshot.location(found.place),
        container_name: Some(found.container),
    }
}

fn unresolved(snapshot: &Snapshot, found: val3_ide::WorkspaceSymbol) -> WorkspaceSymbol {
    let range = found.place.range;
    let place = SymbolData { start: range.start().into(), end: range.end().into() };
    WorkspaceSymbol {
        name: found.name.to_string(),
        kind: symbol_kind(found.kind),
        tags: None,
        container_name: Some(found.container),
        location: OneOf::Right(WorkspaceLocation { uri: snapshot.uri(found.place.file) }),
        data: serde_json::to_value(place).ok(),
    }
}

pub(crate) fn resolve(snapshot: &Snapshot, symbol: &WorkspaceSymbol) -> Result<WorkspaceSymbol, Refusal> {
    let mut symbol = symbol.clone();
    let place = symbol.data.take().and_then(|data| serde_json::from_value::<SymbolData>(data).ok());
    if let (Some(place), OneOf::Right(WorkspaceLocation { uri })) = (place, &symbol.location) {
        let start = TextSize::new(place.start);
        let range = TextRange::new(start, TextSize::new(place.end).max(start));
        let file = snapshot.file(uri).map_err(|_| Refusal::Outdated)?;
        let range = snapshot.range(file, range);
        symbol.location = OneOf::Left(Location { uri: uri.clone(), range });
    }
    Ok(symbol)
}
