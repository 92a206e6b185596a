//! `textDocument/inlineValue`

use tower_lsp::lsp_types::request::Request;
use tower_lsp::lsp_types::{InlineValue, InlineValueEvaluatableExpression, InlineValueParams, Position, Range};

use crate::snapshot::{Refusal, Snapshot};

/// The request. The type in lsp-types has only one value as its result.
pub(crate) enum InlineValues {}

impl Request for InlineValues {
    type Params = InlineValueParams;
    type Result = Option<Vec<InlineValue>>;
    const METHOD: &'static str = "textDocument/inlineValue";
}

/// Variables on the visible lines, up to the line at which the debugger has stopped. Later lines have not been
/// executed, so their values would be wrong.
pub(crate) fn inline_value(
    snapshot: &Snapshot,
    params: &InlineValueParams,
) -> Result<Option<Vec<InlineValue>>, Refusal> {
    let file = snapshot.file(&params.text_document.uri)?;
    let lines = snapshot.lines(file);
    let stopped = params.context.stopped_location.end.line;
    let last = params.range.end.min(Position { line: stopped, character: u32::MAX });
    let within = lines.text_range(Range { start: params.range.start.min(last), end: last });
    let values = val3_ide::inline_values(snapshot.db(), file, within).into_iter().map(|found| {
        let (range, expression) = (lines.range(found.range), Some(found.expression));
        InlineValue::EvaluatableExpression(InlineValueEvaluatableExpression { range, expression })
    });
    Ok(Some(values.collect()))
}
