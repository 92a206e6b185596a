//! `completions`: completions in the debug console.

use val3_session::FrameCompletion;

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::protocol::CompletionItem;
use crate::protocol::{CompletionsArguments, CompletionsResponse};
use crate::request::DebugRequest;
use crate::session::DebugSession;

/// The request `completions`.
pub(crate) enum Completions {}

impl DebugRequest for Completions {
    const COMMAND: &'static str = "completions";
    type Arguments = CompletionsArguments;
    type Body = CompletionsResponse;

    fn answer(
        session: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        arguments: CompletionsArguments,
    ) -> Result<CompletionsResponse, RequestFailure> {
        let context = session.context(arguments.frame_id, run)?;
        // The console may have several lines; the column belongs to this one.
        let number = arguments.line.map_or(0, |line| session.conventions.row(line).saturating_sub(1)) as usize;
        let text = arguments.text.lines().nth(number).unwrap_or_default();
        let at = byte_offset(text, session.conventions.offset(arguments.column));
        let completions = run.evaluator.completions(&run.debugger.controller, context, (text, at));
        let completions = completions.map_err(RequestFailure::rejected)?;
        Ok(CompletionsResponse { targets: completions.into_iter().map(|completion| item(completion, text)).collect() })
    }
}

/// Converts a completion in this line of the console.
fn item(completion: FrameCompletion, text: &str) -> CompletionItem {
    let characters = |byte: usize| text.get(..byte).map_or(0, |before| before.encode_utf16().count());
    let (start, end) = (characters(completion.range.start), characters(completion.range.end));
    CompletionItem {
        label: completion.label,
        detail: Some(completion.detail).filter(|detail| !detail.is_empty()),
        text: Some(completion.insert),
        start: u32::try_from(start).ok(),
        length: u32::try_from(end.saturating_sub(start)).ok(),
        ..CompletionItem::default()
    }
}

/// Returns the byte offset after this number of UTF-16 units.
fn byte_offset(text: &str, units: usize) -> usize {
    let mut count = 0;
    for (at, character) in text.char_indices() {
        if count >= units {
            return at;
        }
        count += character.len_utf16();
    }
    text.len()
}
