//! `continue`: resumes all tasks, or one.

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::protocol::{ContinueArguments, ContinueResponse};
use crate::request::DebugRequest;
use crate::session::DebugSession;

/// The request `continue`.
pub(crate) enum Continue {}

impl DebugRequest for Continue {
    const COMMAND: &'static str = "continue";
    type Arguments = ContinueArguments;
    type Body = ContinueResponse;

    fn answer(
        session: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        arguments: ContinueArguments,
    ) -> Result<ContinueResponse, RequestFailure> {
        let is_one = session.release(arguments.thread_id, arguments.single_thread, run)?;
        Ok(ContinueResponse { all_threads_continued: Some(!is_one) })
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use crate::test_client::{EMPTY, TestClient};

    #[test]
    fn a_running_program_cannot_be_resumed() {
        let mut client = TestClient::stopped(EMPTY);
        let (thread, _) = client.thread_and_frame();
        assert_eq!(client.body("continue", json!({ "threadId": thread }))["allThreadsContinued"], true);
        assert_eq!(client.failure("continue", json!({ "threadId": thread })), "notStopped");
    }
}
