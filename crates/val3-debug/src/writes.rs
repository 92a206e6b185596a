//! Writes of watched data in the recorded history.
//!
//! The history is replayed snapshot by snapshot, the newest part first, and the value is compared bit by bit after each
//! line. A line that writes the present value is no write here, as for data breakpoints.

use std::collections::{BTreeMap, VecDeque};
use std::sync::Arc;

use val3_lang::ports::{TaskNumber, Time};
use val3_machine::controller::RunStatus;
use val3_vm::{CycleWatch, DataWatch, Vm};

use crate::backwards::{Watcher, fraction};
use crate::debugger::Debugger;
use crate::frames::{TaskFrame, task_frame};
use crate::history::Moment;
use crate::watched::{DataForm, Digest, WatchedData};

/// A write that has changed watched data.
#[derive(Debug, Clone, PartialEq)]
pub struct DataWrite {
    /// Controller clock after the write, in ns.
    pub time: Time,
    /// Name of the task whose line wrote; `None` for a change from outside, for example by an input or the debugger.
    pub task: Option<String>,
    /// The line that wrote.
    pub line: Option<TaskFrame>,
    /// New value, or a text for data that are no longer in memory.
    pub value: String,
    /// Numbers of the new value, in the order of [`DataForm::series`]; empty for data that are no longer in memory. A
    /// number is `None` if it is not finite, or if the signal of an input or output cannot be read.
    pub numbers: Vec<Option<f64>>,
}

/// Value of the data before the first write.
#[derive(Debug, Clone, PartialEq)]
pub struct InitialValue {
    /// Controller clock since which the value is known, in ns: the beginning of the history, or of a local variable's
    /// program.
    pub time: Time,
    /// The value.
    pub value: String,
    /// Numbers of the value, as in [`DataWrite::numbers`].
    pub numbers: Vec<Option<f64>>,
}

/// Recorded writes of watched data.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct DataWrites {
    /// Writes, the newest first.
    pub writes: Vec<DataWrite>,
    /// Value before the first write. `None` if there are writes before [`writes`](Self::writes), or if the search has
    /// ended before the beginning of the history.
    pub initial: Option<InitialValue>,
    /// Controller clock since which all writes were searched, in ns.
    pub since: Time,
    /// Type and numbers of the data; `None` if the data were never in memory at a write.
    pub form: Option<DataForm>,
}

/// End of a search for writes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct WriteLimits {
    /// Largest number of writes.
    pub writes: usize,
    /// Number of replayed lines after which no further part of the history is replayed. A part with more than
    /// [`LINES_FACTOR`] times this number is abandoned, because the time between two snapshots can be long.
    pub lines: u64,
}

/// Number of lines in one part of the history, as a multiple of [`WriteLimits::lines`].
const LINES_FACTOR: u64 = 5;

impl WriteLimits {
    /// Limits only the number of writes.
    #[must_use]
    pub const fn writes(writes: usize) -> Self {
        Self { writes, lines: u64::MAX }
    }

    const fn lines_in_part(self) -> u64 {
        self.lines.saturating_mul(LINES_FACTOR)
    }
}

/// Value of watched data at a moment.
#[derive(Clone)]
struct MomentValue {
    /// The value; `None` if it is not in memory.
    digest: Option<Digest>,
    text: String,
    numbers: Vec<Option<f64>>,
    /// Whether the stack frame of a local variable exists; `true` for other data.
    exists: bool,
}

/// Writes within a part of the history, in chronological order.
struct PartWrites {
    /// The last writes, at most as many as requested and one more.
    writes: VecDeque<DataWrite>,
    limit: usize,
    /// Value before the first write.
    initial: InitialValue,
    /// Type and numbers of the data; `None` until the data are in memory.
    form: Option<DataForm>,
    /// Present value; `None` if it is not in memory.
    seen: Option<Digest>,
    /// Whether the stack frame of a local variable exists.
    exists: bool,
    /// Whether a local variable's program has begun within this part.
    has_begun: bool,
    /// Task names, also of tasks that end within this part.
    names: BTreeMap<TaskNumber, String>,
}

impl Debugger {
    /// Returns the last writes of the data before the present moment, within limits. The run stays at its moment.
    /// Returns `None` if the run is not recorded, or if the watcher cancels the search.
    pub fn writes(&mut self, data: &WatchedData, limits: WriteLimits, watcher: Watcher<'_>) -> Option<DataWrites> {
        self.history.as_ref()?;
        let present = self.controller.snapshot();
        let hits = self.breakpoints.hits.clone();
        let (watches, contacts) = (std::mem::take(&mut self.data), std::mem::take(&mut self.contacts));
        let found = self.search_writes(data, limits, watcher);
        self.controller.restore(&present);
        (self.breakpoints.hits, self.data, self.contacts) = (hits, watches, contacts);
        self.restore_marks();
        self.settle_data();
        found
    }

