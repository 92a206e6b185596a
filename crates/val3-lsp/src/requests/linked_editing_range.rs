//! `textDocument/linkedEditingRange`

use tower_lsp::lsp_types::{LinkedEditingRangeParams, LinkedEditingRanges};

use crate::snapshot::{Refusal, Snapshot};

pub(crate) fn linked_editing_range(
    snapshot: &Snapshot,
    params: &LinkedEditingRangeParams,
) -> Result<Option<LinkedEditingRanges>, Refusal> {
    let at = snapshot.position(&params.text_document_position_params)?;
    let lines = snapshot.lines(at.file);
    let names = val3_ide::linked_names(snapshot.db(), at.file, at.offset);
    let ranges = names.map(|names| names.map(|name| lines.range(name)).to_vec());
    Ok(ranges.map(|ranges| LinkedEditingRanges { ranges, word_pattern: None }))
}
