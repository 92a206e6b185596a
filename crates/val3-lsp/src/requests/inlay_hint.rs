//! `textDocument/inlayHint`

use tower_lsp::lsp_types::{InlayHint, InlayHintKind, InlayHintLabel, InlayHintParams, InlayHintTooltip};

use crate::snapshot::{Refusal, Snapshot};

pub(crate) fn inlay_hint(snapshot: &Snapshot, params: &InlayHintParams) -> Result<Option<Vec<InlayHint>>, Refusal> {
    let file = snapshot.file(&params.text_document.uri)?;
    let lines = snapshot.lines(file);
    let settings = snapshot.session.options.inlay_hints.settings();
    let found = val3_ide::inlay_hints(snapshot.db(), file, lines.text_range(params.range), &settings);
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
    Ok(Some(found.into_iter().map(hint).collect()))
}

/// The protocol has two kinds alone.
fn kind(kind: val3_ide::InlayHintKind) -> Option<InlayHintKind> {
    match kind {
        val3_ide::InlayHintKind::Parameter => Some(InlayHintKind::PARAMETER),
        val3_ide::InlayHintKind::Type => Some(InlayHintKind::TYPE),
        val3_ide::InlayHintKind::Frame | val3_ide::InlayHintKind::Blend => None,
    }
}
