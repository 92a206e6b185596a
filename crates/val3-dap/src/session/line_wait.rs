//! Note about a run in which all tasks wait and only data over a serial line or socket can end a wait. Such a run does
//! not count as stuck, because programs on this machine can connect at any time.

use val3_lang::ports::{SECOND, Time};
use val3_machine::controller::Controller;
use val3_vm::TaskState;

use crate::stop_event;

/// Controller time after which the client receives a note.
const LONG: Time = SECOND;

/// Wait of all tasks for data over lines.
#[derive(Debug, Default)]
pub(super) struct LineWait {
    /// Controller time at which the wait began; `None` if a task can continue without data over a line.
    since: Option<Time>,
    is_noted: bool,
}

impl LineWait {
    /// Returns a note for the debug console, once in a session, if only data over a line can continue the run, after a
    /// long wait.
    pub(super) fn note(&mut self, controller: &Controller) -> Option<String> {
        if self.is_noted {
            return None;
        }
        let now = controller.now();
        let since = self.since.filter(|since| *since <= now).unwrap_or(now);
        self.since = only_lines_end_waits(controller).then_some(since);
        self.is_noted = self.since.is_some() && now - since >= LONG;
        self.is_noted.then(|| {
            let tasks: String = stop_event::waits(controller).map(|task| format!("  {task}\n")).collect();
            let remedy = "connect a program, or use `pause`";
            format!("note: only data over a serial line or socket can continue the run; {remedy}:\n{tasks}")
        })
    }
}

/// Whether all running tasks wait without a timeout, the arm rests, and programs use a line.
fn only_lines_end_waits(controller: &Controller) -> bool {
    let running = || controller.vm.tasks().iter().filter(|task| task.state == TaskState::Running);
    let rests = controller.arm().motion().has_arrived() || controller.devices.state.arm_standstill().is_some();
    running().next().is_some()
        && running().all(|task| task.thread.wait.is_some_and(|wait| wait.wake.is_none()))
        && rests
        && controller.devices.lines.are_in_use()
        && controller.next_due().is_none()
}
