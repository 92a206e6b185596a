//! Going back: to the previous line of a task, to the previous breakpoint.

use std::ops::ControlFlow;

use val3_lang::ports::{TaskNumber, Time};
use val3_machine::controller::Outcome;
use val3_vm::Watch;

use crate::debugger::{Debugger, Stop};
use crate::history::{Cause, History, Moment, PastLimits, Reach};
use crate::step::{Step, StepKind};

/// Where a search in the past leads.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Goal {
    /// The line that a task began before this one.
    Line(TaskNumber, StepKind),
    /// The last stop at a breakpoint or change of watched data.
    Breakpoint,
}

/// What has happened in a replay up to a moment.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Replayed {
    pub(crate) outcome: Outcome,
    /// Whether the arm has come to rest before a path that it cannot follow, at which the run stops.
    is_path_fault: bool,
}

/// Learns during a search which part of the past is searched, from 0 to 1, and can give it up. It is called for each cycle
/// that is executed again.
pub type Watcher<'a> = &'a mut dyn FnMut(f64) -> ControlFlow<()>;

impl Debugger {
    /// Keeps the past from now on, within limits. Without it the run cannot go back.
    pub fn record(&mut self, limits: PastLimits) {
        self.history = Some(History::new(&mut self.controller, &self.breakpoints.hits, limits));
    }

    /// Forgets the past, which begins here if it is kept.
    pub fn forget_past(&mut self) {
        if let Some(limits) = self.history.as_ref().map(History::limits) {
            self.record(limits);
        }
    }

    /// How far the run can go back; `None` if it is not recorded.
    #[must_use]
    pub fn reach(&self) -> Option<Reach> {
        self.history.as_ref()?.reach(Moment::of(&self.controller))
    }

    /// The earliest moment to which the run can go back.
    #[must_use]
    pub fn first_moment(&self) -> Option<Moment> {
        self.history.as_ref().and_then(History::first)
    }

    /// A cycle is over.
    pub(crate) fn pass_cycle(&mut self) {
        if let Some(history) = &mut self.history {
            history.pass_cycle(&mut self.controller, &self.breakpoints.hits);
        }
    }

    /// The caller has changed something: data, an input, the next line of a task. A new future begins here.
    pub fn begin_new_future(&mut self) {
        self.change_future(Cause::Change);
    }

    pub(crate) fn change_future(&mut self, cause: Cause) {
        self.settle_data();
        if let Some(history) = &mut self.history {
            history.begin_new_future(&mut self.controller, &self.breakpoints.hits, self.last, cause);
        }
    }

    /// Goes back to the line that a task began before this one. `Over` leaves out the lines of programs that were called,
    /// `Out` goes to the call of the present program.
    pub fn step_back(&mut self, task: TaskNumber, kind: StepKind) -> Stop {
        self.search_back(Goal::Line(task, kind), &mut |_| ControlFlow::Continue(())).unwrap_or(Stop::Beginning)
    }

    /// Goes back to where a task was last before a line with a breakpoint, or right after the last change of watched data,
    /// whatever the conditions on hits, or to where the arm came to rest before a path that it cannot follow.
    pub fn run_back(&mut self) -> Stop {
        self.search_back(Goal::Breakpoint, &mut |_| ControlFlow::Continue(())).unwrap_or(Stop::Beginning)
    }

    /// Goes back as [`step_back`](Self::step_back) or [`run_back`](Self::run_back). None if the watcher has given it up: the
    /// run is where it was.
    pub fn search_back(&mut self, goal: Goal, watcher: Watcher<'_>) -> Option<Stop> {
        let Goal::Line(task, kind) = goal else {
            return self.back_to_last(self.watch_of_data(), watcher, |debugger, replayed| match replayed.outcome {
                Outcome::AtStop(task) => debugger.stop_before(task),
                Outcome::Seen(task) => debugger.follow_data(Some(task), true),
                _ => debugger.follow_data(None, true).or_else(|| debugger.stop_at_path_fault(replayed)),
            });
        };
        let found = self.controller.vm.tasks().iter().find(|known| known.id == task);
        let Some(step) = found.map(|task| Step::new(task, kind)) else { return Some(self.back_to_the_beginning()) };
        self.back_to_last(Watch::Lines, watcher, |debugger, replayed| match replayed.outcome {
            Outcome::Seen(seen) if seen == task && step.is_done(&debugger.controller.vm) => Some(Stop::Step { task }),
            _ => debugger.stop_at_path_fault(replayed),
        })
    }

    /// The stop at a path that the arm cannot follow, if it has just come to rest before it.
    fn stop_at_path_fault(&self, replayed: Replayed) -> Option<Stop> {
        let fault = self.controller.motion_fault().filter(|_| replayed.is_path_fault)?;
        Some(Stop::PathFault(Box::new(fault)))
    }

    /// How closely a run is executed again so that changes of watched data are seen.
    fn watch_of_data(&self) -> Watch {
        if self.data.is_empty() { Watch::Nothing } else { Watch::Lines }
    }

