//! Data breakpoints: the run stops after a line that has changed or read a value, and after a change from outside.
//!
//! The watched values are compared bit by bit after each line. Writing the present value is no change. The interpreter
//! compares numbers, strings and links itself ([`DataWatch`]); for all other data and for reads, tasks execute one line at
//! a time. Reads are found in the operations of the line ([`reads`](crate::reads)); the controller records reads of
//! signals. A waiting line reads once, when the wait begins.

use std::collections::BTreeSet;
use std::sync::Arc;

use val3_lang::ports::TaskNumber;
use val3_machine::controller::{Controller, RunStatus};
use val3_vm::{BegunLine, CycleWatch, DataWatch};

use crate::breakpoints::{BreakpointId, HitCondition};
use crate::conditions::{CompiledExpression, application_context};
use crate::debugger::{Debugger, Stop};
use crate::frames::{TaskFrame, task_frame};
use crate::history::Moment;
use crate::lifetimes::Lifetime;
use crate::watched::{Digest, WatchedData};

/// Accesses at which a data breakpoint stops the run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DataAccess {
    /// A change of the value.
    Write,
    /// A line that reads the value.
    Read,
    /// Changes and reads.
    ReadWrite,
}

/// Breakpoint on a value that changes or is read.
#[derive(Debug, Clone, PartialEq)]
pub struct DataBreakpoint {
    /// Identity, unique among all breakpoints.
    pub id: BreakpointId,
    /// Watched data.
    pub data: WatchedData,
    /// Accesses that count as hits.
    pub access: DataAccess,
    /// Condition for a hit to count, with the variables of the application.
    pub condition: Option<CompiledExpression>,
    /// Hits at which the run stops; `None` for every hit.
    pub hits: Option<HitCondition>,
}

/// A change of watched data, or a line that reads them.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct DataChange {
    /// Breakpoint that was hit.
    pub id: BreakpointId,
    /// Whether the value was changed; otherwise it was read.
    pub is_write: bool,
    /// Previous value.
    pub old: String,
    /// Present value, or a text for data that are no longer in memory.
    pub new: String,
    /// Reason why the condition of the breakpoint cannot be evaluated, which stops the run too.
    pub fault: Option<String>,
}

/// A stop at data breakpoints.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct DataStop {
    /// Task whose line accessed the data; `None` for a change from outside, for example when an input changes.
    pub task: Option<TaskNumber>,
    /// The line that accessed the data. The task is already before its next line.
    pub line: Option<TaskFrame>,
    /// Changes and reads at this stop.
    pub changes: Vec<DataChange>,
}

/// Data breakpoints of a run, with the last compared values.
#[derive(Debug, Default)]
pub(crate) struct DataBreakpoints {
    all: Vec<WatchedBreakpoint>,
    /// Whether the interpreter compares all values.
    is_compared: bool,
}

#[derive(Debug)]
struct WatchedBreakpoint {
    breakpoint: DataBreakpoint,
    /// Lifetime of a local variable; `None` for other data. Before and after it, the same place may contain a variable
    /// of another call.
    life: Option<Lifetime>,
    /// Last compared value; `None` if it was not in memory.
    seen: Option<Digest>,
    text: String,
    /// Whether the data existed at the last comparison. Other data than local variables always exist, if not in memory.
    exists: bool,
}

impl WatchedBreakpoint {
    fn is_over(&self) -> bool {
        self.life.is_some_and(|life| life.is_over())
    }

    /// Stores the present value for later comparisons.
    fn settle(&mut self, controller: &mut Controller) {
        self.seen = None;
        if self.exists {
            self.seen = self.breakpoint.data.digest(controller);
            self.text = self.breakpoint.data.text(controller);
        }
    }

