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
        // The console may contain several lines; the column refers to this line.
        let number = arguments.line.map_or(0, |line| session.conventions.row(line).saturating_sub(1)) as usize;
        let text = arguments.text.lines().nth(number).unwrap_or_default();
        let at = byte_offset(text, session.conventions.offset(arguments.column));
        let completions = run.evaluator.completions(&run.debugger.controller, context, text, at);
        let completions = completions.map_err(RequestFailure::rejected)?;
        Ok(CompletionsResponse { targets: completions.into_iter().map(|completion| item(completion, text)).collect() })
    }
}

/// Converts a completion in this line of the console. `start` counts from 0 for every client, because VS Code expects
/// this although it announces columns that start at 1.
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

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};

    use crate::test_client::{COUNTER, TestClient};

    /// Returns the completions of the global variable.
    fn counters(client: &mut TestClient, arguments: Value) -> Vec<Value> {
        let body = client.body("completions", arguments);
        let targets = body["targets"].as_array().unwrap().iter();
        targets.filter(|target| target["label"] == "nCount").cloned().collect()
    }

    #[test]
    fn a_completion_replaces_the_beginning_of_a_name() {
        let mut client = TestClient::stopped(COUNTER);
        let (_, frame) = client.thread_and_frame();
        let expected = json!({ "label": "nCount", "detail": "num", "text": "nCount", "start": 2, "length": 3 });
        let arguments = json!({ "frameId": frame, "text": "1+nCo", "column": 6 });
        assert_eq!(counters(&mut client, arguments), [expected]);
    }

    #[test]
    fn columns_are_counted_as_the_client_counts_them() {
        let mut client = TestClient::stopped(COUNTER).counting_from_0();
        let item = &counters(&mut client, json!({ "text": "1+nCo", "column": 5 }))[0];
        assert_eq!((&item["start"], &item["length"]), (&json!(2), &json!(3)));
    }

    #[test]
    fn columns_are_utf_16_units() {
        let mut client = TestClient::stopped(COUNTER);
        let item = &counters(&mut client, json!({ "text": "\"\u{1f600}\"+nCo", "column": 9 }))[0];
        assert_eq!((&item["start"], &item["length"]), (&json!(5), &json!(3)));
    }

    #[test]
    fn a_column_belongs_to_the_line() {
        let mut client = TestClient::stopped(COUNTER);
        let item = &counters(&mut client, json!({ "text": "1+1\nnCo", "line": 2, "column": 4 }))[0];
        assert_eq!((&item["start"], &item["length"]), (&json!(0), &json!(3)));
        let beyond = json!({ "text": "nCo", "line": 2, "column": 4 });
        assert_eq!(counters(&mut client, beyond)[0]["length"], 0);
    }

    #[test]
    fn a_stale_stack_frame_is_rejected() {
        let mut client = TestClient::stopped(COUNTER);
        let reason = client.failure("completions", json!({ "frameId": 99, "text": "n", "column": 2 }));
        assert_eq!(reason, "this belongs to a stop that is over");
    }
}
