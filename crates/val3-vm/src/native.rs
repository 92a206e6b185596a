//! Machine code beside the interpreter.

use std::fmt::Debug;

use val3_lang::fault::Result;
use val3_lang::ports::Time;

use crate::machine::Machine;
use crate::schedule::end_of_cycle;
use crate::{Space, Thread};

/// Lines below which a turn is left to the interpreter: to change over takes longer.
const LEAST: u32 = 500;

/// What can execute steps as the interpreter does, and faster.
pub trait Native: Debug {
    /// Executes steps of the task that runs as the interpreter would, as far as it can: it stops before an operation
    /// that it does not know or that would be an error, and before a line that must not begin any more.
    fn run(&mut self, work: &mut Stretch<'_>);
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
    /// Executes what machine code can, where the turn is long enough. It may go on beyond the end of the cycle: nothing
    /// happens there but the lines it executes. The interpreter is then given the rest of the cycle it has come to.
    pub(crate) fn run_native(&mut self, thread: &mut Thread) -> Result<()> {
        if self.budget < LEAST {
            return Ok(());
        }
        let (start, far) = (self.now(), self.grant.far.max(self.budget));
        let Some(native) = self.ports.native() else { return Ok(()) };
        let mut work = Stretch { space: self.space, thread, stack_size: self.stack_size, budget: far };
        native.run(&mut work);
        let (left, done) = (work.budget, far - work.budget);
        match self.budget.checked_sub(done) {
            Some(left) => self.budget = left,
            None => self.begin_later_cycle(start, done, left),
        }
        Ok(())
    }

    /// Lines were executed beyond the end of the cycle, and so many are left until the last that may be.
    fn begin_later_cycle(&mut self, start: Time, done: u32, left: u32) {
        let now = start + Time::from(done) * self.line_cost;
        let end = if left == 0 { now } else { end_of_cycle(now) };
        self.budget = u32::try_from((end - now).div_ceil(self.line_cost)).unwrap_or(u32::MAX);
        self.granted = done + self.budget;
        self.end = now + Time::from(self.budget) * self.line_cost;
        self.cycle = Some(end);
    }
}
