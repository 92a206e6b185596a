//! Asynchronous tasks: the second part of a cycle (5.4).

use val3_lang::ports::{TaskNumber, Time};

use super::{CycleFlow, Schedule};
use crate::{CycleEnd, Grant, Host, Rate, Task, TurnEnd, Vm};

/// Rounds of a cycle. In a round each task that can run has one turn.
#[derive(Debug, Clone)]
pub(super) struct Rounds {
    /// Whether a task has run in this cycle.
    any: bool,
    round: Round,
    /// Task whose turn was suspended within a line.
    suspended: Option<TaskNumber>,
}

/// Activity of the tasks in the present round.
#[derive(Debug, Clone, Copy, Default)]
struct Round {
    has_run: bool,
    reads_clock: bool,
}

impl Schedule {
    /// Returns the first round of a cycle. A round that the end of the previous cycle interrupted counts as active,
    /// because it does not show that all tasks wait.
    pub(super) fn first_round(&self) -> Rounds {
        let round = Round { has_run: self.next != TaskNumber(0), reads_clock: false };
        Rounds { any: false, round, suspended: None }
    }

    /// Runs turns of tasks until the cycle ends or all tasks wait.
    pub(super) fn asynchronous(
        &mut self,
        rounds: &mut Rounds,
        end: Time,
        vm: &mut Vm,
        host: &mut dyn Host,
    ) -> CycleFlow {
        if let Some(id) = rounds.suspended.take()
            && let Some((id, grant)) = self.suspended_turn(id, vm, end)
        {
            self.asynchronous_turn(rounds, id, grant, vm, host)?;
        }
        while self.now < end {
            self.check_limit()?;
            match self.next_turn(vm, end) {
                Some((id, grant)) => self.asynchronous_turn(rounds, id, grant, vm, host)?,
                None => self.end_round(rounds, end, vm)?,
            }
        }
        CycleFlow::Continue(())
    }

    fn asynchronous_turn(
        &mut self,
        rounds: &mut Rounds,
        id: TaskNumber,
        grant: Grant,
        vm: &mut Vm,
        host: &mut dyn Host,
    ) -> CycleFlow {
        let turn = vm.turn(id, grant, self.now, self.line_cost, host);
        self.now += Time::from(turn.lines) * self.line_cost;
        vm.set_left(id, turn.left);
        let suspension = turn.end.cycle_end();
        let is_suspended = suspension.is_some();
        rounds.suspended = is_suspended.then_some(id);
        self.next = if turn.left > 0 || is_suspended { id } else { TaskNumber(id.0 + 1) };
        // A task that ends directly after its wait executes no line, but its end is visible to other tasks.
        let has_run = turn.lines > 0 || !(is_suspended || matches!(turn.end, TurnEnd::Waiting(_)));
        rounds.round.has_run |= has_run;
        rounds.round.reads_clock |= turn.reads_clock;
        rounds.any |= has_run;
        if let Some(end) = suspension {
            return CycleFlow::Break(end);
        }
        if host.is_interrupted() {
            return CycleFlow::Break(CycleEnd::Suspended);
        }
        self.check_watch(id, &turn)
    }

    /// Begins another round. If all tasks wait, it begins at the next wake-up time.
    fn end_round(&mut self, rounds: &mut Rounds, end: Time, vm: &Vm) -> CycleFlow {
        self.next = TaskNumber(0);
        let round = std::mem::take(&mut rounds.round);
        if round.has_run {
            return CycleFlow::Continue(());
        }
        let wake = self.wake(vm);
        match wake.filter(|wake| *wake < end) {
            Some(wake) => self.now = self.now.max(wake),
            // No time may be skipped while a task polls the clock.
            None if rounds.any || round.reads_clock => return CycleFlow::Break(CycleEnd::Busy),
            None => return CycleFlow::Break(CycleEnd::Waiting(wake)),
        }
        CycleFlow::Continue(())
    }

    /// Returns the rest of a suspended turn; `None` if the task no longer exists.
    fn suspended_turn(&self, id: TaskNumber, vm: &Vm, end: Time) -> Option<(TaskNumber, Grant)> {
        let task = vm.tasks().iter().find(|task| task.id == id && task.can_run())?;
        let lines = self.lines(task)?;
        Some((id, self.grant(task, task.left, lines, vm, end)))
    }

    /// Returns the next asynchronous task that can run, with the lines for its turn.
    fn next_turn(&self, vm: &Vm, end: Time) -> Option<(TaskNumber, Grant)> {
        let tasks = vm.tasks();
        let from = vm.roster.first_from(self.next);
        let (task, lines) = tasks.iter().skip(from).find_map(|task| Some((task, self.lines(task)?)))?;
        let first = if task.left > 0 { task.left } else { lines };
        Some((task.id, self.grant(task, first, lines, vm, end)))
    }

    fn grant(&self, task: &Task, first: u32, lines: u32, vm: &Vm, end: Time) -> Grant {
        let limit = self.lines_until(end).min(self.lines_until_stop(task.id, vm));
        let per_turn = if self.is_alone(task, vm.tasks(), end) { lines } else { 0 };
        Grant { first, per_turn, limit }
    }

    /// Returns the lines per turn, if this is an asynchronous task that can run.
    fn lines(&self, task: &Task) -> Option<u32> {
        match task.rate {
            Rate::Priority(lines) if task.can_run() && !self.sleeps(task) => Some(lines),
            _ => None,
        }
    }

    /// Whether no other asynchronous task can run before `end` unless this task enables it, so that its turns follow
    /// one another.
    fn is_alone(&self, task: &Task, tasks: &[Box<Task>], end: Time) -> bool {
        let wakes = |other: &Task| other.thread.wait.and_then(|wait| wait.wake).is_some_and(|wake| wake < end);
        let mut others = tasks.iter().filter(|other| other.id != task.id && matches!(other.rate, Rate::Priority(_)));
        !others.any(|other| other.can_run() && (!self.sleeps(other) || wakes(other)))
    }

    fn sleeps(&self, task: &Task) -> bool {
        task.thread.wait.is_some_and(|wait| wait.sleeps && wait.wake.is_some_and(|wake| wake > self.now))
    }

    /// Returns the earliest future wake-up time of a waiting task or beginning of a period.
    fn wake(&self, vm: &Vm) -> Option<Time> {
        let running = vm.tasks().iter().filter(|task| task.can_run());
        let times = running.filter_map(|task| match task.rate {
            Rate::Period { next, .. } => Some(next),
            Rate::Priority(_) => task.thread.wait.and_then(|wait| wait.wake),
        });
        times.filter(|time| *time > self.now).min()
    }
}
