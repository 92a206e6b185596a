//! `textDocument/documentHighlight`

use tower_lsp::lsp_types::{DocumentHighlight, DocumentHighlightKind, DocumentHighlightParams};

use crate::snapshot::{Refusal, Snapshot};

pub(crate) fn document_highlight(
    snapshot: &Snapshot,
    params: &DocumentHighlightParams,
) -> Result<Option<Vec<DocumentHighlight>>, Refusal> {
    let at = snapshot.position(&params.text_document_position_params)?;
    let lines = snapshot.lines(at.file);
    let highlights = val3_ide::highlights(snapshot.db(), at).into_iter().map(|found| DocumentHighlight {
        range: lines.range(found.range),
        kind: Some(if found.is_write { DocumentHighlightKind::WRITE } else { DocumentHighlightKind::READ }),
    });
    Ok(Some(highlights.collect()))
}
