//! Synchronous tasks: the first part of a cycle (5.5, 5.6).

use std::collections::VecDeque;

use val3_lang::ports::{TaskNumber, Time};

use super::{CycleFlow, Schedule};
use crate::{Grant, Host, Rate, Task, TurnEnd, Vm};

/// Largest number of lines that a synchronous task executes in a cycle (5.5).
const SYNCHRONOUS_LINES: u32 = 3000;

/// Synchronous tasks that are due in a cycle and have not had their turn.
#[derive(Debug, Clone)]
pub(super) struct DueTasks {
    /// Tasks with their periods in ns, the next one first.
    tasks: VecDeque<(Time, TaskNumber)>,
    /// Turn that has begun and not ended.
    turn: Option<SynchronousTurn>,
}

/// A turn of a synchronous task that has begun.
#[derive(Debug, Clone, Copy)]
struct SynchronousTurn {
    id: TaskNumber,
    period: Time,
    start: Time,
    /// Number of lines that may still be executed.
    lines: u32,
    /// Whether the turn ends here.
    is_over: bool,
}

impl DueTasks {
    pub(super) fn is_empty(&self) -> bool {
        self.tasks.is_empty()
    }
}

impl Schedule {
    /// Returns the due synchronous tasks: short periods first, then in the order of creation.
    pub(super) fn due_tasks(&self, vm: &Vm) -> DueTasks {
        let mut due: Vec<(Time, TaskNumber)> = vm.tasks().iter().filter_map(|task| self.due(task)).collect();
        due.sort_unstable();
        DueTasks { tasks: due.into(), turn: None }
    }

    fn due(&self, task: &Task) -> Option<(Time, TaskNumber)> {
        match task.rate {
            Rate::Period { period, next, .. } if next <= self.now && task.can_run() => Some((period, task.id)),
            _ => None,
        }
    }

    /// Runs each due task's turn.
    pub(super) fn synchronous(&mut self, due: &mut DueTasks, vm: &mut Vm, host: &mut dyn Host) -> CycleFlow {
        loop {
            if due.turn.is_none() {
                due.turn = self.begin_turn(&mut due.tasks, vm);
            }
            let Some(turn) = &mut due.turn else { return CycleFlow::Continue(()) };
            self.synchronous_turn(turn, vm, host)?;
            if self.now - turn.start > turn.period {
                self.skip_period(vm, turn.id);
            }
            due.turn = None;
        }
    }

    /// Begins the turn of the next task that earlier tasks have not halted or killed.
    fn begin_turn(&self, due: &mut VecDeque<(Time, TaskNumber)>, vm: &mut Vm) -> Option<SynchronousTurn> {
        while let Some((period, id)) = due.pop_front() {
            if can_run(vm, id) {
                self.begin_period(vm, id);
                return Some(SynchronousTurn { id, period, start: self.now, lines: SYNCHRONOUS_LINES, is_over: false });
            }
        }
        None
    }

    /// Executes the lines of a turn. An instruction that uses time outside the program delays the rest of the cycle.
    fn synchronous_turn(&mut self, turn: &mut SynchronousTurn, vm: &mut Vm, host: &mut dyn Host) -> CycleFlow {
        while !turn.is_over && can_run(vm, turn.id) {
            self.check_limit()?;
            let lines = turn.lines.min(self.lines_until_stop(turn.id, vm));
            let report = vm.turn(turn.id, Grant::once(lines), self.now, self.line_cost, host);
            self.now += Time::from(report.lines) * self.line_cost;
            turn.lines = turn.lines.saturating_sub(report.lines);
            if let Some(end) = report.end.cycle_end() {
                return CycleFlow::Break(end);
            }
            match report.end {
                TurnEnd::Busy => turn.is_over = turn.lines == 0,
                TurnEnd::Pausing(wake) => {
                    self.now = self.now.max(wake);
                    self.check_interrupts(host)?;
                }
                _ => turn.is_over = true,
            }
            self.check_watch(turn.id, &report)?;
        }
        CycleFlow::Continue(())
    }

    /// Reports to the task whether its last period was too short (5.6), and sets the beginning of the next period.
    fn begin_period(&self, vm: &mut Vm, id: TaskNumber) {
        let Some(Rate::Period { period, next, overrun, late, .. }) = vm.rate_mut(id) else { return };
        let (overrun, was_late) = (*overrun, std::mem::take(late));
        *next = (self.now / *period + 1) * *period;
        // Writing fails if the variable was in a library that was unloaded.
        let _ = vm.space.memory.set_num(overrun, 0, f64::from(u8::from(was_late)));
    }

    /// Skips the next period of a task that has overrun (5.6).
    fn skip_period(&self, vm: &mut Vm, id: TaskNumber) {
        if let Some(Rate::Period { period, next, late, overruns, .. }) = vm.rate_mut(id) {
            *late = true;
            *overruns = overruns.saturating_add(1);
            *next = (self.now / *period + 1) * *period;
        }
    }

    /// Skips the periods of halted tasks, so that a resumed task continues at the beginning of a period.
    pub(super) fn pass_periods(&self, vm: &mut Vm) {
        let halted = vm.tasks().iter().filter(|task| !task.can_run());
        let passed = halted.filter(|task| matches!(task.rate, Rate::Period { next, .. } if next <= self.now));
        let passed: Vec<TaskNumber> = passed.map(|task| task.id).collect();
        for id in passed {
            if let Some(Rate::Period { period, next, .. }) = vm.rate_mut(id) {
                *next = (self.now / *period + 1) * *period;
            }
        }
    }
}

fn can_run(vm: &Vm, id: TaskNumber) -> bool {
    vm.tasks().iter().any(|task| task.id == id && task.can_run())
}
