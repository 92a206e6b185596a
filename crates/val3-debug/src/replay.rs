//! Replay of the recorded history from a snapshot.

use val3_lang::ports::{TaskNumber, Time};
use val3_machine::controller::RunStatus;
use val3_vm::CycleWatch;

use crate::contacts::Contact;
use crate::debugger::Debugger;
use crate::history::Moment;

/// Result of [`Debugger::replay`] for the replayed part, at most a cycle.
#[derive(Debug, Clone)]
pub(crate) struct Replayed {
    pub(crate) status: RunStatus,
    /// Contacts that have begun and stop the run.
    pub(crate) contacts: Vec<Contact>,
    /// Whether the arm came to rest before a path that it cannot follow, which stops the run.
    pub(crate) is_path_fault: bool,
    /// Whether nothing was replayed: the caller changed the run while the task was before a line.
    pub(crate) is_change: bool,
}

impl Debugger {
    /// Records the present moment in the history before the run goes back.
    pub(crate) fn leave_present(&mut self) {
        let present = Moment::of(&self.controller);
        self.contacts.clear();
        if let Some(history) = &mut self.history {
            history.leave(present);
        }
    }

    /// Goes to a recorded moment, in the past or in the recorded future.
    pub fn go_to(&mut self, moment: Moment) {
        self.replay_outcomes(moment, u64::MAX, |debugger| debugger.replay(debugger.watch_of_data(), moment));
    }

    /// Restores the last snapshot at or before `from`, and replays `count` outcomes.
    pub(crate) fn replay_outcomes(
        &mut self,
        from: Moment,
        count: u64,
        mut next: impl FnMut(&mut Self) -> Option<Replayed>,
    ) {
        self.leave_present();
        let start = self.history.as_ref().and_then(|history| history.before(from)).map(|point| point.moment);
        start.into_iter().for_each(|start| self.trace_lifetimes(start));
        let Some(point) = self.history.as_ref().and_then(|history| history.before(from)) else { return };
        self.controller.restore(&point.snapshot);
        self.breakpoints.hits.clone_from(&point.hits);
        self.restore_marks();
        self.settle_data();
        for number in 1..=count {
            match next(self).map(|replayed| replayed.status) {
                Some(RunStatus::AtStop(task)) => self.arrive_again(task, number == count),
                Some(RunStatus::Seen(task)) => drop(self.follow_data(Some(task), false)),
                Some(_) => drop(self.follow_data(None, false)),
                None => break,
            }
        }
        self.settle_data();
        self.settle_motion();
    }

    /// Counts the hits of a task that has arrived at a stop mark. If the replay `ends` at a change by the line before the
    /// mark, the task has not arrived at a breakpoint of the mark yet.
    fn arrive_again(&mut self, task: TaskNumber, ends: bool) {
        let is_after_line = self.controller.vm.is_after_line(task);
        let has_data = is_after_line && self.follow_data(Some(task), true).is_some();
        if !(self.has_no_breakpoint(task) || ends && has_data) {
            self.hit_again(task);
        }
    }

    /// Restores the last snapshot before a moment, and returns the snapshot's moment.
    pub(crate) fn restore_earlier(&mut self, moment: Moment) -> Option<Moment> {
        self.leave_present();
        let start = self.history.as_ref()?.earlier(moment)?.moment;
        self.trace_lifetimes(start);
        let point = self.history.as_ref()?.earlier(moment)?;
        self.controller.restore(&point.snapshot);
        self.restore_marks();
        self.settle_data();
        Some(start)
    }

    /// Replays the run towards `end`, by at most one cycle, and discards the events, which were already reported.
    /// Returns `None` at `end`. While data are watched, a cycle begins separately, because its new inputs are no changes
    /// of the first line.
    pub(crate) fn replay(&mut self, watch: CycleWatch, end: Moment) -> Option<Replayed> {
        if Moment::of(&self.controller) >= end {
            return None;
        }
        let had_path_fault = self.has_path_fault();
        self.controller.watch(watch);
        let begins = !self.data.is_empty() && !self.controller.is_within_cycle();
        self.controller.set_limit(Some(if begins { self.controller.now() } else { end.time }));
        let status = self.controller.step();
        self.controller.set_limit(None);
        let events = self.controller.devices.take_events();
        let contacts = if self.errors.contacts { Contact::all(&events) } else { Vec::new() };
        let is_path_fault = !had_path_fault && self.has_path_fault();
        if let RunStatus::Waiting(wake) = status
            && !is_path_fault
            && contacts.is_empty()
        {
            self.pass_idle_time(wake, end.time);
        }
        Some(Replayed { status, contacts, is_path_fault, is_change: false })
    }

    /// Whether the motion has a fault, and the debugger stops at such faults.
    fn has_path_fault(&self) -> bool {
        self.errors.contain_path_faults() && self.controller.motion_fault().is_some()
    }

    /// Skips the time without any activity. If a waiting line may receive external input, no time is skipped, so that
    /// the cycles are the recorded ones.
    fn pass_idle_time(&mut self, wake: Option<Time>, end: Time) {
        let next = wake.into_iter().chain(self.controller.next_due()).fold(end, Time::min);
        if !self.controller.devices.lines.are_in_use() {
            self.controller.jump(next);
        }
    }
}