    /// Returns the present value.
    fn present(&mut self, data: &WatchedData) -> MomentValue {
        let exists = data.has_frame(&self.controller);
        let controller = &mut self.controller;
        let (digest, text, numbers) = (data.digest(controller), data.text(controller), data.numbers(controller));
        MomentValue { digest, text, numbers, exists }
    }

    fn search_writes(&mut self, data: &WatchedData, limits: WriteLimits, watcher: Watcher<'_>) -> Option<DataWrites> {
        let WriteLimits { writes: count, lines: mut lines_left } = limits;
        let present = Moment::of(&self.controller);
        let past = present.time - self.first_moment().map_or(0, |first| first.time);
        let mut later = self.present(data);
        let form = data.form(&mut self.controller);
        let initial = Some(InitialValue::new(present.time, &later));
        let mut all = DataWrites { initial, form, since: present.time, ..DataWrites::default() };
        let mut end = present;
        'parts: while all.writes.len() <= count
            && let Some(start) = self.restore_earlier(end)
        {
            let first = self.present(data);
            let mut part = PartWrites::new(start.time, &first, count + 1, all.form.take());
            part.keep_names(&self.controller.vm);
            self.watch_return(data);
            let mut lines_in_part = 0_u64;
            while let Some(task) = self.replay_line(end) {
                lines_in_part += 1;
                if lines_in_part > limits.lines_in_part() {
                    // The last writes of the part are unknown, so the earlier ones are no result.
                    (all.initial, all.form) = (None, part.form);
                    break 'parts;
                }
                part.follow(self, data, task);
                lines_left = lines_left.saturating_sub(1);
                let searched = (present.time - end.time) + (self.controller.now() - start.time);
                if watcher(fraction(searched, past)).is_break() {
                    return None;
                }
            }
            // A change by the debugger at the end of the part is not repeated by a replay.
            if (&part.seen, part.exists) != (&later.digest, later.exists) {
                let MomentValue { text: value, numbers, .. } = later;
                let write = DataWrite { time: end.time, task: None, line: None, value, numbers };
                part.add(write, later.digest, later.exists);
            }
            all.writes.extend(part.writes.into_iter().rev());
            (all.since, all.initial, all.form) = (start.time, Some(part.initial), part.form);
            if part.has_begun {
                break;
            }
            (end, later) = (start, first);
            if lines_left == 0 && self.first_moment() != Some(start) {
                all.initial = None;
                break;
            }
        }
        if all.writes.len() > count {
            all.writes.truncate(count);
            all.initial = None;
        }
        Some(all)
    }

    /// Lets tasks stop before a return from a local variable's program.
    fn watch_return(&mut self, data: &WatchedData) {
        let watch = DataWatch { frames: data.owner().into_iter().collect(), ..DataWatch::default() };
        self.controller.vm.watch_data(Some(Arc::new(watch)));
    }

    /// Replays a line of a task, or the time until something happens, towards `end`. Returns the task; `None` at `end`.
    fn replay_line(&mut self, end: Moment) -> Option<Option<TaskNumber>> {
        if !self.controller.is_within_cycle() && self.controller.now() < end.time {
            // The cycle begins separately, because its new inputs are no writes of the first line.
            let limit = self.controller.now();
            self.controller.set_limit(Some(limit));
            self.controller.step();
            self.controller.set_limit(None);
            drop(self.controller.devices.take_events());
            if self.controller.is_within_cycle() {
                return Some(None);
            }
        }
        Some(match self.replay(CycleWatch::Lines, end)?.status {
            RunStatus::Seen(task) => Some(task),
            RunStatus::AtStop(task) if self.controller.vm.is_after_line(task) => Some(task),
            _ => None,
        })
    }
}

impl InitialValue {
    fn new(time: Time, MomentValue { text, numbers, .. }: &MomentValue) -> Self {
        Self { time, value: text.clone(), numbers: numbers.clone() }
    }
}

