//! `textDocument/foldingRange`

use tower_lsp::lsp_types::{FoldingRange, FoldingRangeParams};

use crate::convert::fold_kind;
use crate::snapshot::{Refusal, Snapshot};

pub(crate) fn folding_range(
    snapshot: &Snapshot,
    params: &FoldingRangeParams,
) -> Result<Option<Vec<FoldingRange>>, Refusal> {
    let file = snapshot.file(&params.text_document.uri)?;
    let lines = snapshot.lines(file);
    let whole_lines = snapshot.session.client.folds_lines;
    let folds = val3_ide::folds(snapshot.db(), file).into_iter().map(|fold| {
        let range = lines.range(fold.range);
        FoldingRange {
            start_line: range.start.line,
            start_character: (!whole_lines).then_some(range.start.character),
            end_line: range.end.line,
            end_character: (!whole_lines).then_some(range.end.character),
            kind: fold_kind(fold.kind),
            collapsed_text: None,
        }
    });
    Ok(Some(folds.filter(|fold| fold.start_line < fold.end_line).collect()))
}
