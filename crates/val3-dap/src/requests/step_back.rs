//! `stepBack`: returns to the previous line.

use val3_debug::StepKind;

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::protocol::{StepBackArguments, SteppingGranularity};
use crate::request::DebugRequest;
use crate::session::DebugSession;

/// The request `stepBack`.
pub(crate) enum StepBack {}

impl DebugRequest for StepBack {
    const COMMAND: &'static str = "stepBack";
    type Arguments = StepBackArguments;
    type Body = ();

    fn answer(
        session: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        arguments: StepBackArguments,
    ) -> Result<(), RequestFailure> {
        let kind = match arguments.granularity {
            Some(SteppingGranularity::Instruction) => StepKind::In,
            _ => StepKind::Over,
        };
        session.step_back(arguments.thread_id, kind, run)
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use crate::message::MessageContent;
    use crate::test_client::{EMPTY, TestClient};

    #[test]
    fn a_step_back_at_the_beginning_stops_there() {
        let mut client = TestClient::stopped(EMPTY);
        let (thread, _) = client.thread_and_frame();
        let messages = client.exchange("stepBack", json!({ "threadId": thread }));
        let is_stop =
            |content: &MessageContent| matches!(content, MessageContent::Event { event, .. } if event == "stopped");
        assert!(messages.iter().any(is_stop), "{messages:?}");
    }
}
