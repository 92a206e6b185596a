//! `taskStep`: executes a line of a suspended task. The answer does not wait for the line.

use super::TaskStepKind;
use crate::structure::{operation, structure};
use crate::value::Empty;

structure! {
    /// Request `taskStep`.
    TaskStep {
        /// Name of the task.
        task: Option<String> = "taskName",
        /// Project that has created the task, for example `Disk://name/name.pjx`.
        created_by: Option<String> = "createdBy",
        /// Extent of the step.
        step: TaskStepKind = "stepType",
    }
}

operation!(TaskStep: V2 "taskStep" => Empty, "taskStepResponse");
