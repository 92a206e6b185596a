//! Machine code beside the interpreter.

use std::fmt::Debug;

use val3_lang::fault::Result;
use val3_lang::ports::Time;

use crate::machine::Machine;
use crate::schedule::end_of_cycle;
use crate::{Space, Stop, Thread};

/// Lines below which a turn is left to the interpreter: to change over takes longer.
const LEAST: u32 = 500;

/// Lines that the interpreter executes in a turn, one by one, until machine code can go on.
const STEPS: u32 = 100;

/// What can execute steps as the interpreter does, and faster.
pub trait Native: Debug {
    /// Executes steps of the task that runs as the interpreter would, as far as it can: it stops before an operation
    /// that it does not know or that would be an error, and before a line that must not begin any more.
    fn run(&mut self, work: &mut Stretch<'_>) -> Prospect;
}

/// What can be expected of machine code in the rest of a turn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Prospect {
    /// It can go on from a step that may come soon.
    Near,
    /// The interpreter does not take longer.
    None,
}

/// The task that runs, and what it may do.
#[derive(Debug)]
pub struct Stretch<'m> {
    /// What is in memory; the memory has the stack of the task.
    pub space: &'m mut Space,
    /// Where the task is.
    pub thread: &'m mut Thread,
    /// Bytes of stack that it may use.
    pub stack_size: u32,
    /// Lines that it may still begin.
    pub budget: u32,
}

impl Machine<'_> {
    /// Executes lines until the turn ends: in machine code where that can go on, else in the interpreter.
    pub(crate) fn run(&mut self, thread: &mut Thread) -> Result<Stop> {
        let mut steps = if self.budget < LEAST { 0 } else { STEPS };
        while steps > 0 && self.run_native(thread) == Prospect::Near {
            steps -= 1;
            self.reserve = self.budget.saturating_sub(1);
            self.budget -= self.reserve;
            let stop = self.interpret(thread);
            self.budget += std::mem::take(&mut self.reserve);
            match stop {
                Ok(Stop::Budget) if self.budget > 0 => {}
                stop => return stop,
            }
        }
        self.interpret(thread)
    }

    /// Executes what machine code can. It may go on beyond the end of the cycle if no instruction was executed in it:
    /// nothing happens there but the lines. The interpreter is then given the rest of the cycle it has come to.
    fn run_native(&mut self, thread: &mut Thread) -> Prospect {
        let (start, lines) = (self.now(), self.granted - self.budget);
        let far = if self.is_touched { 0 } else { self.grant.far.saturating_sub(lines) }.max(self.budget);
        let Some(native) = self.ports.native() else { return Prospect::None };
        let mut work = Stretch { space: self.space, thread, stack_size: self.stack_size, budget: far };
        let prospect = native.run(&mut work);
        let (left, done) = (work.budget, far - work.budget);
        match self.budget.checked_sub(done) {
            Some(left) => self.budget = left,
            None => self.begin_later_cycle(start, (lines + done, done), left),
        }
        prospect
    }

    /// Lines were executed beyond the end of the cycle, `lines` in the whole turn, and so many are left until the last
    /// that may be.
    fn begin_later_cycle(&mut self, start: Time, (lines, done): (u32, u32), left: u32) {
        let now = start + Time::from(done) * self.line_cost;
        let end = if left == 0 { now } else { end_of_cycle(now) };
        self.budget = u32::try_from((end - now).div_ceil(self.line_cost)).unwrap_or(u32::MAX);
        self.granted = lines + self.budget;
        self.end = now + Time::from(self.budget) * self.line_cost;
        self.cycle = Some(end);
    }
}
