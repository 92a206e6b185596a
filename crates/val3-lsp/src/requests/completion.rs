//! `textDocument/completion` and `completionItem/resolve`

use serde::{Deserialize, Serialize};
use tower_lsp::lsp_types::*;
use val3_ide::Completion;

use crate::convert::{completion_kind, edits, markdown};
use crate::snapshot::{Refusal, Snapshot};

/// Where an item was offered, so that its documentation can be found later.
#[derive(Serialize, Deserialize)]
struct Offered {
    uri: Url,
    position: Position,
}

pub(crate) fn completion(
    snapshot: &Snapshot,
    params: &CompletionParams,
) -> Result<Option<CompletionResponse>, Refusal> {
    let place = &params.text_document_position;
    let at = snapshot.position(place)?;
    let offered = Offered { uri: place.text_document.uri.clone(), position: place.position };
    let data = serde_json::to_value(offered).ok();
    let found = val3_ide::completions(snapshot.db(), at);
    let items = found.iter().enumerate().map(|(rank, found)| item(snapshot, at.file, rank, found, data.clone()));
    // More letters may fit what few letters left out.
    Ok(Some(CompletionResponse::List(CompletionList { is_incomplete: true, items: items.collect() })))
}

fn item(
    snapshot: &Snapshot,
    file: val3_analysis::db::File,
    rank: usize,
    found: &Completion,
    data: Option<serde_json::Value>,
) -> CompletionItem {
    let is_snippet = found.is_snippet && snapshot.session.client.has_snippets;
    let new_text = if found.is_snippet && !is_snippet { found.label.clone() } else { found.insert.clone() };
    let own = found.additional.iter().filter(|edit| edit.file == file);
    let additional = edits(snapshot, file, own.map(|edit| (edit.range, edit.text.as_str())));
    CompletionItem {
        label: found.label.clone(),
        kind: Some(completion_kind(found.kind)),
        detail: (!found.detail.is_empty()).then(|| found.detail.clone()),
        sort_text: Some(format!("{rank:05}")),
        filter_text: Some(found.label.clone()),
        insert_text_format: Some(if is_snippet { InsertTextFormat::SNIPPET } else { InsertTextFormat::PLAIN_TEXT }),
        text_edit: Some(CompletionTextEdit::Edit(TextEdit { range: snapshot.range(file, found.range), new_text })),
        additional_text_edits: (!additional.is_empty()).then_some(additional),
        data: found.symbol.is_some().then_some(data).flatten(),
        ..CompletionItem::default()
    }
}

pub(crate) fn resolve(snapshot: &Snapshot, item: &CompletionItem) -> Result<CompletionItem, Refusal> {
    let mut item = item.clone();
    let offered = item.data.clone().and_then(|data| serde_json::from_value::<Offered>(data).ok());
    if let Some(text) = offered.and_then(|offered| documentation(snapshot, &offered, &item.label)) {
        item.documentation = Some(Documentation::MarkupContent(markdown(text)));
    }
    Ok(item)
}

/// The text may have changed since; what is offered there now tells what the name stands for.
fn documentation(snapshot: &Snapshot, offered: &Offered, label: &str) -> Option<String> {
    let at = snapshot.position_in(&offered.uri, offered.position).ok()?;
    let project = val3_ide::owner(snapshot.db(), at.file)?;
    let found = val3_ide::completions(snapshot.db(), at);
    let symbol = found.iter().find(|found| found.label == label)?.symbol.as_ref()?;
    val3_ide::documentation(snapshot.db(), project, symbol)
}
