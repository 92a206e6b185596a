//! The scheduler: when each task runs (5.4 to 5.7).
//!
//! Time is virtual: every line has the same duration, waiting has none, and the host skips the time during which all
//! tasks wait. In a cycle of 4 ms the due synchronous tasks run first, then the asynchronous tasks in rounds until the
//! cycle ends or all of them wait.
//!
//! A cycle is a value. It can stop within a turn, and the next call resumes it there.

mod asynchronous;
mod synchronous;

use std::ops::ControlFlow;

use val3_lang::ports::{TaskNumber, Time};

use crate::{CycleEnd, Host, TurnEnd, TurnReport, Vm};
use asynchronous::Rounds;
use synchronous::DueTasks;

/// Length of a cycle and unit of periods, in ns: [`PERIOD_STEP`](val3_lang::tasks::PERIOD_STEP).
pub const CYCLE: Time = 4_000_000;

/// Clock and position of the scheduler.
#[derive(Debug, Clone)]
pub struct Schedule {
    /// Controller clock, in ns.
    pub now: Time,
    /// Duration of a line, in ns; at least 1.
    pub line_cost: Time,
    /// Time from which on no line begins. The clock may exceed it by part of a line, and while all tasks wait.
    pub limit: Option<Time>,
    /// Stops of the cycle for the caller to inspect a task.
    pub watch: CycleWatch,
    /// Whether all tasks rest. Time passes meanwhile, and programs cannot detect it.
    pub tasks_rest: bool,
    /// Asynchronous task with the next turn: the first one with this or a higher number.
    next: TaskNumber,
    /// Cycle that has begun and not ended.
    cycle: Option<PartialCycle>,
}

/// Events at which a cycle stops with [`CycleEnd::Seen`], so that the caller can inspect a task.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CycleWatch {
    /// None.
    Nothing,
    /// Run-time errors.
    Failures,
    /// Ends of lines, and run-time errors.
    Lines,
    /// Ends of lines that have changed a [watched value](crate::DataWatch), and run-time errors.
    Changes,
}

/// A cycle that has begun.
#[derive(Debug, Clone)]
struct PartialCycle {
    end: Time,
    /// Whether a synchronous task was due.
    has_due_tasks: bool,
    due: DueTasks,
    /// `None` until the synchronous tasks have had their turns.
    rounds: Option<Rounds>,
}

/// Result for a part of a cycle: the cycle continues, or ends.
type CycleFlow = ControlFlow<CycleEnd>;

impl Schedule {
    /// Creates a scheduler with the clock at 0.
    #[must_use]
    pub fn new(line_cost: Time) -> Self {
        Self {
            now: 0,
            line_cost: line_cost.max(1),
            limit: None,
            watch: CycleWatch::Nothing,
            tasks_rest: false,
            next: TaskNumber(0),
            cycle: None,
        }
    }

    /// Whether a cycle has begun and not ended.
    #[must_use]
    pub fn is_within_cycle(&self) -> bool {
        self.cycle.is_some()
    }

    /// Returns the end of the current or next cycle.
    #[must_use]
    pub fn cycle_end(&self) -> Time {
        self.cycle.as_ref().map_or((self.now / CYCLE + 1) * CYCLE, |cycle| cycle.end)
    }

    /// Runs tasks until the end of the cycle. The last turn may exceed the end by part of a line.
    ///
    /// After an end [within the cycle](CycleEnd::is_within_cycle) the next call resumes it. The cycle then executes
    /// the same lines at the same times as without the stop.
    pub fn cycle(&mut self, vm: &mut Vm, host: &mut dyn Host) -> CycleEnd {
        let mut cycle = self.cycle.take().unwrap_or_else(|| self.begin(vm));
        let end = match self.resume(&mut cycle, vm, host) {
            CycleFlow::Break(end) => end,
            CycleFlow::Continue(()) => CycleEnd::Busy,
        };
        if end.is_within_cycle() {
            self.cycle = Some(cycle);
            return end;
        }
        self.now = self.now.max(cycle.end);
        if cycle.has_due_tasks { CycleEnd::Busy } else { end }
    }

    fn begin(&self, vm: &Vm) -> PartialCycle {
        let due = self.due_tasks(vm);
        PartialCycle { end: self.cycle_end(), has_due_tasks: !due.is_empty(), due, rounds: None }
    }

    fn resume(&mut self, cycle: &mut PartialCycle, vm: &mut Vm, host: &mut dyn Host) -> CycleFlow {
        if self.tasks_rest {
            return CycleFlow::Break(CycleEnd::Waiting(None));
        }
        if cycle.rounds.is_none() {
            self.synchronous(&mut cycle.due, vm, host)?;
            self.pass_periods(vm);
        }
        let rounds = cycle.rounds.get_or_insert_with(|| self.first_round());
        self.asynchronous(rounds, cycle.end, vm, host)
    }

    /// Returns the number of lines that can begin before a time.
    fn lines_until(&self, time: Time) -> u32 {
        u32::try_from(time.saturating_sub(self.now).div_ceil(self.line_cost)).unwrap_or(u32::MAX)
    }

    /// Returns the number of lines that a turn may begin before the cycle stops.
    fn lines_until_stop(&self, task: TaskNumber, vm: &Vm) -> u32 {
        let most = match self.watch {
            CycleWatch::Lines => u32::from(!vm.is_within_line(task) && !vm.is_at_return(task)),
            CycleWatch::Nothing | CycleWatch::Failures | CycleWatch::Changes => u32::MAX,
        };
        self.limit.map_or(most, |limit| self.lines_until(limit).min(most))
    }

    /// Stops the cycle after a turn that the caller watches.
    fn check_watch(&self, task: TaskNumber, turn: &TurnReport) -> CycleFlow {
        let is_seen = match (self.watch, turn.end) {
            (CycleWatch::Nothing, _) => false,
            (_, TurnEnd::Failed(_)) => true,
            (CycleWatch::Failures, _) => false,
            (CycleWatch::Lines, end) => turn.lines > 0 || end == TurnEnd::Busy,
            (CycleWatch::Changes, _) => turn.has_changed_data,
        };
        if is_seen { CycleFlow::Break(CycleEnd::Seen(task)) } else { CycleFlow::Continue(()) }
    }

    /// Stops the cycle between two turns if the host interrupts it or the limit of the run is reached.
    fn check_interrupts(&self, host: &dyn Host) -> CycleFlow {
        if host.is_interrupted() {
            return CycleFlow::Break(CycleEnd::Suspended);
        }
        self.check_limit()
    }

    fn check_limit(&self) -> CycleFlow {
        if self.limit.is_some_and(|limit| self.now >= limit) {
            return CycleFlow::Break(CycleEnd::Limit);
        }
        CycleFlow::Continue(())
    }
}