    /// Follows the lifetime of a local variable. Returns whether its program has just begun or ended.
    fn follow_life(&mut self, controller: &mut Controller, now: Moment) -> bool {
        let has_frame = self.breakpoint.data.has_frame(controller);
        let exists = self.life.as_mut().is_none_or(|life| life.follow(has_frame, now));
        if self.exists == exists {
            return false;
        }
        self.exists = exists;
        self.settle(controller);
        true
    }
}

impl DataBreakpoints {
    pub(crate) fn is_empty(&self) -> bool {
        self.all.is_empty()
    }

    /// Returns the watched local variables with their lifetimes.
    pub(crate) fn lifetimes(&mut self) -> impl Iterator<Item = (&WatchedData, &mut Lifetime)> {
        self.all.iter_mut().filter_map(|watch| Some((&watch.breakpoint.data, watch.life.as_mut()?)))
    }
}

impl Debugger {
    /// Replaces the data breakpoints. A breakpoint whose identity already existed keeps its hit count.
    pub fn set_data_breakpoints(&mut self, breakpoints: Vec<DataBreakpoint>) {
        for before in &self.data.all {
            if breakpoints.iter().all(|breakpoint| breakpoint.id != before.breakpoint.id) {
                self.breakpoints.hits.remove(&before.breakpoint.id);
            }
        }
        let now = Moment::of(&self.controller);
        let before = std::mem::take(&mut self.data.all);
        for breakpoint in breakpoints {
            let same = before.iter().find(|watch| watch.breakpoint.data == breakpoint.data);
            let new = || breakpoint.data.is_local().then(|| Lifetime::of_existing(now));
            let life = same.map_or_else(new, |watch| watch.life);
            self.data.all.push(WatchedBreakpoint { life, breakpoint, seen: None, text: String::new(), exists: false });
        }
        self.settle_data();
    }

    /// Stores the present values for later comparisons. Called after changes by the caller, and after the run has gone
    /// to another moment.
    pub(crate) fn settle_data(&mut self) {
        let now = Moment::of(&self.controller);
        for watch in &mut self.data.all {
            let has_frame = watch.breakpoint.data.has_frame(&self.controller);
            watch.exists = watch.life.as_mut().is_none_or(|life| life.go_to(has_frame, now));
            watch.settle(&mut self.controller);
        }
        let with_reads = self.data.all.iter().filter(|watch| watch.breakpoint.access != DataAccess::Write);
        let signals = with_reads.filter_map(|watch| watch.breakpoint.data.as_signal()).collect();
        self.controller.devices.watch_signal_reads(signals);
        self.watch_data();
    }

    /// Lets the interpreter compare the watched values if it can compare all of them, and stop before the returns of
    /// programs with watched variables.
    fn watch_data(&mut self) {
        let mut found = DataWatch::default();
        self.data.is_compared = true;
        for watch in self.data.all.iter().filter(|watch| !watch.is_over()) {
            let DataBreakpoint { data, access, .. } = &watch.breakpoint;
            let owner = data.owner();
            let is_compared = if watch.exists {
                found.frames.extend(owner);
                let value = data.plain(&mut self.controller).filter(|_| *access == DataAccess::Write);
                let is_plain = value.is_some();
                found.values.extend(value);
                is_plain
            } else {
                found.awaited.extend(owner);
                owner.is_some_and(|owner| owner.index > 0)
            };
            self.data.is_compared &= is_compared;
        }
        if !self.data.is_compared {
            (found.values, found.awaited) = (Vec::new(), Vec::new());
        }
        self.controller.vm.watch_data((!self.data.is_empty()).then(|| Arc::new(found)));
    }

    /// Returns how finely a cycle has to stop so that no access to watched data is missed.
    pub(crate) fn watch_of_data(&self) -> CycleWatch {
        match self.data.is_compared {
            _ if self.data.is_empty() => CycleWatch::Nothing,
            true => CycleWatch::Changes,
            false => CycleWatch::Lines,
        }
    }

