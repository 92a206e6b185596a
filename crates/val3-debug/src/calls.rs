//! Statements that the debugger executes in a stack frame of a stopped task, and that stop at a breakpoint in a called
//! program.
//!
//! Statements without a stop are executed while tasks, clock and arm do not advance. At a stop, they and the programs
//! that they have called are on the stack of the task. From then on, the task executes them in its turns, like its own
//! programs. After the last statement, or an error, the task is again where it was before.

use val3_bytecode::Fragment;
use val3_lang::fault::Fault;
use val3_lang::ports::TaskNumber;
use val3_machine::event::Event;
use val3_vm::{FragmentEnd, TaskState};

use crate::debugger::{Debugger, Stop};
use crate::frames::{TaskFrame, frames};
use crate::history::Moment;

/// Lines that statements may execute, and the requests that end them early.
pub struct ExecutionLimits<'a> {
    /// Numbers of lines. The next number is requested after the lines of the previous one.
    pub grants: &'a mut dyn Iterator<Item = u32>,
    /// Whether the statements stop where they are if no number is left, instead of their end.
    pub stops_at_limit: &'a dyn Fn() -> bool,
}

/// Result of [`Debugger::execute`].
#[derive(Debug, Clone)]
pub struct Execution {
    /// The statements have ended, or were ended.
    pub end: ExecutionEnd,
    /// Events of the statements.
    pub events: Vec<Event>,
}

/// End of the execution of statements.
#[derive(Debug, Clone)]
pub enum ExecutionEnd {
    /// The statements have ended, or were ended: in this line of a called program.
    Over(FragmentEnd<()>, Option<TaskFrame>),
    /// The task has stopped in a called program.
    Stopped(Stop),
}

impl Debugger {
    /// Executes statements in a stack frame of a stopped task, up to a breakpoint in a called program. `depth` 0 is the
    /// innermost frame. The caller calls [`begin_new_future`](Self::begin_new_future) afterwards.
    pub fn execute(
        &mut self,
        statements: &Fragment,
        task: TaskNumber,
        depth: usize,
        limits: ExecutionLimits<'_>,
    ) -> Execution {
        let ExecutionLimits { grants, stops_at_limit } = limits;
        let fragments = self.controller.vm.fragments_below(task, usize::MAX);
        let (mut end, mut events) = self.controller.execute_fragment(statements, task, depth, grants);
        loop {
            let stop = match end {
                FragmentEnd::AtStop => self.hit(task),
                FragmentEnd::Limit if stops_at_limit() => Some(Stop::Pause { task: Some(task) }),
                _ => {
                    let line = self.ended_line(task, fragments);
                    return Execution { end: ExecutionEnd::Over(end, line), events };
                }
            };
            if let Some(stop) = stop {
                self.last = Some(task);
                self.abandon_step_of(task);
                return Execution { end: ExecutionEnd::Stopped(stop), events };
            }
            let (next, more) = self.controller.resume_fragment(task, grants);
            end = next;
            events.extend(more);
        }
    }

    /// Whether the debugger has executed statements that have not ended on the stack of a task.
    #[must_use]
    pub fn is_in_call(&self, task: TaskNumber) -> bool {
        self.controller.vm.has_fragment(task)
    }

    /// Ends the innermost statements on the stack of a task without executing the rest. The task is where it was before.
    /// Returns `None` if there are no statements.
    pub fn end_call(&mut self, task: TaskNumber) -> Option<Stop> {
        self.is_in_call(task).then(|| self.leave_call(task, None))
    }

    /// Removes the ended statements from the stack of a task, and returns the stop.
    pub(crate) fn leave_call(&mut self, task: TaskNumber, fault: Option<Fault>) -> Stop {
        let line = fault.and_then(|_| frames(&self.controller.vm, task).into_iter().next());
        self.controller.vm.end_fragment(task);
        self.last = Some(task);
        let is_recorded = self.is_in_past()
            && self.history.as_ref().is_some_and(|history| history.has_change_at(Moment::of(&self.controller)));
        if !is_recorded {
            self.begin_new_future();
        }
        Stop::CallEnded { task, fault, line: line.map(Box::new) }
    }

    /// Leaves the statements of a task that an error has stopped, because the run continues after the stop at the error.
    pub(crate) fn leave_failed_call(&mut self) -> Option<Stop> {
        let mut tasks = self.controller.vm.tasks().iter().filter(|task| !task.is_held);
        let (task, fault) = tasks.find_map(|task| match task.state {
            TaskState::Failed(fault) if self.is_in_call(task.id) => Some((task.id, fault)),
            _ => None,
        })?;
        Some(self.leave_call(task, Some(fault)))
    }

    /// Removes all statements from the stacks of tasks.
    pub(crate) fn leave_calls(&mut self) {
        let tasks: Vec<TaskNumber> = self.controller.vm.tasks().iter().map(|task| task.id).collect();
        for task in tasks {
            while self.controller.vm.end_fragment(task) {}
        }
    }

    /// Whether a task executes statements of the debugger. Their errors end them, also if no error stops the run.
    pub(crate) fn has_calls(&self) -> bool {
        self.controller.vm.tasks().iter().any(|task| self.is_in_call(task.id))
    }

    /// Removes statements that have ended early, above the first `fragments` ones, and returns the line of the called
    /// program.
    fn ended_line(&mut self, task: TaskNumber, fragments: usize) -> Option<TaskFrame> {
        if self.controller.vm.fragments_below(task, usize::MAX) <= fragments {
            return None;
        }
        let line = frames(&self.controller.vm, task).into_iter().next().filter(|frame| !frame.is_console);
        self.controller.vm.end_fragment(task);
        line
    }

    fn abandon_step_of(&mut self, task: TaskNumber) {
        self.step = self.step.filter(|step| step.task != task);
    }
}
