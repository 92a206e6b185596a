//! `textDocument/formatting`, `rangeFormatting` and `onTypeFormatting`

use tower_lsp::lsp_types::*;
use val3_analysis::db::File;
use val3_analysis::items::parse;
use val3_fmt::{Edit, Style};

use crate::convert::edits;
use crate::snapshot::{Refusal, Snapshot};

type Answer = Result<Option<Vec<TextEdit>>, Refusal>;

pub(crate) fn whole(snapshot: &Snapshot, params: &DocumentFormattingParams) -> Answer {
    let file = snapshot.file(&params.text_document.uri)?;
    let style = style(snapshot, &params.options);
    answer(snapshot, file, &val3_fmt::format(file.text(snapshot.db()), parse(snapshot.db(), file), &style))
}

pub(crate) fn range(snapshot: &Snapshot, params: &DocumentRangeFormattingParams) -> Answer {
    let file = snapshot.file(&params.text_document.uri)?;
    lines(snapshot, file, params.range, &params.options)
}

/// The line that was typed, and at the start of a new line also the one before.
pub(crate) fn on_type(snapshot: &Snapshot, params: &DocumentOnTypeFormattingParams) -> Answer {
    let place = &params.text_document_position;
    let file = snapshot.file(&place.text_document.uri)?;
    let line = place.position.line;
    let first = if params.ch == "\n" { line.saturating_sub(1) } else { line };
    let range = Range::new(Position::new(first, 0), Position::new(line, u32::MAX));
    lines(snapshot, file, range, &params.options)
}

fn lines(snapshot: &Snapshot, file: File, range: Range, options: &FormattingOptions) -> Answer {
    let style = style(snapshot, options);
    let range = snapshot.lines(file).text_range(range);
    answer(snapshot, file, &val3_fmt::format_range(file.text(snapshot.db()), parse(snapshot.db(), file), &style, range))
}

fn style(snapshot: &Snapshot, options: &FormattingOptions) -> Style {
    snapshot.session.options.style(options.tab_size, options.insert_spaces)
}

fn answer(snapshot: &Snapshot, file: File, found: &[Edit]) -> Answer {
    Ok(Some(edits(snapshot, file, found.iter().map(|edit| (edit.range, edit.text.as_str())))))
}
