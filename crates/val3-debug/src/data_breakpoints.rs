//! Data breakpoints: the run stops after a line that has changed or read a value, and when something outside has changed it.
//!
//! While one is set, tasks execute one line at a time, and the watched values are compared bit by bit after each. A line
//! that writes the value that is there already is no change. Reads are found in the operations of the line
//! ([`reads`](crate::reads)); those of signals are noted by the controller. A line that waits reads once, when the wait
//! begins.

use std::collections::BTreeMap;

use val3_lang::ports::TaskNumber;
use val3_machine::controller::Outcome;
use val3_vm::Frame;

use crate::breakpoints::{BreakpointId, HitCondition};
use crate::debugger::{Debugger, Stop};
use crate::frames::{TaskFrame, task_frame};
use crate::history::Moment;
use crate::watched::{Digest, WatchedData};

/// The accesses at which a data breakpoint stops the run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DataAccess {
    /// The value changes.
    Write,
    /// A line reads it.
    Read,
    /// Both.
    ReadWrite,
}

/// A breakpoint that stops the run when a value changes or is read.
#[derive(Debug, Clone, PartialEq)]
pub struct DataBreakpoint {
    /// Its identity, unique among all breakpoints.
    pub id: BreakpointId,
    /// The watched data.
    pub data: WatchedData,
    /// The accesses that count.
    pub access: DataAccess,
    /// At which of these accesses the run stops; at each without one.
    pub hits: Option<HitCondition>,
}

/// A change of watched data, or a line that reads them.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct DataChange {
    /// The breakpoint.
    pub id: BreakpointId,
    /// Whether the value has changed; otherwise it was read.
    pub is_write: bool,
    /// The value before.
    pub old: String,
    /// The value now. Data that are no longer in memory are shown as such.
    pub new: String,
}

/// A stop at data breakpoints.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct DataStop {
    /// The task whose line has made the changes; `None` for a change from outside, such as that of an input.
    pub task: Option<TaskNumber>,
    /// The line. The task is before the next one.
    pub line: Option<TaskFrame>,
    /// The changes.
    pub changes: Vec<DataChange>,
}

/// The data breakpoints of a run, and the values that they have seen.
#[derive(Debug, Default)]
pub(crate) struct DataBreakpoints {
    all: Vec<Watch>,
    /// The line that each task begins next.
    next: BTreeMap<TaskNumber, (Frame, u32)>,
}

#[derive(Debug)]
struct Watch {
    breakpoint: DataBreakpoint,
    /// `None` where it is not in memory.
    seen: Option<Digest>,
    text: String,
    /// When the program of a local variable has ended. The same place may hold the variable of a later call then.
    over: Option<Moment>,
}

impl DataBreakpoints {
    pub(crate) fn is_empty(&self) -> bool {
        self.all.is_empty()
    }
}

impl Debugger {
    /// Replaces the data breakpoints. Those that stay keep their number of hits.
    pub fn set_data_breakpoints(&mut self, breakpoints: Vec<DataBreakpoint>) {
        for before in &self.data.all {
            if breakpoints.iter().all(|breakpoint| breakpoint.id != before.breakpoint.id) {
                self.breakpoints.hits.remove(&before.breakpoint.id);
            }
        }
        let before = std::mem::take(&mut self.data.all);
        let watch = |breakpoint: DataBreakpoint| {
            let same = before.iter().find(|watch| watch.breakpoint.data == breakpoint.data);
            Watch { over: same.and_then(|watch| watch.over), breakpoint, seen: None, text: String::new() }
        };
        self.data.all = breakpoints.into_iter().map(watch).collect();
        self.settle_data();
    }

    /// Takes the present values as known: the caller has changed something, or the run is at another moment.
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
        self.data.next.clear();
        self.keep_lines();
    }

    /// Keeps the lines of tasks that are not known.
    fn keep_lines(&mut self) {
        if self.data.is_empty() {
            return;
        }
        for task in self.controller.vm.tasks() {
            if let Some(frame) = task.thread.frames.last() {
                self.data.next.entry(task.id).or_insert((*frame, task.thread.next));
            }
        }
    }

    /// The changes since the last call, which a task has made or something outside. They count as hits. The stop is that at
    /// the breakpoints whose number of hits is reached, or at all of them.
    pub(crate) fn follow_data(&mut self, task: Option<TaskNumber>, at_each_hit: bool) -> Option<Stop> {
        if self.data.is_empty() {
            return None;
        }
        let line = task.and_then(|task| self.data.next.remove(&task));
        self.keep_lines();
        let signal_reads = self.controller.devices.take_signal_reads();
        let mut changes = Vec::new();
        let moment = Moment::of(&self.controller);
        for watch in self.data.all.iter_mut().filter(|watch| watch.over.is_none()) {
            let DataBreakpoint { data, access, .. } = &watch.breakpoint;
            let now = data.digest(&mut self.controller);
            let reads = |(task, line)| match data.as_signal() {
                Some(signal) => signal_reads.contains(&(task, signal)),
                None => data.is_read(&mut self.controller, task, line),
            };
            let is_read = *access != DataAccess::Write && task.zip(line).is_some_and(reads);
            let has_changed = now != watch.seen;
            let is_over = now.is_none() && data.is_local();
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
            let hit = self.breakpoints.hits.entry(watch.breakpoint.id).or_default();
            *hit += 1;
            let is_wanted = watch.breakpoint.hits.is_none_or(|condition| condition.holds(*hit));
            if at_each_hit || is_wanted {
                changes.push(DataChange { id: watch.breakpoint.id, is_write, old, new: watch.text.clone() });
            }
        }
        if changes.is_empty() {
            return None;
        }
        let line = line.and_then(|(frame, op)| task_frame(&self.controller.vm, &frame, op));
        Some(Stop::Data(Box::new(DataStop { task, line, changes })))
    }

    /// Begins the next cycle without executing a line, and gives the stop for what has changed outside.
    pub(crate) fn begin_watched_cycle(&mut self) -> Option<Stop> {
        if self.data.is_empty() || self.controller.is_within_cycle() || self.travel.is_some() {
            return None;
        }
        let limit = self.controller.limit();
        self.controller.set_limit(Some(self.controller.now()));
        let outcome = self.controller.step();
        self.controller.set_limit(limit);
        debug_assert_eq!(outcome, Outcome::Limit, "no task begins a line");
        self.follow_data(None, false)
    }
}
