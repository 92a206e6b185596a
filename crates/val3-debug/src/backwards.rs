//! Reverse execution: to a task's previous line, or to the previous breakpoint.

use std::ops::ControlFlow;

use val3_lang::ports::{TaskNumber, Time};
use val3_machine::controller::RunStatus;
use val3_vm::CycleWatch;

use crate::debugger::{Debugger, Stop};
use crate::history::{History, HistoryExtent, Moment, PastLimits, SnapshotReason};
use crate::replay::Replayed;
use crate::step::{Step, StepKind};

/// Destination of a search in the history.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Goal {
    /// The previous line of the task, by the kind of step.
    Line(TaskNumber, StepKind),
    /// The previous stop at a breakpoint or change of watched data.
    Breakpoint,
}

/// Callback of a reverse search, called for each replayed cycle with the searched part of the history, from 0 to 1.
/// Returning `Break` cancels the search.
pub type Watcher<'a> = &'a mut dyn FnMut(f64) -> ControlFlow<()>;

impl Debugger {
    /// Starts recording the history within `limits`. Without recording, the run cannot go back.
    pub fn record(&mut self, limits: PastLimits) {
        self.history = Some(History::new(&mut self.controller, &self.breakpoints.hits, limits));
    }

    /// Discards the recorded history. If recording is on, it continues from the present moment.
    pub fn forget_past(&mut self) {
        if let Some(limits) = self.history.as_ref().map(History::limits) {
            self.record(limits);
        }
    }

    /// Returns the extent of the recorded history; `None` if the run is not recorded.
    #[must_use]
    pub fn reach(&self) -> Option<HistoryExtent> {
        self.history.as_ref()?.reach(Moment::of(&self.controller))
    }

    /// Returns the earliest moment to which the run can go back.
    #[must_use]
    pub fn first_moment(&self) -> Option<Moment> {
        self.history.as_ref().and_then(History::first)
    }

    /// Records the end of a cycle.
    pub(crate) fn pass_cycle(&mut self) {
        if let Some(history) = &mut self.history {
            history.pass_cycle(&mut self.controller, &self.breakpoints.hits);
        }
    }

    /// Discards the recorded future and adds a snapshot. Must be called after each change from outside the run: to
    /// data, an input, or a task's next line.
    pub fn begin_new_future(&mut self) {
        self.change_future(SnapshotReason::Change);
    }

    pub(crate) fn change_future(&mut self, cause: SnapshotReason) {
        self.discard_future_of_data();
        self.settle_data();
        if let Some(history) = &mut self.history {
            history.begin_new_future(&mut self.controller, &self.breakpoints.hits, self.last, cause);
        }
    }

    /// Goes back to the line that the task began before the present one. `Over` skips the lines of called programs,
    /// `Out` goes to the call of the present program.
    pub fn step_back(&mut self, task: TaskNumber, kind: StepKind) -> Stop {
        self.search_back(Goal::Line(task, kind), &mut |_| ControlFlow::Continue(())).unwrap_or(Stop::Beginning)
    }

    /// Goes back to the last moment at which a task was before a line with a breakpoint, a watched value had just
    /// changed, or the arm had come to rest before a path that it cannot follow. Hit conditions are ignored.
    pub fn run_back(&mut self) -> Stop {
        self.search_back(Goal::Breakpoint, &mut |_| ControlFlow::Continue(())).unwrap_or(Stop::Beginning)
    }

    /// Goes back like [`step_back`](Self::step_back) or [`run_back`](Self::run_back). Returns `None` if the watcher
    /// cancels the search; the run then stays at its present moment.
    pub fn search_back(&mut self, goal: Goal, watcher: Watcher<'_>) -> Option<Stop> {
        let Goal::Line(task, kind) = goal else {
            return self.back_to_last(Self::watch_of_data, watcher, |debugger, replayed| match replayed.status {
                RunStatus::AtStop(task) => debugger.stop_at_mark(task),
                RunStatus::Seen(task) => debugger.follow_data(Some(task), true),
                _ => debugger.follow_data(None, true).or_else(|| debugger.stop_of_arm(replayed)),
            });
        };
        let found = self.controller.vm.tasks().iter().find(|known| known.id == task);
        let Some(step) = found.map(|task| Step::new(task, kind)) else { return Some(self.back_to_the_beginning()) };
        self.back_to_last(
            |_| CycleWatch::Lines,
            watcher,
            |debugger, replayed| match replayed.status {
                RunStatus::Seen(seen) if debugger.ends_step_back(step, seen) => Some(Stop::Step { task }),
                RunStatus::AtStop(seen) if replayed.is_change && debugger.ends_step_back(step, seen) => {
                    Some(Stop::Step { task })
                }
                _ => debugger.stop_of_arm(replayed),
            },
        )
    }

    /// Whether a step backwards ends where `seen` has executed a line. A failed line was not executed, so the line before
    /// the failure is this line.
    fn ends_step_back(&self, step: Step, seen: TaskNumber) -> bool {
        seen == step.task && self.failure(seen).is_none() && step.is_done(&self.controller.vm, &[])
    }

