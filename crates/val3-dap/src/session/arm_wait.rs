//! Note about an arm that does not move although a task waits for it, for example because it has no power.

use val3_lang::ports::{SECOND, Time};
use val3_machine::arm::ArmHold;

use super::DebugSession;
use crate::debugged_run::DebuggedRun;
use crate::protocol::{OutputEvent, OutputEventCategory, StandardEvent};

/// Controller time between two looks at the tasks. A reason that two looks find is shown.
const LOOK: Time = SECOND / 2;

/// Reason why the arm does not move.
#[derive(Debug, Default)]
pub(super) struct ArmWait {
    next_look: Time,
    hold: Option<ArmHold>,
    is_noted: bool,
}

impl DebugSession {
    /// Shows once in the debug console why the arm does not move. The client steps a stepped motion itself.
    pub(super) fn note_arm_wait(&mut self, run: &DebuggedRun<'_>) {
        let controller = &run.debugger.controller;
        let now = controller.now();
        let has_gone_back = now.saturating_add(LOOK) < self.arm_wait.next_look;
        if now < self.arm_wait.next_look && !has_gone_back {
            return;
        }
        let waiting = controller.task_positions().into_iter().find_map(|task| Some((task.name, task.activity.hold()?)));
        let waiting = waiting.filter(|(_, hold)| *hold != ArmHold::Step);
        let hold = waiting.as_ref().map(|(_, hold)| *hold);
        let is_known = hold == self.arm_wait.hold;
        let is_new = is_known && !self.arm_wait.is_noted;
        self.arm_wait =
            ArmWait { next_look: now + LOOK, hold, is_noted: is_known && (self.arm_wait.is_noted || hold.is_some()) };
        if is_new && let Some((task, hold)) = waiting {
            let output = format!("note: task `{task}` waits for the arm. {}\n", hold.operator_text());
            let category = Some(OutputEventCategory::Console);
            self.client.event(&StandardEvent::Output(OutputEvent { output, category, ..OutputEvent::default() }));
        }
    }
}

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};

    use crate::test_client::TestClient;

    const MOVING: &str = "mdesc mNorm\njoint jA\n\nprogram start()\nbegin\n  taskCreate \"clock\",10,clock()\n  \
                          jA.j1=10\n  movej(jA,flange,mNorm)\n  waitEndMove()\nend\n\nprogram clock()\n  num l_nRound\nbegin\n  \
                          for l_nRound=1 to 30\n    delay(0.1)\n  endFor\nend\n";

    fn notes(listing: &str) -> Vec<Value> {
        let mut client = TestClient::launched(listing, json!({}));
        let outputs = client.run().into_iter().filter(|(event, _)| event == "output");
        outputs.map(|(_, body)| body["output"].clone()).filter(|text| text.to_string().contains("the arm.")).collect()
    }

    #[test]
    fn an_arm_without_power_is_noted_once() {
        let note = "note: task `main~` waits for the arm. The arm has no power. Switch the power on.\n";
        assert_eq!(notes(MOVING), [note]);
        assert_eq!(notes(&MOVING.replace("waitEndMove()", "delay(2)")), Vec::<Value>::new());
    }
}
