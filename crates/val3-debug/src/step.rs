//! Steps of a task, and the conditions under which they end.

use val3_lang::ports::TaskNumber;
use val3_vm::{Task, Vm};

use crate::skipped_code::SkipPattern;

/// Extent of a step.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StepKind {
    /// To the next line, also in a called program.
    In,
    /// To the next line of this program or the caller.
    Over,
    /// To the next line of the caller.
    Out,
    /// To the beginning of the task that the next line creates.
    IntoTask,
}

/// A step in progress.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Step {
    pub(crate) task: TaskNumber,
    pub(crate) kind: StepKind,
    /// Number of stack frames at the start of the step.
    depth: usize,
    /// Whether the step may end in skipped code, because the user has chosen the program into which it leads.
    enters_skipped: bool,
}

impl Step {
    pub(crate) fn new(task: &Task, kind: StepKind) -> Self {
        Self { task: task.id, kind, depth: task.thread.frames.len(), enters_skipped: false }
    }

    /// Returns the step to a target that the user has chosen.
    pub(crate) fn into_target(self) -> Self {
        Self { enters_skipped: true, ..self }
    }

    /// Whether the step ends at the task's present location: between two lines, at a stack depth that suits the kind of
    /// step, and not in skipped code that the step has entered.
    pub(crate) fn is_done(&self, vm: &Vm, skipped: &[SkipPattern]) -> bool {
        let Some(task) = vm.tasks().iter().find(|task| task.id == self.task) else { return false };
        let depth = task.thread.frames.len();
        // A step that begins in skipped code may end there.
        let is_skipped = depth > self.depth
            && !self.enters_skipped
            && task
                .thread
                .frames
                .last()
                .is_some_and(|frame| skipped.iter().any(|code| code.contains(&vm.space, frame)));
        let is_deep_enough = match self.kind {
            StepKind::In => !is_skipped,
            StepKind::IntoTask => true,
            StepKind::Over => depth <= self.depth,
            StepKind::Out => depth < self.depth,
        };
        is_deep_enough && task.thread.wait.is_none() && !vm.is_within_line(self.task)
    }
}
