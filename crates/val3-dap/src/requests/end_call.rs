//! `val3/endCall`: ends a call of the debug console that has stopped in a called program.

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::request::{DebugRequest, Empty, ThreadArguments};
use crate::session::DebugSession;

/// The request `val3/endCall`.
pub(crate) enum EndCall {}

impl DebugRequest for EndCall {
    const COMMAND: &'static str = "val3/endCall";
    type Arguments = ThreadArguments;
    type Body = Empty;

    fn answer(
        session: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        arguments: ThreadArguments,
    ) -> Result<Empty, RequestFailure> {
        session.end_call(arguments.thread_id, run).map(|()| Empty {})
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use crate::test_client::{CALLER, MAIN_THREAD, TestClient, source};

    #[test]
    fn the_task_is_where_it_was_before_the_call() {
        let mut client = TestClient::stopped(CALLER);
        client.body("setBreakpoints", json!({ "source": source("work"), "breakpoints": [{ "line": 5 }] }));
        client.console("call work()");
        assert_eq!(client.place(), ("main:work()".to_owned(), 5));
        let stop = client.stop_after("val3/endCall", json!({ "threadId": MAIN_THREAD }));
        assert_eq!(stop["description"], "Paused after the call from the debug console");
        assert_eq!(client.place(), ("main:start()".to_owned(), 5));
    }

    #[test]
    fn without_a_call_the_request_is_rejected() {
        let mut client = TestClient::stopped(CALLER);
        let reason = client.failure("val3/endCall", json!({ "threadId": MAIN_THREAD }));
        assert_eq!(reason, "the debug console has called no program in this task");
    }
}
