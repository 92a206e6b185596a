//! State during one turn.

use std::sync::Arc;

use val3_bytecode::LineMark;
use val3_lang::fault::{Fault, Result};
use val3_lang::ports::{CodePlace, Origin, TaskNumber, Time};

use crate::data_watch::{BegunLine, DataWatch};
use crate::roster::Roster;
use crate::task::Thread;
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
    /// Values whose change ends the turn.
    pub(crate) watch: Option<Arc<DataWatch>>,
    /// Whether the turn has executed a part of a line, so that a change is the turn's own.
    pub(crate) has_executed: bool,
    /// Line that the turn has begun last, while values are watched; at the beginning of the turn the next operation.
    pub(crate) begun: Option<BegunLine>,
    /// Task whose name guards of stop marks compare: the running task, or the task of a fragment.
    pub(crate) stops_as: TaskNumber,
}

impl TurnContext<'_> {
    pub(crate) fn instance(&self, id: InstanceId) -> Result<&Instance> {
        self.space.instance(id).ok_or(Fault::INTERPRETER)
    }

    pub(crate) fn now(&self) -> Time {
        self.end - Time::from(self.budget) * self.line_cost
    }

    /// Whether a watched value has changed.
    pub(crate) fn has_changed_data(&self, thread: &Thread) -> bool {
        let watch = self.watch.as_ref();
        watch.is_some_and(|watch| watch.has_changed(&self.space.memory, self.task, &thread.frames))
    }

    /// Whether the task stops before it executes the return of a program with watched variables. A `return` that
    /// begins a line is compared before the line.
    #[cold]
    pub(crate) fn stops_before_return(&self, thread: &mut Thread, mark: LineMark) -> bool {
        let watch = self.watch.as_ref().filter(|_| !mark.begins_line());
        if watch.is_some_and(|watch| watch.stops_before_return(self.task, &thread.frames)) {
            return thread.meets_return(mark.is_stop());
        }
        thread.is_at_return = false;
        false
    }

    /// Begins a line while values are watched. Returns `false` instead if the turn has changed one before.
    #[cold]
    pub(crate) fn begins_watched_line(&mut self, thread: &Thread, frame: Frame, op: usize) -> bool {
        if self.has_executed && self.has_changed_data(thread) {
            return false;
        }
        self.has_executed = true;
        self.begun = Some(BegunLine { frame, op: u32::try_from(op).unwrap_or(u32::MAX) });
        true
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