    /// Goes back to the last moment before this one that `is_wanted`. None if the watcher has given the search up.
    pub(crate) fn back_to_last(
        &mut self,
        watch: Watch,
        watcher: Watcher<'_>,
        is_wanted: impl Fn(&mut Self, Replayed) -> Option<Stop>,
    ) -> Option<Stop> {
        let present = Moment::of(&self.controller);
        let past = present.time - self.first_moment().map_or(0, |first| first.time);
        let mut end = present;
        while let Some(start) = self.restore_earlier(end) {
            let mut last = None;
            for outcomes in 1.. {
                let Some(replayed) = self.replay(watch, end) else { break };
                let now = Moment::of(&self.controller);
                let searched = (present.time - end.time) + (now.time - start.time);
                if watcher(fraction(searched, past)).is_break() {
                    self.go_to(present);
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
                // The end of a wait takes no time: a moment alone does not say on which side of it the run was.
                self.replay_outcomes(start, outcomes, |debugger| debugger.replay(watch, end));
                if over > Moment::of(&self.controller) {
                    self.go_to(over);
                }
                if let Stop::Breakpoints { task, .. } | Stop::Step { task } = stop {
                    // The task has arrived there, which was its hit.
                    self.hit_again(task);
                    self.controller.vm.pass_stop(task);
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

    /// Goes to a moment if the run was changed there where a task had arrived at a line that `is_wanted`. A replay ends
    /// before it reports the arrival.
    fn stop_at_change(
        &mut self,
        moment: Moment,
        is_wanted: impl Fn(&mut Self, Replayed) -> Option<Stop>,
    ) -> Option<Stop> {
        let task = self.history.as_ref()?.changed_at(moment)?;
        self.go_to(moment);
        let stop = is_wanted(self, Replayed { outcome: Outcome::AtStop(task), is_path_fault: false })?;
        self.controller.vm.pass_stop(task);
        Some(stop)
    }

    fn back_to_the_beginning(&mut self) -> Stop {
        if let Some(first) = self.first_moment() {
            self.go_to(first);
        }
        Stop::Beginning
    }

    /// Whether the run has gone back, so that a [new future](Self::begin_new_future) replaces what has followed.
    #[must_use]
    pub fn is_in_past(&self) -> bool {
        self.history.as_ref().is_some_and(|history| history.is_past(Moment::of(&self.controller)))
    }

    /// The run leaves its present moment to go back.
    fn leave_present(&mut self) {
        let present = Moment::of(&self.controller);
        if let Some(history) = &mut self.history {
            history.leave(present);
        }
    }

    /// Goes to a moment of the past, or of a future that was already seen.
    pub fn go_to(&mut self, moment: Moment) {
        let watch = self.watch_of_data();
        self.replay_outcomes(moment, u64::MAX, |debugger| debugger.replay(watch, moment));
    }

    /// Executes a number of outcomes again, from the last snapshot at a moment or before it.
    fn replay_outcomes(&mut self, from: Moment, count: u64, mut next: impl FnMut(&mut Self) -> Option<Replayed>) {
        self.leave_present();
        let Some(point) = self.history.as_ref().and_then(|history| history.before(from)) else { return };
        self.controller.restore(&point.snapshot);
        self.breakpoints.hits.clone_from(&point.hits);
        self.restore_marks();
        self.settle_data();
        for _ in 0..count {
            match next(self).map(|replayed| replayed.outcome) {
                Some(Outcome::AtStop(task)) => self.hit_again(task),
                Some(Outcome::Seen(task)) => drop(self.follow_data(Some(task), false)),
                Some(_) => drop(self.follow_data(None, false)),
                None => break,
            }
        }
        self.settle_data();
        self.settle_motion();
    }

    /// Returns to the last snapshot before a moment, and gives its moment.
    fn restore_earlier(&mut self, moment: Moment) -> Option<Moment> {
        self.leave_present();
        let point = self.history.as_ref()?.earlier(moment)?;
        let start = point.moment;
        self.controller.restore(&point.snapshot);
        self.restore_marks();
        self.settle_data();
        Some(start)
    }

    /// Executes again what has happened up to a moment, at most a cycle at once; `None` there. Its events are known.
    fn replay(&mut self, watch: Watch, end: Moment) -> Option<Replayed> {
        if Moment::of(&self.controller) >= end {
            return None;
        }
        let has_fault =
            |debugger: &Self| debugger.errors.contain_path_faults() && debugger.controller.motion_fault().is_some();
        let had_fault = has_fault(self);
        self.controller.watch(watch);
        self.controller.set_limit(Some(end.time));
        let outcome = self.controller.step();
        self.controller.set_limit(None);
        drop(self.controller.devices.take_events());
        let is_path_fault = !had_fault && has_fault(self);
        if let Outcome::Waiting(wake) = outcome
            && !is_path_fault
        {
            self.pass_idle_time(wake, end.time);
        }
        Some(Replayed { outcome, is_path_fault })
    }

    /// Leaves out the time in which nothing happens. While a line may hear something, cycles follow one another as in the
    /// recorded run.
    fn pass_idle_time(&mut self, wake: Option<Time>, end: Time) {
        let next = wake.into_iter().chain(self.controller.next_due()).fold(end, Time::min);
        if !self.controller.hears_outside() {
            self.controller.jump(next);
        }
    }
}

/// A part of a time, from 0 to 1.
#[expect(clippy::cast_precision_loss, reason = "people see per cent")]
fn fraction(part: Time, whole: Time) -> f64 {
    (part as f64 / whole.max(1) as f64).min(1.0)
}
