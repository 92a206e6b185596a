//! `textDocument/inlayHint`

use tower_lsp::lsp_types::{InlayHint, InlayHintKind, InlayHintLabel, InlayHintParams, InlayHintTooltip, Range, Url};

use crate::display_cache::Fingerprint;
use crate::snapshot::{Refusal, Snapshot};

pub(crate) fn inlay_hint(snapshot: &Snapshot, params: &InlayHintParams) -> Result<Option<Vec<InlayHint>>, Refusal> {
    let (uri, range) = (&params.text_document.uri, params.range);
    let hints = hints(snapshot, uri, range)?;
    if let Some(document) = snapshot.documents.get(uri).filter(|_| snapshot.session.client.refreshes_hints) {
        snapshot.documents.display_cache().entry(uri, document.version).hints = Some((range, Fingerprint::of(&hints)));
    }
    Ok(Some(hints))
}

/// The current hints of a range.
pub(crate) fn current_hints(snapshot: &Snapshot, uri: &Url, range: Range) -> Option<Fingerprint> {
    hints(snapshot, uri, range).ok().map(|hints| Fingerprint::of(&hints))
}

fn hints(snapshot: &Snapshot, uri: &Url, range: Range) -> Result<Vec<InlayHint>, Refusal> {
    let file = snapshot.file(uri)?;
    let lines = snapshot.lines(file);
    let settings = snapshot.session.options.inlay_hints.settings();
    let found = val3_ide::inlay_hints(snapshot.db(), file, lines.text_range(range), &settings);
    let hint = |found: val3_ide::InlayHint| InlayHint {
        position: lines.position(found.offset),
        label: InlayHintLabel::String(found.label),
        kind: kind(found.kind),
        text_edits: None,
        tooltip: (!found.tooltip.is_empty()).then_some(InlayHintTooltip::String(found.tooltip)),
        padding_left: Some(!found.kind.is_before()),
        padding_right: Some(found.kind.is_before()),
        data: None,
    };
    Ok(found.into_iter().map(hint).collect())
}

/// The protocol has two kinds alone.
fn kind(kind: val3_ide::InlayHintKind) -> Option<InlayHintKind> {
    match kind {
        val3_ide::InlayHintKind::Parameter => Some(InlayHintKind::PARAMETER),
        val3_ide::InlayHintKind::Type => Some(InlayHintKind::TYPE),
        val3_ide::InlayHintKind::Frame | val3_ide::InlayHintKind::Blend => None,
    }
}
