//! Which task runs when (5.4 to 5.7).
//!
//! Time is virtual: every line takes the same time, waiting takes none, and what nobody waits for is jumped over by
//! the caller. A cycle is 4 ms: synchronous tasks whose time has come, then asynchronous ones in rounds until the cycle
//! is over or all of them wait.

use val3_lang::ports::{TaskNumber, Time};

use crate::{Grant, Host, Rate, Stop, Task, Vm};

/// The length of a cycle in nanoseconds, and the unit of periods: [`PERIOD_STEP`](val3_lang::tasks::PERIOD_STEP).
pub const CYCLE: Time = 4_000_000;

/// Lines that a synchronous task executes at most in a cycle (5.5).
const SYNCHRONOUS_LINES: u32 = 3000;

/// The clock and the round of the scheduler.
#[derive(Debug, Clone)]
pub struct Schedule {
    /// The controller's clock, in nanoseconds.
    pub now: Time,
    /// What a line takes, in nanoseconds; at least 1.
    pub line_cost: Time,
    /// The asynchronous task whose turn is next: this one or the next behind it.
    next: TaskNumber,
}

/// What a cycle came to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Cycle {
    /// Tasks have run.
    Busy,
    /// All tasks wait: for this time, or for what others do. With `watches_clock`, for what they compute of the time,
    /// so that no time may be left out.
    Idle {
        /// The earliest time that a task waits for.
        wake: Option<Time>,
        /// Some task looks at the clock while it waits.
        watches_clock: bool,
    },
}

impl Schedule {
    /// A clock at 0.
    #[must_use]
    pub fn new(line_cost: Time) -> Self {
        Self { now: 0, line_cost: line_cost.max(1), next: TaskNumber(0) }
    }

    /// Runs tasks until the end of the cycle, which is returned with its outcome. The last turn may overrun that end by
    /// part of a line. A cycle that the host interrupts resumes when this is called again.
    pub fn cycle(&mut self, vm: &mut Vm, host: &mut dyn Host) -> (Cycle, Time) {
        let end = (self.now / CYCLE + 1) * CYCLE;
        let synchronous = self.synchronous(vm, host);
        let asynchronous = self.asynchronous(vm, end, host);
        if host.is_interrupted() {
            return (Cycle::Busy, self.now);
        }
        self.now = self.now.max(end);
        (if synchronous { Cycle::Busy } else { asynchronous }, end)
    }

    /// Gives each synchronous task whose time has come its turn: short periods first, then in the order of creation.
    fn synchronous(&mut self, vm: &mut Vm, host: &mut dyn Host) -> bool {
        let mut due: Vec<(Time, TaskNumber)> = vm.tasks().iter().filter_map(|task| self.due(task)).collect();
        due.sort_unstable();
        for (period, id) in &due {
            // One before it may have halted or killed it.
            if !vm.tasks().iter().any(|task| task.id == *id && task.is_running()) {
                continue;
            }
            self.begin_period(vm, *id);
            let start = self.now;
            self.synchronous_turn(vm, *id, host);
            if self.now - start > *period {
                self.leave_out_period(vm, *id);
            }
        }
        self.pass_periods(vm);
        !due.is_empty()
    }

    /// Gives a synchronous task its lines. What takes time outside the program delays all that follows in the cycle.
    fn synchronous_turn(&mut self, vm: &mut Vm, id: TaskNumber, host: &mut dyn Host) {
        let mut lines = SYNCHRONOUS_LINES;
        loop {
            let turn = vm.turn(id, Grant::once(lines), (self.now, self.line_cost), host);
            self.now += Time::from(turn.lines) * self.line_cost;
            lines = lines.saturating_sub(turn.lines);
            match turn.stop {
                Stop::Pauses(wake) if !host.is_interrupted() => self.now = self.now.max(wake),
                _ => return,
            }
        }
    }

    /// The periods of tasks that do not run pass, so that one that is resumed goes on at the beginning of one.
    fn pass_periods(&self, vm: &mut Vm) {
        let halted = vm.tasks().iter().filter(|task| !task.is_running());
        let is_passed = |task: &Task| matches!(task.rate, Rate::Period { next, .. } if next <= self.now);
        let passed: Vec<TaskNumber> = halted.filter(|task| is_passed(task)).map(|task| task.id).collect();
        for id in passed {
            if let Some(Rate::Period { period, next, .. }) = vm.rate_mut(id) {
                *next = (self.now / *period + 1) * *period;
            }
        }
    }

    fn due(&self, task: &Task) -> Option<(Time, TaskNumber)> {
        match task.rate {
            Rate::Period { period, next, .. } if next <= self.now && task.is_running() => Some((period, task.id)),
            _ => None,
        }
    }

