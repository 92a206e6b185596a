//! `textDocument/inlayHint` and `inlayHint/resolve`

use serde::{Deserialize, Serialize};
use serde_json::Value;
use tower_lsp::lsp_types::{
    InlayHint, InlayHintKind, InlayHintLabel, InlayHintLabelPart, InlayHintParams, InlayHintTooltip, Position, Range,
    Url,
};

use crate::display_cache::Fingerprint;
use crate::snapshot::{Refusal, Snapshot};

/// Position of a hint in the file. A client that shows a code view displays the hint at another position.
#[derive(Serialize, Deserialize)]
struct HintOrigin {
    uri: Url,
    position: Position,
}

pub(crate) fn inlay_hint(snapshot: &Snapshot, params: &InlayHintParams) -> Result<Option<Vec<InlayHint>>, Refusal> {
    let (uri, range) = (&params.text_document.uri, params.range);
    let hints = hints(snapshot, uri, range)?;
    if let Some(document) = snapshot.documents.get(uri).filter(|_| snapshot.session.client.refreshes_hints) {
        snapshot.documents.display_cache().entry(uri, document.version).hints = Some((range, Fingerprint::of(&hints)));
    }
    Ok(Some(hints))
}

/// Fingerprint of the current hints in a range.
pub(crate) fn current_hints(snapshot: &Snapshot, uri: &Url, range: Range) -> Option<Fingerprint> {
    hints(snapshot, uri, range).ok().map(|hints| Fingerprint::of(&hints))
}

fn hints(snapshot: &Snapshot, uri: &Url, range: Range) -> Result<Vec<InlayHint>, Refusal> {
    let file = snapshot.file(uri)?;
    let lines = snapshot.lines(file);
    let settings = snapshot.session.options.inlay_hints.settings();
    let found = val3_ide::inlay_hints(snapshot.db(), file, lines.text_range(range), &settings);
    let hints = found.into_iter().map(|found| InlayHint {
        position: lines.position(found.offset),
        data: origin(snapshot, &found, uri, lines.position(found.offset)),
        label: label(snapshot, found.label),
        kind: kind(found.kind),
        text_edits: None,
        tooltip: (!found.tooltip.is_empty()).then_some(InlayHintTooltip::String(found.tooltip)),
        padding_left: Some(!found.kind.is_before()),
        padding_right: Some(found.kind.is_before()),
    });
    Ok(hints.collect())
}

fn origin(snapshot: &Snapshot, found: &val3_ide::InlayHint, uri: &Url, position: Position) -> Option<Value> {
    let leads_on = snapshot.session.client.resolves_hints && found.symbol.is_some();
    leads_on.then(|| serde_json::to_value(HintOrigin { uri: uri.clone(), position }).ok())?
}

/// Label of a hint. Only label parts can have a location, which is resolved later.
fn label(snapshot: &Snapshot, value: String) -> InlayHintLabel {
    match snapshot.session.client.resolves_hints {
        true => InlayHintLabel::LabelParts(vec![InlayHintLabelPart { value, ..InlayHintLabelPart::default() }]),
        false => InlayHintLabel::String(value),
    }
}

/// Adds the location of the declaration from which the hint is derived. A stale hint keeps its label.
pub(crate) fn resolve(snapshot: &Snapshot, hint: &InlayHint) -> Result<InlayHint, Refusal> {
    let mut hint = hint.clone();
    let origin = hint.data.clone().and_then(|data| serde_json::from_value::<HintOrigin>(data).ok());
    if let (Some(origin), InlayHintLabel::LabelParts(parts)) = (origin, &mut hint.label) {
        let at = snapshot.position_in(&origin.uri, origin.position)?;
        let settings = snapshot.session.options.inlay_hints.settings();
        for part in parts {
            let target = val3_ide::inlay_hint_target(snapshot.db(), at, &part.value, &settings);
            part.location = target.map(|target| snapshot.location(target));
        }
    }
    Ok(hint)
}

/// Hint kind in the protocol, which has only two.
fn kind(kind: val3_ide::InlayHintKind) -> Option<InlayHintKind> {
    match kind {
        val3_ide::InlayHintKind::Parameter => Some(InlayHintKind::PARAMETER),
        val3_ide::InlayHintKind::Type => Some(InlayHintKind::TYPE),
        val3_ide::InlayHintKind::Frame | val3_ide::InlayHintKind::Blend => None,
    }
}
