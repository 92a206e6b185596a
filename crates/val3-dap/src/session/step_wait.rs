//! Notes about steps that wait, because a step over a waiting line does not end before the wait.

use val3_lang::ports::{SECOND, TaskNumber, Time};

use super::DebugSession;
use crate::debugged_run::DebuggedRun;
use crate::protocol::{OutputEvent, OutputEventCategory, StandardEvent};
use crate::stop_event;

/// Controller time after which the client receives a note.
const LONG: Time = SECOND;

/// Wait of a step within a line.
#[derive(Debug, Clone, Copy)]
pub(super) struct StepWait {
    task: TaskNumber,
    /// Controller time at which the wait began.
    since: Time,
    is_noted: bool,
}

impl DebugSession {
    /// Shows once in the debug console what a step waits for, if it waits for a long time.
    pub(super) fn note_step_wait(&mut self, run: &DebuggedRun<'_>) {
        let Some(task) = run.debugger.waiting_step() else {
            self.step_wait = None;
            return;
        };
        let now = run.debugger.controller.now();
        let known = self.step_wait.filter(|wait| wait.task == task);
        let wait = known.unwrap_or(StepWait { task, since: now, is_noted: false });
        let is_long = !wait.is_noted && now.saturating_sub(wait.since) >= LONG;
        self.step_wait = Some(StepWait { is_noted: wait.is_noted || is_long, ..wait });
        if is_long && let Some(text) = stop_event::wait_of(task, &run.debugger.controller) {
            let output = format!("note: the step has not ended yet: {text}\n");
            let category = Some(OutputEventCategory::Console);
            self.client.event(&StandardEvent::Output(OutputEvent { output, category, ..OutputEvent::default() }));
        }
    }
}

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};

    use crate::test_client::{MAIN_THREAD, TestClient};

    fn notes(listing: &str) -> Vec<Value> {
        let mut client = TestClient::stopped(listing);
        client.stop_after("next", json!({ "threadId": MAIN_THREAD }));
        client.events("next", json!({ "threadId": MAIN_THREAD }));
        let outputs = client.run().into_iter().filter(|(event, _)| event == "output");
        outputs.map(|(_, body)| body["output"].clone()).collect()
    }

    #[test]
    fn a_step_that_waits_long_says_what_it_waits_for() {
        let waiting = |seconds: &str| {
            format!(
                "bool bGo\n\nprogram start()\nbegin\n  taskCreate \"other\",10,other()\n  wait(bGo)\n  delay(1)\nend\n\n\
                 program other()\n  num l_nRound\nbegin\n  for l_nRound=1 to 10\n    delay({seconds})\n  endFor\n  bGo=true\nend\n"
            )
        };
        let note = "note: the step has not ended yet: task `main~` waits for a condition at start() line 6\n";
        assert_eq!(notes(&waiting("0.3")), [note]);
        assert_eq!(notes(&waiting("0.05")), Vec::<Value>::new());
    }
}
