//! Steps of one task.

use val3_lang::ports::TaskNumber;
use val3_vm::{Task, Vm};

/// How far a step goes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StepKind {
    /// To the next line, in a program that this one calls too.
    In,
    /// To the next line of this program, or of its caller.
    Over,
    /// To the rest of the caller.
    Out,
    /// To the beginning of the task that the next line creates.
    IntoTask,
}

/// A step that is under way.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Step {
    pub(crate) task: TaskNumber,
    pub(crate) kind: StepKind,
    /// The number of frames when it began.
    depth: usize,
}

impl Step {
    pub(crate) fn new(task: &Task, kind: StepKind) -> Self {
        Self { task: task.id, kind, depth: task.thread.frames.len() }
    }

    /// Whether the step ends where the task is now: between two lines of a program that the step may end in.
    pub(crate) fn is_done(&self, vm: &Vm) -> bool {
        let Some(task) = vm.tasks().iter().find(|task| task.id == self.task) else { return false };
        let depth = task.thread.frames.len();
        let is_deep_enough = match self.kind {
            StepKind::In | StepKind::IntoTask => true,
            StepKind::Over => depth <= self.depth,
            StepKind::Out => depth < self.depth,
        };
        is_deep_enough && task.thread.wait.is_none() && !vm.is_within_line(self.task)
    }
}
