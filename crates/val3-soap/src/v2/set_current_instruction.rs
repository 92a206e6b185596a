//! `setCurrentInstruction`: sets the next line of a task.

use super::ProgramLine;
use crate::structure::{operation, structure};
use crate::value::Empty;

structure! {
    /// Request `setCurrentInstruction`.
    SetCurrentInstruction {
        /// Name of the task.
        task: Option<String> = "taskName",
        /// Project that has created the task, for example `Disk://name/name.pjx`.
        created_by: Option<String> = "createdBy",
        /// Whether pending moves are removed.
        reset_motion: bool = "resetMotion",
        /// Next line.
        line: ProgramLine = "line",
    }
}

operation!(SetCurrentInstruction: V2 "setCurrentInstruction" => Empty, "setCurrentInstructionResponse");
