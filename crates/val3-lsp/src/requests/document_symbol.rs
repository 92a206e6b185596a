//! `textDocument/documentSymbol`

use tower_lsp::lsp_types::{
    DocumentSymbol, DocumentSymbolParams, DocumentSymbolResponse, Location, SymbolInformation, Url,
};
use val3_ide::OutlineItem;

use crate::convert::symbol_kind;
use crate::lines::PositionConverter;
use crate::snapshot::{Refusal, Snapshot};

pub(crate) fn document_symbol(
    snapshot: &Snapshot,
    params: &DocumentSymbolParams,
) -> Result<Option<DocumentSymbolResponse>, Refusal> {
    let uri = &params.text_document.uri;
    let file = snapshot.file(uri)?;
    let lines = snapshot.lines(file);
    let items = val3_ide::outline(snapshot.db(), file);
    if snapshot.session.client.has_nested_symbols {
        return Ok(Some(DocumentSymbolResponse::Nested(items.iter().map(|item| nested(item, &lines)).collect())));
    }
    let mut flat = Vec::new();
    items.iter().for_each(|item| flatten(item, None, uri, &lines, &mut flat));
    Ok(Some(DocumentSymbolResponse::Flat(flat)))
}

#[allow(deprecated, reason = "the type has a field that is no longer used")]
fn nested(item: &OutlineItem, lines: &PositionConverter<'_>) -> DocumentSymbol {
    let children: Vec<_> = item.children.iter().map(|child| nested(child, lines)).collect();
    DocumentSymbol {
        name: name(item),
        detail: (!item.detail.is_empty()).then(|| item.detail.clone()),
        kind: symbol_kind(item.kind),
        tags: None,
        deprecated: None,
        range: lines.range(item.range),
        selection_range: lines.range(item.name_range),
        children: (!children.is_empty()).then_some(children),
    }
}

#[allow(deprecated, reason = "the type has a field that is no longer used")]
fn flatten(
    item: &OutlineItem,
    container: Option<&str>,
    uri: &Url,
    lines: &PositionConverter<'_>,
    flat: &mut Vec<SymbolInformation>,
) {
    flat.push(SymbolInformation {
        name: name(item),
        kind: symbol_kind(item.kind),
        tags: None,
        deprecated: None,
        location: Location { uri: uri.clone(), range: lines.range(item.range) },
        container_name: container.map(str::to_owned),
    });
    item.children.iter().for_each(|child| flatten(child, Some(&item.name), uri, lines, flat));
}

/// Display name of a symbol. Clients reject a symbol without a name.
fn name(item: &OutlineItem) -> String {
    if item.name.trim().is_empty() { "(no name)".to_owned() } else { item.name.to_string() }
}