    /// Returns the stop for the accesses since the last call, by a line of `task` or from outside, and counts them as
    /// hits. The stop contains the breakpoints whose hit condition holds, or all hit breakpoints with `at_each_hit`.
    pub(crate) fn follow_data(&mut self, task: Option<TaskNumber>, at_each_hit: bool) -> Option<Stop> {
        if self.data.is_empty() {
            return None;
        }
        let line = task.and_then(|_| self.controller.vm.last_line());
        let signal_reads = self.controller.devices.take_signal_reads();
        let (mut changes, mut has_any_changed) = (Vec::new(), false);
        let moment = Moment::of(&self.controller);
        for watch in self.data.all.iter_mut().filter(|watch| !watch.is_over()) {
            if watch.follow_life(&mut self.controller, moment) {
                has_any_changed = true;
                continue;
            }
            if !watch.exists {
                continue;
            }
            let DataBreakpoint { data, access, .. } = &watch.breakpoint;
            let now = data.digest(&mut self.controller);
            let is_read = match (task.zip(line), data.as_signal()) {
                _ if *access == DataAccess::Write => false,
                (None, _) => false,
                (Some((task, _)), Some(signal)) => signal_reads.contains(&(task, signal)),
                (Some((task, BegunLine { frame, op })), None) => data.is_read(&mut self.controller, task, frame, op),
            };
            let has_changed = now != watch.seen;
            has_any_changed |= has_changed;
            let mut old = watch.text.clone();
            if has_changed {
                let text = data.text(&mut self.controller);
                old = std::mem::replace(&mut watch.text, text);
                watch.seen = now;
            }
            let is_write = has_changed && *access != DataAccess::Read;
            if !is_write && !is_read {
                continue;
            }
            let context = application_context(&self.controller.vm);
            let condition = watch.breakpoint.condition.as_ref();
            let holds = condition.map_or(Ok(true), |condition| condition.holds(&mut self.controller, context));
            if holds == Ok(false) {
                continue;
            }
            let hit = self.breakpoints.hits.entry(watch.breakpoint.id).or_default();
            *hit += 1;
            let fault = holds.err();
            let is_wanted = fault.is_some() || watch.breakpoint.hits.is_none_or(|condition| condition.holds(*hit));
            if at_each_hit || is_wanted {
                let new = watch.text.clone();
                changes.push(DataChange { id: watch.breakpoint.id, is_write, old, new, fault });
            }
        }
        if has_any_changed {
            self.watch_data();
        }
        if changes.is_empty() {
            return None;
        }
        let line = line.and_then(|line| task_frame(&self.controller.vm, &line.frame, line.op));
        let line = line.filter(|line| !line.is_console);
        Some(Stop::Data(Box::new(DataStop { task, line, changes })))
    }

    /// Discards the recorded future of the watched data, because the caller has changed the run.
    pub(crate) fn discard_future_of_data(&mut self) {
        let now = Moment::of(&self.controller);
        self.data.lifetimes().for_each(|(_, life)| life.discard_future(now));
    }

    /// Returns the breakpoints on local variables whose program has ended, so that they no longer stop the run.
    #[must_use]
    pub fn ended_data(&self) -> BTreeSet<BreakpointId> {
        let is_gone = |watch: &&WatchedBreakpoint| watch.exists && !watch.breakpoint.data.has_frame(&self.controller);
        let ended = self.data.all.iter().filter(|watch| watch.is_over() || is_gone(watch));
        ended.map(|watch| watch.breakpoint.id).collect()
    }

    /// Begins the next cycle without executing a line, and returns the stop for changes from outside.
    pub(crate) fn begin_watched_cycle(&mut self) -> Option<Stop> {
        if self.data.is_empty() || self.controller.is_within_cycle() || self.travel.is_some() {
            return None;
        }
        let limit = self.controller.limit();
        self.controller.set_limit(Some(self.controller.now()));
        let status = self.controller.step();
        self.controller.set_limit(limit);
        debug_assert_eq!(status, RunStatus::Limit, "no task begins a line");
        self.follow_data(None, false)
    }
}