    /// Tells the task whether its last period was too short (5.6), and when the next one begins.
    fn begin_period(&self, vm: &mut Vm, id: TaskNumber) {
        let Some(Rate::Period { period, next, overrun, late }) = vm.rate_mut(id) else { return };
        let (overrun, was_late) = (*overrun, std::mem::take(late));
        *next = (self.now / *period + 1) * *period;
        // A variable of a library that has left memory can no longer be told anything.
        let _ = vm.space.memory.set_num(overrun, 0, f64::from(u8::from(was_late)));
    }

    /// The next period is left out (5.6).
    fn leave_out_period(&self, vm: &mut Vm, id: TaskNumber) {
        if let Some(Rate::Period { period, next, late, .. }) = vm.rate_mut(id) {
            *late = true;
            *next = (self.now / *period + 1) * *period;
        }
    }

    fn asynchronous(&mut self, vm: &mut Vm, end: Time, host: &mut dyn Host) -> Cycle {
        let mut any = false;
        // A round that the last cycle has interrupted does not show that all tasks wait.
        let mut round = Round { has_run: self.next != TaskNumber(0), reads_clock: false };
        while self.now < end {
            let Some((id, grant)) = self.next_turn(vm, end) else {
                // The round is over.
                self.next = TaskNumber(0);
                if round.has_run {
                    round = Round::default();
                    continue;
                }
                let wake = self.wake(vm);
                match wake.filter(|wake| *wake < end) {
                    Some(wake) => self.now = self.now.max(wake),
                    None if any => return Cycle::Busy,
                    None => return Cycle::Idle { wake, watches_clock: round.reads_clock },
                }
                round = Round::default();
                continue;
            };
            let turn = vm.turn(id, grant, (self.now, self.line_cost), host);
            self.now += Time::from(turn.lines) * self.line_cost;
            vm.set_left(id, turn.left);
            self.next = if turn.left > 0 { id } else { TaskNumber(id.0 + 1) };
            // One that ends behind what it waited for executes no line, but others see that it is over.
            let has_run = turn.lines > 0 || turn.stop != Stop::Waits;
            round.has_run |= has_run;
            round.reads_clock |= turn.reads_clock;
            any |= has_run;
            if host.is_interrupted() {
                return Cycle::Busy;
            }
        }
        Cycle::Busy
    }

    /// The next asynchronous task that can run, with the lines of its turn.
    fn next_turn(&self, vm: &Vm, end: Time) -> Option<(TaskNumber, Grant)> {
        let tasks = vm.tasks();
        let from = vm.roster.first_from(self.next);
        let (task, lines) = tasks.iter().skip(from).find_map(|task| Some((task, self.lines(task)?)))?;
        let first = if task.left > 0 { task.left } else { lines };
        let most = u32::try_from((end - self.now).div_ceil(self.line_cost)).unwrap_or(u32::MAX);
        let each = if self.is_alone(task, tasks, end) { lines } else { 0 };
        Some((task.id, Grant { first, each, most }))
    }

    /// The lines of a turn of an asynchronous task that can run.
    fn lines(&self, task: &Task) -> Option<u32> {
        match task.rate {
            Rate::Priority(lines) if task.is_running() && !self.sleeps(task) => Some(lines),
            _ => None,
        }
    }

    /// No other asynchronous task can run before `end`, unless this one lets it: its turns follow one another.
    fn is_alone(&self, task: &Task, tasks: &[Box<Task>], end: Time) -> bool {
        let wakes = |other: &Task| other.thread.wait.and_then(|wait| wait.wake).is_some_and(|wake| wake < end);
        let is_other = |other: &Task| other.id != task.id && matches!(other.rate, Rate::Priority(_));
        !tasks.iter().any(|other| is_other(other) && other.is_running() && (!self.sleeps(other) || wakes(other)))
    }

    fn sleeps(&self, task: &Task) -> bool {
        task.thread.wait.is_some_and(|wait| wait.sleeps && wait.wake.is_some_and(|wake| wake > self.now))
    }

    /// The earliest time behind now that a task waits for, or at which a period begins.
    fn wake(&self, vm: &Vm) -> Option<Time> {
        let running = vm.tasks().iter().filter(|task| task.is_running());
        let times = running.filter_map(|task| match task.rate {
            Rate::Period { next, .. } => Some(next),
            Rate::Priority(_) => task.thread.wait.and_then(|wait| wait.wake),
        });
        times.filter(|time| *time > self.now).min()
    }
}

/// What the tasks have done since each had its last turn.
#[derive(Default)]
struct Round {
    has_run: bool,
    reads_clock: bool,
}
