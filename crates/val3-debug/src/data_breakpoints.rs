//! Data breakpoints: the run stops after a line that has changed or read a value, and after a change from outside.
//!
//! The watched values are compared bit by bit after each line. Writing the present value is no change. The interpreter
//! compares numbers, strings and links itself ([`DataWatch`](val3_vm::DataWatch)); for all other data and for reads, tasks
//! execute one line at a time. Reads are found in the operations of the line ([`reads`](crate::reads)); the controller
//! records reads of signals. A waiting line reads once, when the wait begins.

use std::collections::BTreeSet;
use std::sync::Arc;

use val3_lang::ports::TaskNumber;
use val3_machine::controller::RunStatus;
use val3_vm::{BegunLine, CycleWatch};

use crate::breakpoints::{BreakpointId, HitCondition};
use crate::conditions::{CompiledExpression, application_context};
use crate::debugger::{Debugger, Stop};
use crate::frames::{TaskFrame, task_frame};
use crate::history::Moment;
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
}

#[derive(Debug)]
struct WatchedBreakpoint {
    breakpoint: DataBreakpoint,
    /// Last compared value; `None` if it was not in memory.
    seen: Option<Digest>,
    text: String,
    /// Moment at which the program of a local variable ended. From then on, the same place may contain a variable of a
    /// later call.
    over: Option<Moment>,
}

impl DataBreakpoints {
    pub(crate) fn is_empty(&self) -> bool {
        self.all.is_empty()
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
        let before = std::mem::take(&mut self.data.all);
        for breakpoint in breakpoints {
            let same = before.iter().find(|watch| watch.breakpoint.data == breakpoint.data);
            let over = same.and_then(|watch| watch.over);
            self.data.all.push(WatchedBreakpoint { over, breakpoint, seen: None, text: String::new() });
        }
        self.settle_data();
    }

    /// Stores the present values for later comparisons. Called after changes by the caller, and after the run has gone
    /// to another moment.
    pub(crate) fn settle_data(&mut self) {
        let now = Moment::of(&self.controller);
        for watch in &mut self.data.all {
            watch.over = watch.over.filter(|over| *over <= now);
            watch.seen = watch.breakpoint.data.digest(&mut self.controller);
            watch.text = watch.breakpoint.data.text(&mut self.controller);
        }
        let with_reads = self.data.all.iter().filter(|watch| watch.breakpoint.access != DataAccess::Write);
        let signals = with_reads.filter_map(|watch| watch.breakpoint.data.as_signal()).collect();
        self.controller.devices.watch_signal_reads(signals);
        self.watch_plain_data();
    }

    /// Lets the interpreter compare the watched values if it can compare all of them.
    fn watch_plain_data(&mut self) {
        let open = self.data.all.iter().filter(|watch| watch.over.is_none());
        let plain = open.map(|watch| match watch.breakpoint.access {
            DataAccess::Write => watch.breakpoint.data.plain(&mut self.controller),
            DataAccess::Read | DataAccess::ReadWrite => None,
        });
        let watch = plain.collect::<Option<_>>().filter(|_| !self.data.is_empty()).map(Arc::new);
        self.controller.vm.watch_data(watch);
    }

    /// Returns how finely a cycle has to stop so that no access to watched data is missed.
    pub(crate) fn watch_of_data(&self) -> CycleWatch {
        match self.controller.vm.watches_data() {
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
        for watch in self.data.all.iter_mut().filter(|watch| watch.over.is_none()) {
            let DataBreakpoint { data, access, .. } = &watch.breakpoint;
            let now = data.digest(&mut self.controller);
            let is_read = match (task.zip(line), data.as_signal()) {
                _ if *access == DataAccess::Write => false,
                (None, _) => false,
                (Some((task, _)), Some(signal)) => signal_reads.contains(&(task, signal)),
                (Some((task, BegunLine { frame, op })), None) => data.is_read(&mut self.controller, task, frame, op),
            };
            let has_changed = now != watch.seen;
            let is_over = now.is_none() && data.is_local();
            has_any_changed |= has_changed || is_over;
            let mut old = watch.text.clone();
            if has_changed {
                let text = data.text(&mut self.controller);
                old = std::mem::replace(&mut watch.text, text);
                watch.seen = now;
            }
            if is_over {
                watch.over = Some(moment);
                continue;
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
            self.watch_plain_data();
        }
        if changes.is_empty() {
            return None;
        }
        let line = line.and_then(|line| task_frame(&self.controller.vm, &line.frame, line.op));
        Some(Stop::Data(Box::new(DataStop { task, line, changes })))
    }

    /// Returns the breakpoints on local variables whose program has ended, so that they no longer stop the run.
    #[must_use]
    pub fn ended_data(&self) -> BTreeSet<BreakpointId> {
        self.data.all.iter().filter(|watch| watch.over.is_some()).map(|watch| watch.breakpoint.id).collect()
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
