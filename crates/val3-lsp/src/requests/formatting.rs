//! `textDocument/formatting`, `rangeFormatting` and `onTypeFormatting`
//!
//! The client's options are ignored: `val3.toml` and `.editorconfig` define the format for all editors and for `val3
//! fmt`.

use tower_lsp::lsp_types::*;
use val3_analysis::db::File;
use val3_config::CodeLayout;
use val3_ide::FileEdit;

use crate::convert::edits;
use crate::overlay;
use crate::snapshot::{Refusal, Snapshot};

type FormattingResult = Result<Option<Vec<TextEdit>>, Refusal>;

pub(crate) fn whole(snapshot: &Snapshot, params: &DocumentFormattingParams) -> FormattingResult {
    let file = snapshot.file(&params.text_document.uri)?;
    answer(snapshot, file, &val3_ide::format_file(snapshot.db(), file, &style(snapshot, file)?))
}

pub(crate) fn range(snapshot: &Snapshot, params: &DocumentRangeFormattingParams) -> FormattingResult {
    let file = snapshot.file(&params.text_document.uri)?;
    let range = snapshot.lines(file).text_range(params.range);
    answer(snapshot, file, &val3_ide::format_range(snapshot.db(), file, range, &style(snapshot, file)?))
}

pub(crate) fn on_type(snapshot: &Snapshot, params: &DocumentOnTypeFormattingParams) -> FormattingResult {
    let at = snapshot.position(&params.text_document_position)?;
    let Some(typed) = params.ch.chars().next_back() else { return Ok(None) };
    answer(snapshot, at.file, &val3_ide::format_on_type(snapshot.db(), at, typed, &style(snapshot, at.file)?))
}

fn style(snapshot: &Snapshot, file: File) -> Result<val3_ide::CodeStyle, Refusal> {
    let config = val3_ide::owner(snapshot.db(), file).and_then(|project| project.config(snapshot.db()));
    let usual = CodeLayout::default();
    let format = config.map_or(&usual, |config| &config.format);
    let style = val3_ide::style(&overlay::files(&snapshot.documents, &[]), format, file.path(snapshot.db()));
    style.map_err(|error| Refusal::Because(error.to_string()))
}

fn answer(snapshot: &Snapshot, file: File, found: &[FileEdit]) -> FormattingResult {
    Ok(Some(edits(snapshot, file, found.iter().map(|edit| (edit.range, edit.text.as_str())))))
}
