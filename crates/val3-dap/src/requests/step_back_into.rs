//! `val3/stepBackInto`: returns to the previous line, which may be in a called program.

use val3_debug::StepKind;

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::request::{DebugRequest, Empty, ThreadArguments};
use crate::session::DebugSession;

/// The request `val3/stepBackInto`.
pub(crate) enum StepBackInto {}

impl DebugRequest for StepBackInto {
    const COMMAND: &'static str = "val3/stepBackInto";
    type Arguments = ThreadArguments;
    type Body = Empty;

    fn answer(
        session: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        arguments: ThreadArguments,
    ) -> Result<Empty, RequestFailure> {
        session.step_back(arguments.thread_id, StepKind::In, run).map(|()| Empty {})
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use crate::test_client::{MAIN_THREAD, TestClient};

    const CALLS: &str = "num nCount\n\nprogram start()\nbegin\n  call work()\n  nCount=3\n  delay(1)\nend\n\n\
                         program work()\nbegin\n  nCount=1\n  nCount=2\nend\n";

    #[test]
    fn a_step_back_leads_into_and_out_of_a_call() {
        let mut client = TestClient::stopped(CALLS);
        let thread = json!({ "threadId": MAIN_THREAD });
        client.stop_after("next", thread.clone());
        assert_eq!((client.place(), client.value("nCount")), (("main:start()".to_owned(), 6), json!("2")));
        client.stop_after("val3/stepBackInto", thread.clone());
        assert_eq!((client.place(), client.value("nCount")), (("main:work()".to_owned(), 6), json!("1")));
        client.stop_after("stepBack", thread.clone());
        assert_eq!(client.place(), ("main:work()".to_owned(), 5));
        client.stop_after("val3/stepBackOut", thread.clone());
        assert_eq!(client.place(), ("main:start()".to_owned(), 5));
        client.stop_after("next", thread.clone());
        client.stop_after("stepBack", json!({ "threadId": MAIN_THREAD, "granularity": "instruction" }));
        assert_eq!(client.place(), ("main:work()".to_owned(), 6), "as `val3/stepBackInto`");
    }
}
