//! `cancel`: has no effect of its own. Requests in progress find a pending `cancel` in the queue of messages, so when
//! it is handled in its turn, no request is in progress. Long requests also reject cancelled requests that wait for them.

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::protocol::CancelArguments;
use crate::request::DebugRequest;
use crate::session::DebugSession;

/// The request `cancel`.
pub(crate) enum Cancel {}

impl DebugRequest for Cancel {
    const COMMAND: &'static str = "cancel";
    type Arguments = CancelArguments;
    type Body = ();

    fn answer(_: &mut DebugSession, _: &mut DebuggedRun<'_>, _: CancelArguments) -> Result<(), RequestFailure> {
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use crate::message::MessageContent;
    use crate::test_client::{COUNTER, EMPTY, TestClient};

    #[test]
    fn a_request_that_is_not_handled_yet_is_cancelled() {
        let mut client = TestClient::stopped(EMPTY);
        client.send(7, "threads", json!({}));
        let messages = client.exchange("cancel", json!({ "requestId": 7 }));
        let [cancelled, cancel] = &messages[..] else { panic!("{messages:?}") };
        let MessageContent::Response { request_seq: 7, success: false, message, .. } = cancelled else {
            panic!("{cancelled:?}")
        };
        assert_eq!(message.as_deref(), Some("cancelled"));
        assert_eq!(*cancel, MessageContent::answer(1, "cancel", None));
    }

    #[test]
    fn a_waiting_request_is_cancelled_while_another_one_is_executed() {
        let mut client = TestClient::stopped(COUNTER);
        let long = "do\n  nCount=nCount+1\nuntil nCount>200000";
        client.send(7, "evaluate", json!({ "expression": long, "context": "repl" }));
        client.send(8, "threads", json!({}));
        let messages = client.exchange("cancel", json!({ "requestId": 8 })).into_iter();
        let responses = messages.filter_map(|content| match content {
            MessageContent::Response { request_seq, success, .. } => Some((request_seq, success)),
            MessageContent::Request { .. } | MessageContent::Event { .. } => None,
        });
        assert_eq!(responses.collect::<Vec<_>>(), [(8, false), (1, true), (7, true)]);
        assert_eq!(client.value("nCount"), "200001");
    }

    #[test]
    fn other_requests_are_executed() {
        let mut client = TestClient::stopped(EMPTY);
        client.send(7, "configurationDone", json!({}));
        let messages = client.exchange("cancel", json!({ "requestId": 6 }));
        assert_eq!(
            messages,
            [MessageContent::answer(7, "configurationDone", None), MessageContent::answer(1, "cancel", None)]
        );
    }

    #[test]
    fn a_request_id_is_a_number() {
        let mut client = TestClient::stopped(EMPTY);
        let reason = client.failure("cancel", json!({ "requestId": "7" }));
        assert_eq!(reason, "the arguments of `cancel` are wrong: invalid type: string \"7\", expected i32");
    }
}
