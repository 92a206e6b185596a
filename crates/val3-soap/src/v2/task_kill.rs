//! `taskKill`: ends a task.

use crate::structure::{operation, structure};
use crate::value::Empty;

structure! {
    /// Request `taskKill`.
    TaskKill {
        /// Name of the task.
        task: Option<String> = "taskName",
        /// Project that has created the task, for example `Disk://name/name.pjx`.
        created_by: Option<String> = "createdBy",
    }
}

operation!(TaskKill: V2 "taskKill" => Empty, "taskKillResponse");
