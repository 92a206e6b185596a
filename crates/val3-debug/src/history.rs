//! The past of a run: snapshots, between which it is executed again.

use std::collections::VecDeque;

use val3_lang::ports::{TaskNumber, Time};
use val3_machine::controller::{Controller, Snapshot};
use val3_vm::CYCLE;

use crate::breakpoints::Hits;

/// The greatest number of cycles with busy tasks between two snapshots. They are executed again within some milliseconds.
const CYCLES: u32 = 16;

/// A moment of a run. The controller's clock tells all lines apart, because each takes time.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Moment {
    /// The controller's clock, in nanoseconds.
    pub time: Time,
    /// Whether a cycle that begins at this time has begun.
    pub(crate) is_within_cycle: bool,
}

impl Moment {
    pub(crate) fn of(controller: &Controller) -> Self {
        Self { time: controller.now(), is_within_cycle: controller.is_within_cycle() }
    }
}

/// How much of the past is kept.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PastLimits {
    /// The number of snapshots.
    pub snapshots: usize,
    /// The bytes of all snapshots and of the inputs recorded since the first one, as estimated. The last snapshot is kept in
    /// any case.
    pub bytes: u64,
}

impl Default for PastLimits {
    fn default() -> Self {
        Self { snapshots: 200, bytes: 256 << 20 }
    }
}

impl PastLimits {
    /// A number of snapshots of usual size.
    #[must_use]
    pub fn snapshots(snapshots: usize) -> Self {
        Self { snapshots, ..Self::default() }
    }
}

/// How far a run can go back.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Reach {
    /// The earliest moment.
    pub first: Moment,
    /// The time from there to now, in nanoseconds.
    pub time: Time,
    /// The same in cycles of the controller.
    pub cycles: u64,
    /// Whether the earliest moment is the beginning of the run.
    pub is_whole: bool,
    /// The snapshots that are kept.
    pub snapshots: usize,
    /// Their bytes and those of the recorded inputs, as estimated.
    pub bytes: u64,
}

/// The state of a run at a moment.
#[derive(Debug)]
pub(crate) struct Point {
    pub(crate) moment: Moment,
    pub(crate) snapshot: Snapshot,
    /// The hits of breakpoints until then.
    pub(crate) hits: Hits,
    /// The task that had executed a line last, as far as known.
    last: Option<TaskNumber>,
    cause: Cause,
    bytes: u64,
}

/// Why a snapshot was taken.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Cause {
    /// Some cycles have passed.
    Time,
    /// Something outside of the run has changed it, which no replay repeats.
    Change,
    /// As `Change`: a line has released the arm, and is over only at the next `Arrival`.
    Release,
    /// As `Change`: the arm has arrived, or does not move on.
    Arrival,
}

/// Snapshots of a run in the order of time.
#[derive(Debug)]
pub(crate) struct History {
    points: VecDeque<Point>,
    /// The bytes of the inputs that were recorded from the first snapshot to the last one.
    input_bytes: u64,
    limits: PastLimits,
    /// Cycles since the last snapshot.
    cycles: u32,
    /// The latest moment that the run has been at since the last change from outside.
    latest: Option<Moment>,
}

impl History {
    /// The past of a run that begins now. Older snapshots are thinned out, so that the limits hold. While those of changes
    /// leave room, the first one stays.
    pub(crate) fn new(controller: &mut Controller, hits: &Hits, limits: PastLimits) -> Self {
        let mut history = Self { points: VecDeque::new(), input_bytes: 0, limits, cycles: 0, latest: None };
        history.add(controller, hits, Cause::Time);
        history
    }

    pub(crate) const fn limits(&self) -> PastLimits {
        self.limits
    }

    /// A cycle is over.
    pub(crate) fn pass_cycle(&mut self, controller: &mut Controller, hits: &Hits) {
        self.cycles += 1;
        let is_new = self.points.back().is_none_or(|last| last.moment < Moment::of(controller));
        let is_due = self.cycles >= CYCLES || controller.input_bytes() > self.input_bytes + self.limits.bytes / 16;
        if is_due && is_new {
            self.add(controller, hits, Cause::Time);
        }
    }

    /// Something outside of the run has changed it: what was recorded after this moment is no longer its future.
    pub(crate) fn begin_new_future(
        &mut self,
        controller: &mut Controller,
        hits: &Hits,
        last: Option<TaskNumber>,
        cause: Cause,
    ) {
        let now = Moment::of(controller);
        self.points.retain(|point| point.moment < now);
        self.latest = None;
        self.add(controller, hits, cause);
        if let Some(point) = self.points.back_mut() {
            point.last = last;
        }
    }

    /// The run leaves a moment to go back.
    pub(crate) fn leave(&mut self, moment: Moment) {
        self.latest = self.latest.max(Some(moment));
    }

    /// Whether a moment is in the past: what followed it is known.
    pub(crate) fn is_past(&self, moment: Moment) -> bool {
        self.latest > Some(moment)
    }

    fn add(&mut self, controller: &mut Controller, hits: &Hits, cause: Cause) {
        self.cycles = 0;
        let (moment, snapshot) = (Moment::of(controller), controller.snapshot());
        let bytes = snapshot.bytes();
        self.points.push_back(Point { moment, snapshot, hits: hits.clone(), last: None, cause, bytes });
        self.input_bytes = controller.input_bytes();
        self.trim(controller);
    }

    /// Removes snapshots until the limits hold. Inputs are only forgotten with the oldest ones.
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

    /// Removes every second snapshot of the older half: the distances grow with the age.
    ///
    /// Snapshots of changes stay, because a replay from before them would not repeat the change. If too many are left, the
    /// past begins later.
    fn thin(&mut self) {
        let half = self.points.len() / 2;
        let mut number = 0;
        self.points.retain(|point| {
            number += 1;
            number > half || number % 2 == 1 || point.cause != Cause::Time
        });
    }

    /// How far the run can go back from a moment.
    pub(crate) fn reach(&self, now: Moment) -> Option<Reach> {
        let first = self.first()?;
        let time = now.time.saturating_sub(first.time);
        Some(Reach {
            first,
            time,
            cycles: time / CYCLE,
            is_whole: first.time == 0,
            snapshots: self.points.len(),
            bytes: self.bytes(),
        })
    }

    /// The moment at which a line is over that is executed until this one: later if it releases the arm.
    pub(crate) fn end_of_line(&self, moment: Moment) -> Option<Moment> {
        let is_release = |point: &&Point| point.moment == moment && point.cause == Cause::Release;
        if !self.before(moment).is_some_and(|point| is_release(&point)) {
            return Some(moment);
        }
        let mut later = self.points.iter().filter(|point| point.moment > moment);
        later.find(|point| point.cause == Cause::Arrival).map(|arrival| arrival.moment)
    }

    /// The last snapshot at a moment or before it.
    pub(crate) fn before(&self, moment: Moment) -> Option<&Point> {
        self.points.iter().rev().find(|point| point.moment <= moment)
    }

    /// The last snapshot earlier than a moment.
    pub(crate) fn earlier(&self, moment: Moment) -> Option<&Point> {
        self.points.iter().rev().find(|point| point.moment < moment)
    }

    /// The task that had executed a line last when something outside changed the run at a moment.
    pub(crate) fn changed_at(&self, moment: Moment) -> Option<TaskNumber> {
        self.before(moment).filter(|point| point.moment == moment && point.cause == Cause::Change)?.last
    }

    /// The beginning of the past.
    pub(crate) fn first(&self) -> Option<Moment> {
        self.points.front().map(|point| point.moment)
    }
}
