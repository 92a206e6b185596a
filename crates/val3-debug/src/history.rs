//! History of a run: snapshots, between which the run is replayed.

use std::collections::VecDeque;

use val3_lang::ports::{TaskNumber, Time};
use val3_machine::controller::{Controller, Snapshot};
use val3_vm::CYCLE;

use crate::breakpoints::Hits;

/// Largest number of cycles with busy tasks between two snapshots. They are replayed within some milliseconds.
const CYCLES: u32 = 16;

/// A moment of a run. The controller's clock distinguishes all lines, because the clock advances with each line.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Moment {
    /// Controller clock, in ns.
    pub time: Time,
    /// Whether a cycle that begins at this time has begun.
    pub(crate) is_within_cycle: bool,
}

impl Moment {
    pub(crate) fn of(controller: &Controller) -> Self {
        Self { time: controller.now(), is_within_cycle: controller.is_within_cycle() }
    }
}

/// Limits of the recorded history.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PastLimits {
    /// Largest number of snapshots.
    pub snapshots: usize,
    /// Largest estimated size of all snapshots and of the inputs recorded since the first one, in bytes. The last
    /// snapshot is always kept.
    pub bytes: u64,
}

impl Default for PastLimits {
    fn default() -> Self {
        Self { snapshots: 200, bytes: 256 << 20 }
    }
}

impl PastLimits {
    /// Limits the number of snapshots, with the default limit of bytes.
    #[must_use]
    pub fn snapshots(snapshots: usize) -> Self {
        Self { snapshots, ..Self::default() }
    }
}

/// Extent of the recorded history.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct HistoryExtent {
    /// Earliest moment.
    pub first: Moment,
    /// Time from the earliest moment to the present, in ns.
    pub time: Time,
    /// The same time in controller cycles.
    pub cycles: u64,
    /// Whether the earliest moment is the beginning of the run.
    pub is_whole: bool,
    /// Number of snapshots.
    pub snapshots: usize,
    /// Estimated size of the snapshots and the recorded inputs, in bytes.
    pub bytes: u64,
}

/// Snapshot of the run at a moment.
#[derive(Debug)]
pub(crate) struct Checkpoint {
    pub(crate) moment: Moment,
    pub(crate) snapshot: Snapshot,
    /// Hit counts at the moment.
    pub(crate) hits: Hits,
    /// Task that had executed the last line; `None` if unknown.
    last: Option<TaskNumber>,
    cause: SnapshotReason,
    bytes: u64,
}

/// Reason for a snapshot.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum SnapshotReason {
    /// Some cycles have passed.
    Time,
    /// The run was changed from outside, which a replay does not repeat.
    Change,
    /// Like `Change`: a line has released the arm. The line ends at the next `Arrival`.
    Release,
    /// Like `Change`: the arm has arrived, or does not continue.
    Arrival,
}

/// Snapshots of a run in chronological order.
#[derive(Debug)]
pub(crate) struct History {
    points: VecDeque<Checkpoint>,
    /// Size of the inputs recorded from the first to the last snapshot, in bytes.
    input_bytes: u64,
    limits: PastLimits,
    /// Cycles since the last snapshot.
    cycles: u32,
    /// Latest moment that the run reached since the last change from outside.
    latest: Option<Moment>,
}

impl History {
    /// Creates the history of a run that begins now. Older snapshots are thinned out to keep the limits. The first one
    /// is kept unless the snapshots of changes exceed the limits by themselves.
    pub(crate) fn new(controller: &mut Controller, hits: &Hits, limits: PastLimits) -> Self {
        let mut history = Self { points: VecDeque::new(), input_bytes: 0, limits, cycles: 0, latest: None };
        history.add(controller, hits, SnapshotReason::Time);
        history
    }

    pub(crate) const fn limits(&self) -> PastLimits {
        self.limits
    }

    /// Counts a cycle, and adds a snapshot if one is due.
    pub(crate) fn pass_cycle(&mut self, controller: &mut Controller, hits: &Hits) {
        self.cycles += 1;
        let is_new = self.points.back().is_none_or(|last| last.moment < Moment::of(controller));
        let is_due = self.cycles >= CYCLES || controller.input_bytes() > self.input_bytes + self.limits.bytes / 16;
        if is_due && is_new {
            self.add(controller, hits, SnapshotReason::Time);
        }
    }

