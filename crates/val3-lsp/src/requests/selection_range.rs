//! `textDocument/selectionRange`

use tower_lsp::lsp_types::{Range, SelectionRange, SelectionRangeParams};

use crate::snapshot::{Refusal, Snapshot};

pub(crate) fn selection_range(
    snapshot: &Snapshot,
    params: &SelectionRangeParams,
) -> Result<Option<Vec<SelectionRange>>, Refusal> {
    let uri = &params.text_document.uri;
    let selections = params.positions.iter().map(|position| {
        let at = snapshot.position_in(uri, *position)?;
        let lines = snapshot.lines(at.file);
        let ranges = val3_ide::selections(snapshot.db(), at).into_iter().map(|range| lines.range(range));
        // The protocol requires a selection for each position, so the fallback is an empty one.
        Ok(nested(ranges.collect()).unwrap_or(SelectionRange { range: Range::new(*position, *position), parent: None }))
    });
    selections.collect::<Result<Vec<_>, _>>().map(Some)
}

/// Nests ranges, given from the innermost to the outermost.
fn nested(ranges: Vec<Range>) -> Option<SelectionRange> {
    let wrap = |parent: Option<SelectionRange>, range| Some(SelectionRange { range, parent: parent.map(Box::new) });
    ranges.into_iter().rev().fold(None, wrap)
}
