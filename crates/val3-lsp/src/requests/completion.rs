//! `textDocument/completion` and `completionItem/resolve`

use serde::{Deserialize, Serialize};
use tower_lsp::lsp_types::*;
use val3_analysis::db::File;
use val3_ide::{Completion, CompletionKind, FileEdit, SourceChange};

use super::execute_command::apply;
use crate::convert::{completion_kind, documentation, edits, workspace_edit};
use crate::overlay;
use crate::snapshot::{Refusal, Snapshot};

/// Position of the completion, for a later lookup of the documentation.
#[derive(Serialize, Deserialize)]
struct CompletionItemData {
    uri: Url,
    position: Position,
}

pub(crate) fn completion(
    snapshot: &Snapshot,
    params: &CompletionParams,
) -> Result<Option<CompletionResponse>, Refusal> {
    let place = &params.text_document_position;
    let at = snapshot.position(place)?;
    if is_after_blank(params) && !val3_ide::completes_after_blank(snapshot.db(), at) {
        return Ok(None);
    }
    let offered = CompletionItemData { uri: place.text_document.uri.clone(), position: place.position };
    let data = serde_json::to_value(offered).ok();
    let mut found = val3_ide::completions(snapshot.db(), at);
    found.extend(val3_ide::mesh_completions(snapshot.db(), &overlay::files_of(snapshot), at));
    let items = found.iter().enumerate().filter_map(|(rank, found)| item(snapshot, at.file, rank, found, data.clone()));
    // The list is incomplete, because further letters may match items that were omitted for short input.
    Ok(Some(CompletionResponse::List(CompletionList { is_incomplete: true, items: items.collect() })))
}

/// Whether a typed space triggered the completion.
fn is_after_blank(params: &CompletionParams) -> bool {
    let context = params.context.as_ref();
    context.and_then(|context| context.trigger_character.as_deref()) == Some(" ")
}

/// Converts an item. `None` if the item also changes another file and the client does not support such edits, because
/// applying only half of the edits would break the code.
fn item(
    snapshot: &Snapshot,
    file: File,
    rank: usize,
    found: &Completion,
    data: Option<serde_json::Value>,
) -> Option<CompletionItem> {
    let is_snippet = found.is_snippet && snapshot.session.client.has_snippets;
    let new_text = if is_snippet { &found.insert } else { &found.plain }.clone();
    let (own, elsewhere): (Vec<&FileEdit>, Vec<&FileEdit>) =
        found.additional.iter().partition(|edit| edit.file == file);
    let command = match elsewhere.is_empty() {
        true => None,
        false => Some(declaring(snapshot, &elsewhere)?),
    };
    let additional = edits(snapshot, file, own.iter().map(|edit| (edit.range, edit.text.as_str())));
    Some(CompletionItem {
        label: found.label.clone(),
        kind: Some(completion_kind(found.kind)),
        detail: (!found.detail.is_empty()).then(|| found.detail.clone()),
        sort_text: Some(format!("{rank:05}")),
        filter_text: Some(filter_text(found)),
        insert_text_format: Some(if is_snippet { InsertTextFormat::SNIPPET } else { InsertTextFormat::PLAIN_TEXT }),
        text_edit: Some(CompletionTextEdit::Edit(TextEdit { range: snapshot.range(file, found.range), new_text })),
        additional_text_edits: (!additional.is_empty()).then_some(additional),
        command,
        commit_characters: commit_characters(snapshot, found),
        data: data.filter(|_| has_documentation(found)),
        ..CompletionItem::default()
    })
}

fn commit_characters(snapshot: &Snapshot, found: &Completion) -> Option<Vec<String>> {
    let is_taken_by_some = snapshot.session.client.has_commit_characters && !found.commit.is_empty();
    is_taken_by_some.then(|| found.commit.iter().map(char::to_string).collect())
}

/// Whether documentation is available for the item.
fn has_documentation(found: &Completion) -> bool {
    found.symbol.is_some() || found.documentation.is_some() || found.kind == CompletionKind::Keyword
}

/// Text that the editor filters by. Editors sort exact matches first. An item that declares a new name always matches
/// exactly, so a trailing space keeps it below existing names with the same prefix.
fn filter_text(found: &Completion) -> String {
    if found.additional.is_empty() { found.label.clone() } else { format!("{} ", found.label) }
}

/// Command by which the client applies the item's edits in other files after it was accepted.
fn declaring(snapshot: &Snapshot, elsewhere: &[&FileEdit]) -> Option<Command> {
    let edits = elsewhere.iter().copied().cloned().collect();
    let change = SourceChange { edits, ..SourceChange::default() };
    apply(snapshot, "Declare it".to_owned(), workspace_edit(snapshot, &change).ok()?)
}

pub(crate) fn resolve(snapshot: &Snapshot, item: &CompletionItem) -> Result<CompletionItem, Refusal> {
    let mut item = item.clone();
    let offered = item.data.clone().and_then(|data| serde_json::from_value::<CompletionItemData>(data).ok());
    if let Some(text) = offered.and_then(|offered| page(snapshot, &offered, &item)) {
        let format = snapshot.session.client.formats.completions;
        item.documentation = Some(documentation(format, text));
    }
    Ok(item)
}

/// Documentation for an item. The text may have changed since the completion, so the completions at the position are
/// computed again.
fn page(snapshot: &Snapshot, offered: &CompletionItemData, item: &CompletionItem) -> Option<String> {
    let at = snapshot.position_in(&offered.uri, offered.position).ok()?;
    let project = val3_ide::owner(snapshot.db(), at.file)?;
    let found = val3_ide::completions(snapshot.db(), at);
    let completion = found.iter().find(|found| is_same(found, item))?;
    val3_ide::completion_documentation(snapshot.db(), project, completion)
}

/// Whether the item was created from an equal completion.
fn is_same(completion: &Completion, item: &CompletionItem) -> bool {
    completion.label == item.label && item.kind.is_none_or(|kind| kind == completion_kind(completion.kind))
}