    /// Discards the snapshots from the present moment on, and adds a new one: a change from outside has made the
    /// recorded future invalid.
    pub(crate) fn begin_new_future(
        &mut self,
        controller: &mut Controller,
        hits: &Hits,
        last: Option<TaskNumber>,
        cause: SnapshotReason,
    ) {
        let now = Moment::of(controller);
        self.points.retain(|point| point.moment < now);
        self.latest = None;
        self.add(controller, hits, cause);
        if let Some(point) = self.points.back_mut() {
            point.last = last;
        }
    }

    /// Records the latest moment before the run goes back.
    pub(crate) fn leave(&mut self, moment: Moment) {
        self.latest = self.latest.max(Some(moment));
    }

    /// Whether the run has already been later than this moment.
    pub(crate) fn is_past(&self, moment: Moment) -> bool {
        self.latest > Some(moment)
    }

    fn add(&mut self, controller: &mut Controller, hits: &Hits, cause: SnapshotReason) {
        self.cycles = 0;
        let (moment, snapshot) = (Moment::of(controller), controller.snapshot());
        let bytes = snapshot.bytes();
        self.points.push_back(Checkpoint { moment, snapshot, hits: hits.clone(), last: None, cause, bytes });
        self.input_bytes = controller.input_bytes();
        self.trim(controller);
    }

    /// Removes snapshots until the limits hold. Inputs are discarded only together with the oldest snapshots.
    fn trim(&mut self, controller: &mut Controller) {
        let mut before = usize::MAX;
        while self.is_beyond_limits(self.snapshot_bytes()) && self.points.len() < before {
            before = self.points.len();
            self.thin();
        }
        while self.is_beyond_limits(self.bytes()) && self.points.len() > 1 {
            self.points.pop_front();
            if let Some(first) = self.points.front() {
                controller.forget_inputs_before(&first.snapshot);
                self.input_bytes = controller.input_bytes();
            }
        }
    }

    fn is_beyond_limits(&self, bytes: u64) -> bool {
        self.points.len() > self.limits.snapshots.max(2) || bytes > self.limits.bytes
    }

    fn bytes(&self) -> u64 {
        self.snapshot_bytes() + self.input_bytes
    }

    fn snapshot_bytes(&self) -> u64 {
        self.points.iter().map(|point| point.bytes).sum()
    }

    /// Removes every second snapshot of the older half, so that the distance between snapshots grows with their age.
    ///
    /// Snapshots of changes remain, because a replay from an earlier snapshot would not repeat the change. If they
    /// exceed the limits, [`trim`](Self::trim) removes the oldest snapshots.
    fn thin(&mut self) {
        let half = self.points.len() / 2;
        let mut number = 0;
        self.points.retain(|point| {
            number += 1;
            number > half || number % 2 == 1 || point.cause != SnapshotReason::Time
        });
    }

    /// Returns the extent of the history before `now`.
    pub(crate) fn reach(&self, now: Moment) -> Option<HistoryExtent> {
        let first = self.first()?;
        let time = now.time.saturating_sub(first.time);
        Some(HistoryExtent {
            first,
            time,
            cycles: time / CYCLE,
            is_whole: first.time == 0,
            snapshots: self.points.len(),
            bytes: self.bytes(),
        })
    }

    /// Returns the end of the line that runs until `moment`, which is later if the line releases the arm.
    pub(crate) fn end_of_line(&self, moment: Moment) -> Option<Moment> {
        let last = self.before(moment);
        if !last.is_some_and(|point| point.moment == moment && point.cause == SnapshotReason::Release) {
            return Some(moment);
        }
        let mut later = self.points.iter().filter(|point| point.moment > moment);
        later.find(|point| point.cause == SnapshotReason::Arrival).map(|arrival| arrival.moment)
    }

    /// Returns the last snapshot at or before a moment.
    pub(crate) fn before(&self, moment: Moment) -> Option<&Checkpoint> {
        self.points.iter().rev().find(|point| point.moment <= moment)
    }

    /// Returns the last snapshot before a moment.
    pub(crate) fn earlier(&self, moment: Moment) -> Option<&Checkpoint> {
        self.points.iter().rev().find(|point| point.moment < moment)
    }

    /// Returns the task that had executed the last line before a change from outside at this moment.
    pub(crate) fn changed_at(&self, moment: Moment) -> Option<TaskNumber> {
        self.before(moment).filter(|point| point.moment == moment && point.cause == SnapshotReason::Change)?.last
    }

    /// Whether a change from outside is recorded at this moment.
    pub(crate) fn has_change_at(&self, moment: Moment) -> bool {
        self.points.iter().any(|point| point.moment == moment && point.cause == SnapshotReason::Change)
    }

    /// Returns the moment of the first snapshot.
    pub(crate) fn first(&self) -> Option<Moment> {
        self.points.front().map(|point| point.moment)
    }
}