    /// Returns the stop of a task that has arrived at a stop mark. A change by the line before a closing keyword and a
    /// breakpoint on the keyword have the same moment, so they are one stop backwards.
    fn stop_at_mark(&mut self, task: TaskNumber) -> Option<Stop> {
        if self.controller.vm.is_after_line(task)
            && let Some(data) = self.follow_data(Some(task), true)
        {
            return Some(data);
        }
        if self.has_no_breakpoint(task) { None } else { self.stop_before(task) }
    }

    /// Whether the task has stopped for another reason than a stop mark.
    pub(crate) fn has_no_breakpoint(&self, task: TaskNumber) -> bool {
        let vm = &self.controller.vm;
        vm.is_at_end(task) || vm.is_at_return(task) || vm.is_at_fragment_end(task)
    }

    /// Returns the stop for contacts, or for a path that the arm cannot follow, if the arm has just come to it.
    fn stop_of_arm(&self, replayed: Replayed) -> Option<Stop> {
        if !replayed.contacts.is_empty() {
            return Some(Stop::Contacts(replayed.contacts));
        }
        let fault = self.controller.motion_fault().filter(|_| replayed.is_path_fault)?;
        Some(Stop::PathFault(Box::new(fault)))
    }

    /// Goes back to the last earlier moment for which `is_wanted` returns a stop. `watch` returns how finely the next cycle
    /// has to stop. Returns `None` if the watcher cancels the search.
    pub(crate) fn back_to_last(
        &mut self,
        watch: fn(&Self) -> CycleWatch,
        watcher: Watcher<'_>,
        is_wanted: impl Fn(&mut Self, Replayed) -> Option<Stop>,
    ) -> Option<Stop> {
        let present = Moment::of(&self.controller);
        let past = present.time - self.first_moment().map_or(0, |first| first.time);
        let contacts = self.contacts.clone();
        let mut end = present;
        while let Some(start) = self.restore_earlier(end) {
            let mut last = None;
            for outcomes in 1.. {
                let Some(replayed) = self.replay(watch(self), end) else { break };
                let now = Moment::of(&self.controller);
                let searched = (present.time - end.time) + (now.time - start.time);
                if watcher(fraction(searched, past)).is_break() {
                    self.go_to(present);
                    self.contacts = contacts;
                    return None;
                }
                let over = self.history.as_ref().and_then(|history| history.end_of_line(now));
                if let Some(over) = over.filter(|over| *over < present)
                    && let Some(stop) = is_wanted(self, replayed)
                {
                    last = Some((outcomes, over, stop));
                }
            }
            if let Some((outcomes, over, stop)) = last {
                // A wait ends without time passing, so the moment does not determine whether the run was before or
                // after the end of the wait.
                self.replay_outcomes(start, outcomes, |debugger| debugger.replay(watch(debugger), end));
                // The replay has already counted the hits if it reports the arrival.
                let mut is_counted = matches!(stop, Stop::Breakpoints { .. });
                if over > Moment::of(&self.controller) {
                    self.go_to(over);
                    is_counted = false;
                }
                match &stop {
                    Stop::Breakpoints { task, .. } | Stop::Step { task } => {
                        if !is_counted {
                            self.hit_again(*task);
                        }
                        self.controller.vm.pass_stop(*task);
                    }
                    // A breakpoint on the closing keyword after the line stops the run next.
                    Stop::Data(data) => data.task.into_iter().for_each(|task| self.controller.vm.meet_stop_again(task)),
                    _ => {}
                }
                return Some(stop);
            }
            if let Some(stop) = self.stop_at_change(start, &is_wanted) {
                return Some(stop);
            }
            end = start;
        }
        Some(self.back_to_the_beginning())
    }

    /// Goes to a moment at which the caller changed the run while a task was before a line, if `is_wanted` returns a
    /// stop for this line. Such a stop is checked separately, because a replay ends before it reports the arrival.
    fn stop_at_change(
        &mut self,
        moment: Moment,
        is_wanted: impl Fn(&mut Self, Replayed) -> Option<Stop>,
    ) -> Option<Stop> {
        let task = self.history.as_ref()?.changed_at(moment)?;
        self.go_to(moment);
        let status = RunStatus::AtStop(task);
        let change = Replayed { status, contacts: Vec::new(), is_path_fault: false, is_change: true };
        let stop = is_wanted(self, change)?;
        self.controller.vm.pass_stop(task);
        Some(stop)
    }

    fn back_to_the_beginning(&mut self) -> Stop {
        if let Some(first) = self.first_moment() {
            self.go_to(first);
        }
        Stop::Beginning
    }

    /// Whether the run has gone back, so that [`begin_new_future`](Self::begin_new_future) would discard recorded
    /// moments.
    #[must_use]
    pub fn is_in_past(&self) -> bool {
        self.history.as_ref().is_some_and(|history| history.is_past(Moment::of(&self.controller)))
    }
}

/// Returns `part / whole`, from 0 to 1.
#[expect(clippy::cast_precision_loss, reason = "people see per cent")]
pub(crate) fn fraction(part: Time, whole: Time) -> f64 {
    (part as f64 / whole.max(1) as f64).min(1.0)
}
