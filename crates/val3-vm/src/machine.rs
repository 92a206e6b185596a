//! What the interpreter works on during one turn.

use val3_lang::fault::{Fault, Result};
use val3_lang::ports::{CodePlace, Origin, TaskNumber, Time};

use crate::arguments::Scope;
use crate::roster::Roster;
use crate::{Frame, Grant, Host, Instance, InstanceId, Space};

/// What the interpreter works on during one turn.
pub(crate) struct Machine<'v> {
    pub(crate) space: &'v mut Space,
    pub(crate) roster: &'v mut Roster,
    pub(crate) ports: &'v mut dyn Host,
    /// The task that runs.
    pub(crate) task: TaskNumber,
    pub(crate) stack_size: u32,
    /// What it may execute.
    pub(crate) grant: Grant,
    /// How many lines that is.
    pub(crate) granted: u32,
    /// Lines that may still be executed.
    pub(crate) budget: u32,
    /// The time at which the budget is used up, and what a line takes: the time now follows from both.
    pub(crate) end: Time,
    pub(crate) line_cost: Time,
    /// Something asked for the time.
    pub(crate) reads_clock: bool,
}

impl Machine<'_> {
    pub(crate) fn instance(&self, id: InstanceId) -> Result<&Instance> {
        self.space.instance(id).ok_or(Fault::INTERPRETER)
    }

    pub(crate) fn now(&self) -> Time {
        self.end - Time::from(self.budget) * self.line_cost
    }

    /// The line of a frame that begins with this step, as events name it.
    pub(crate) fn origin(&self, time: Time, frame: &Frame, line: u32) -> Origin {
        let at = CodePlace { instance: frame.instance.0, program: frame.program, line };
        Origin { time, task: self.task, at }
    }

    pub(crate) fn scope(&self, frame: &Frame) -> Result<Scope<'_>> {
        Ok(Scope { memory: &self.space.memory, instance: self.instance(frame.instance)?, base: frame.base })
    }
}
