//! `stackTrace`: stack frames of a task.

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::protocol::{StackTraceArguments, StackTraceResponse};
use crate::request::DebugRequest;
use crate::session::DebugSession;

/// The request `stackTrace`.
pub(crate) enum StackTrace {}

impl DebugRequest for StackTrace {
    const COMMAND: &'static str = "stackTrace";
    type Arguments = StackTraceArguments;
    type Body = StackTraceResponse;

    fn answer(
        session: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        arguments: StackTraceArguments,
    ) -> Result<StackTraceResponse, RequestFailure> {
        let trace = session.handles.stack_trace(&arguments, &run.debugger.controller, &session.conventions, run.files);
        trace.ok_or(RequestFailure::NoSuchTask)
    }
}

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};

    use crate::test_client::{CALLER, EMPTY, FIRST_LINE, MAIN_THREAD, MODULE, TestClient, source};

    fn frame(id: u32, program: &str) -> Value {
        json!({
            "id": id,
            "name": format!("main:{program}()"),
            "line": FIRST_LINE,
            "column": 1,
            "source": source(program),
            "canRestart": true,
            "moduleId": MODULE,
        })
    }

    /// Returns the client of a run that is stopped in the called program.
    fn client() -> TestClient {
        let mut client = TestClient::stopped(CALLER);
        client.stop_after("stepIn", json!({ "threadId": MAIN_THREAD }));
        client
    }

    #[test]
    fn the_innermost_program_is_the_first_stack_frame() {
        let expected = json!({ "stackFrames": [frame(1, "work"), frame(2, "start")], "totalFrames": 2 });
        assert_eq!(client().body("stackTrace", json!({ "threadId": MAIN_THREAD })), expected);
    }

    #[test]
    fn stack_frames_are_returned_page_by_page() {
        let mut client = client();
        for (start, levels, frames) in
            [(0, 1, vec![frame(1, "work")]), (1, 0, vec![frame(2, "start")]), (2, 1, Vec::new())]
        {
            let arguments = json!({ "threadId": MAIN_THREAD, "startFrame": start, "levels": levels });
            let page = json!({ "stackFrames": frames, "totalFrames": 2 });
            assert_eq!(client.body("stackTrace", arguments), page, "{levels} from {start}");
        }
    }

    #[test]
    fn a_stack_frame_is_named_with_its_line_on_request() {
        let mut client = TestClient::stopped(EMPTY);
        let trace = client.body("stackTrace", json!({ "threadId": MAIN_THREAD, "format": { "line": true } }));
        assert_eq!(trace["stackFrames"][0]["name"], "main:start(), line 5");
    }

    #[test]
    fn lines_and_columns_begin_with_0_if_the_client_counts_so() {
        let mut client = TestClient::stopped(EMPTY).counting_from_0();
        let trace = client.body("stackTrace", json!({ "threadId": MAIN_THREAD }));
        let frame = &trace["stackFrames"][0];
        assert_eq!((&frame["line"], &frame["column"]), (&json!(FIRST_LINE - 1), &json!(0)));
    }

    #[test]
    fn a_stack_frame_belongs_to_a_module() {
        let mut client = TestClient::stopped(EMPTY);
        let module = client.body("modules", json!({}))["modules"][0]["id"].clone();
        let trace = client.body("stackTrace", json!({ "threadId": MAIN_THREAD }));
        assert_eq!(trace["stackFrames"][0]["moduleId"], module);
    }

    #[test]
    fn an_unknown_task_is_rejected() {
        let mut client = TestClient::stopped(EMPTY);
        for thread in [0, 9] {
            let reason = client.failure("stackTrace", json!({ "threadId": thread }));
            assert_eq!(reason, "there is no such task any more");
        }
    }
}
