//! `val3/subscribe`: selects the events `val3/…` that are sent. Omitted properties are unchanged.

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::live::SubscribeArguments;
use crate::request::{DebugRequest, Empty};
use crate::session::DebugSession;

/// The request `val3/subscribe`.
pub(crate) enum Subscribe {}

impl DebugRequest for Subscribe {
    const COMMAND: &'static str = "val3/subscribe";
    type Arguments = SubscribeArguments;
    type Body = Empty;

    fn answer(
        session: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        arguments: SubscribeArguments,
    ) -> Result<Empty, RequestFailure> {
        session.subscriptions.subscribe(&arguments, run)?;
        Ok(Empty {})
    }
}

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};

    use crate::test_client::{EMPTY, MAIN_THREAD, TestClient, WORKER};

    #[test]
    fn a_page_that_is_opened_after_a_fault_shows_it() {
        let mut client = TestClient::stopped("num nA\n\nprogram start()\nbegin\n  nA=1\n  nA=1/(nA-1)\nend\n");
        client.stop_after("continue", json!({ "threadId": MAIN_THREAD }));
        let errors = |client: &mut TestClient| {
            let events = client.events("val3/subscribe", json!({ "view": true }));
            let messages = events.iter().filter_map(|(_, body)| body["messages"].as_array()).flatten();
            let events = messages.filter_map(|message| message["events"].as_array()).flatten();
            events.filter(|event| event["kind"] == "error").count()
        };
        assert_eq!(errors(&mut client), 1);
        client.stop_after("stepBack", json!({ "threadId": MAIN_THREAD }));
        client.body("val3/subscribe", json!({ "view": false }));
        assert_eq!(errors(&mut client), 0);
    }

    #[test]
    fn subscriptions_have_types() {
        let mut client = TestClient::stopped(EMPTY);
        for arguments in [json!({}), json!({ "motion": 0.1, "io": true }), json!({ "motion": false, "userPage": true })]
        {
            assert_eq!(client.body("val3/subscribe", arguments), json!({}));
        }
        for (name, value) in [("motion", json!(-1)), ("io", json!(1)), ("pose", json!(true))] {
            let reason = client.failure("val3/subscribe", json!({ name: value }));
            assert!(reason.contains(&format!("`{name}`")), "{reason}");
        }
    }

    /// The field `isStopped` of the messages `clock` in events.
    fn stops(events: &[(String, Value)]) -> Vec<bool> {
        let messages = events.iter().filter(|(event, _)| event == "val3/view");
        let messages = messages.flat_map(|(_, body)| body["messages"].as_array().unwrap());
        let clocks = messages.filter(|message| message["kind"] == "clock");
        clocks.map(|clock| clock["isStopped"].as_bool().unwrap()).collect()
    }

    #[test]
    fn a_page_shows_the_code_of_a_failed_line() {
        let listing = "num nCount\n\nprogram start()\nbegin\n  nCount=1/nCount\n  delay(1)\nend\n";
        let mut client = TestClient::stopped(listing);
        client.body("val3/subscribe", json!({ "view": true }));
        let events = client.events("continue", json!({ "threadId": MAIN_THREAD })).into_iter().chain(client.run());
        let views: Vec<Value> = events.filter(|(event, _)| event == "val3/view").map(|(_, body)| body).collect();
        let messages = views.iter().flat_map(|body| body["messages"].as_array().unwrap());
        let events = messages.filter(|message| message["kind"] == "events");
        let events = events.flat_map(|message| message["events"].as_array().unwrap());
        let errors: Vec<&Value> = events.filter(|event| event["kind"] == "error").collect();
        assert_eq!(errors.len(), 1, "{views:?}");
        assert_eq!(errors[0]["lineCode"], "start.pgx 5");
    }

    #[test]
    fn a_page_learns_that_the_run_is_stopped() {
        let mut client = TestClient::stopped(WORKER);
        assert_eq!(stops(&client.events("val3/subscribe", json!({ "view": true }))), [true]);
        assert_eq!(stops(&client.events("threads", json!({}))), [false; 0], "only changes are sent");
        assert_eq!(stops(&client.events("next", json!({ "threadId": MAIN_THREAD }))), [false]);
        assert_eq!(stops(&client.run()), [true]);
    }
}