impl PartWrites {
    /// `first` is the value at the beginning of the part.
    fn new(time: Time, first: &MomentValue, limit: usize, form: Option<DataForm>) -> Self {
        Self {
            writes: VecDeque::new(),
            limit,
            initial: InitialValue::new(time, first),
            form,
            seen: first.digest.clone(),
            exists: first.exists,
            has_begun: false,
            names: BTreeMap::new(),
        }
    }

    /// Stores all task names.
    fn keep_names(&mut self, vm: &Vm) {
        for task in vm.tasks() {
            self.names.entry(task.id).or_insert_with(|| task.name.clone());
        }
    }

    /// Adds the write of the last line if the data have changed. `task` executed the line.
    fn follow(&mut self, debugger: &mut Debugger, data: &WatchedData, task: Option<TaskNumber>) {
        let line = task.and_then(|_| debugger.controller.vm.last_line());
        self.keep_names(&debugger.controller.vm);
        let controller = &mut debugger.controller;
        let now = data.digest(controller);
        let exists = data.has_frame(controller);
        if now == self.seen && exists == self.exists {
            return;
        }
        if self.form.is_none() {
            self.form = data.form(controller);
        }
        let (value, numbers) = (data.text(controller), data.numbers(controller));
        let line = line.and_then(|line| task_frame(&controller.vm, &line.frame, line.op));
        let line = line.filter(|line| !line.is_console);
        let task = task.and_then(|task| self.names.get(&task).cloned());
        self.add(DataWrite { time: controller.now(), task, line, value, numbers }, now, exists);
    }

    fn add(&mut self, write: DataWrite, now: Option<Digest>, exists: bool) {
        self.seen = now;
        if !std::mem::replace(&mut self.exists, exists) && exists {
            // The local variable begins to exist here. The earlier writes were to another call's variable in its place.
            self.writes.clear();
            self.has_begun = true;
            self.initial = InitialValue { time: write.time, value: write.value, numbers: write.numbers };
            return;
        }
        self.writes.push_back(write);
        if self.writes.len() > self.limit {
            self.writes.pop_front();
        }
    }
}

#[cfg(test)]
mod tests {
    use std::ops::ControlFlow;

    use val3_tests::running::Running;
    use val3_vm::FragmentContext;

    use super::*;
    use crate::contacts::Contact;
    use crate::debugger::{AdvanceResult, Stop};
    use crate::history::PastLimits;

    #[test]
    fn a_contact_stops_the_run_also_after_a_search_of_writes() {
        let listing = "num nCount\nprogram start()\nbegin\n  while true\n    nCount=nCount+1\n  endWhile\nend\n";
        let mut debugger = Debugger::new(Running::start(listing).controller);
        debugger.record(PastLimits::default());
        for _ in 0..2 {
            debugger.advance();
        }
        let names = ["rod", "wall"].map(str::to_owned);
        let contacts = vec![Contact { names, depth: 1.0, at_start: false, of: None }];
        debugger.contacts.clone_from(&contacts);
        let task = debugger.controller.vm.tasks()[0].id;
        let count = WatchedData::new(&mut debugger.controller, FragmentContext::Frame(task, 0), "nCount").unwrap();
        let found = debugger.writes(&count, WriteLimits::writes(9), &mut |_| ControlFlow::Continue(())).unwrap();
        assert!(!found.writes.is_empty());
        assert_eq!(debugger.advance(), AdvanceResult::Stopped(Stop::Contacts(contacts)));
    }

    #[test]
    fn a_part_of_the_history_with_too_many_lines_is_abandoned() {
        let listing = "num nCount\nprogram start()\nbegin\n  while true\n    nCount=nCount+1\n  endWhile\nend\n";
        let mut debugger = Debugger::new(Running::start(listing).controller);
        debugger.record(PastLimits::default());
        for _ in 0..5 {
            debugger.advance();
        }
        let (now, task) = (debugger.controller.now(), debugger.controller.vm.tasks()[0].id);
        let count = WatchedData::new(&mut debugger.controller, FragmentContext::Frame(task, 0), "nCount").unwrap();
        let mut search = |lines| {
            let mut replayed = 0;
            let mut watcher = |_: f64| {
                replayed += 1;
                ControlFlow::Continue(())
            };
            let found = debugger.writes(&count, WriteLimits { writes: 9, lines }, &mut watcher).unwrap();
            (found, replayed)
        };
        let (found, replayed) = search(2);
        assert_eq!((found.writes, found.initial, found.since, replayed), (Vec::new(), None, now, 2 * LINES_FACTOR));
        assert_eq!(search(1_000_000).0.writes.len(), 9);
        assert_eq!(debugger.controller.now(), now);
    }
}
