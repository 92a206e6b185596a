//! `textDocument/prepareCallHierarchy`, `callHierarchy/incomingCalls` and `outgoingCalls`

use tower_lsp::lsp_types::*;
use val3_ide::CallItem;

use crate::snapshot::{Refusal, Snapshot};

pub(crate) fn prepare(
    snapshot: &Snapshot,
    params: &CallHierarchyPrepareParams,
) -> Result<Option<Vec<CallHierarchyItem>>, Refusal> {
    let at = snapshot.position(&params.text_document_position_params)?;
    Ok(val3_ide::call_item(snapshot.db(), at).map(|found| vec![item(snapshot, &found, false)]))
}

pub(crate) fn incoming(
    snapshot: &Snapshot,
    params: &CallHierarchyIncomingCallsParams,
) -> Result<Option<Vec<CallHierarchyIncomingCall>>, Refusal> {
    let file = snapshot.file(&params.item.uri)?;
    let calls = val3_ide::incoming_calls(snapshot.db(), file).into_iter().map(|call| {
        let lines = snapshot.lines(call.item.file);
        let from_ranges = call.places.iter().map(|place| lines.range(*place)).collect();
        CallHierarchyIncomingCall { from: item(snapshot, &call.item, call.in_task), from_ranges }
    });
    Ok(Some(calls.collect()))
}

pub(crate) fn outgoing(
    snapshot: &Snapshot,
    params: &CallHierarchyOutgoingCallsParams,
) -> Result<Option<Vec<CallHierarchyOutgoingCall>>, Refusal> {
    let file = snapshot.file(&params.item.uri)?;
    let lines = snapshot.lines(file);
    let calls = val3_ide::outgoing_calls(snapshot.db(), file).into_iter().map(|call| {
        let from_ranges = call.places.iter().map(|place| lines.range(*place)).collect();
        CallHierarchyOutgoingCall { to: item(snapshot, &call.item, call.in_task), from_ranges }
    });
    Ok(Some(calls.collect()))
}

fn item(snapshot: &Snapshot, found: &CallItem, in_task: bool) -> CallHierarchyItem {
    let outline = val3_ide::outline(snapshot.db(), found.file);
    let whole = outline.iter().find(|item| item.name_range == found.range).map_or(found.range, |item| item.range);
    let task = if in_task { ", in a task of its own" } else { "" };
    CallHierarchyItem {
        name: found.name.to_string(),
        kind: SymbolKind::FUNCTION,
        tags: None,
        detail: Some(format!("{}{task}", found.project)),
        uri: snapshot.uri(found.file),
        range: snapshot.range(found.file, whole),
        selection_range: snapshot.range(found.file, found.range),
        data: None,
    }
}
