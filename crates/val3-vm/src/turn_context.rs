//! State during one turn.

use val3_lang::fault::{Fault, Result};
use val3_lang::ports::{CodePlace, Origin, TaskNumber, Time};

use crate::roster::Roster;
use crate::{Frame, Grant, Host, Instance, InstanceId, Space};

/// Task, memory and budget of the interpreter during one turn.
pub(crate) struct TurnContext<'v> {
    pub(crate) space: &'v mut Space,
    pub(crate) roster: &'v mut Roster,
    pub(crate) ports: &'v mut dyn Host,
    /// Running task.
    pub(crate) task: TaskNumber,
    pub(crate) stack_size: u32,
    pub(crate) grant: Grant,
    /// Budget at the beginning of the turn, in lines.
    pub(crate) granted: u32,
    /// Number of lines that may still be executed.
    pub(crate) budget: u32,
    /// Time at which the budget is used up. The current time is computed from it.
    pub(crate) end: Time,
    pub(crate) line_cost: Time,
    /// Whether the task has read the clock.
    pub(crate) reads_clock: bool,
}

impl TurnContext<'_> {
    pub(crate) fn instance(&self, id: InstanceId) -> Result<&Instance> {
        self.space.instance(id).ok_or(Fault::INTERPRETER)
    }

    pub(crate) fn now(&self) -> Time {
        self.end - Time::from(self.budget) * self.line_cost
    }

    /// Grants more lines to a turn whose lines are used up.
    pub(crate) fn extend(&mut self, lines: u32) {
        self.grant = Grant::once(lines);
        self.end += Time::from(lines) * self.line_cost;
        (self.granted, self.budget) = (lines, self.budget + lines);
    }

    /// Ends the grant with the current turn, because another task may be able to run afterwards.
    pub(crate) fn end_with_turn(&mut self) {
        let left = self.budget.min(self.grant.left(self.granted - self.budget));
        let cut = self.budget - left;
        self.budget = left;
        self.granted -= cut;
        self.end -= Time::from(cut) * self.line_cost;
    }

    /// Returns the origin of events: the line of a frame that begins with operation `line`.
    pub(crate) fn origin(&self, time: Time, frame: &Frame, line: u32) -> Origin {
        let at = CodePlace { instance: frame.instance.0, program: frame.program, line };
        Origin { time, task: self.task, at }
    }
}
