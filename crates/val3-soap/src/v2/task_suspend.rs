//! `taskSuspend`: suspends a task.

use crate::structure::{operation, structure};
use crate::value::Empty;

structure! {
    /// Request `taskSuspend`.
    TaskSuspend {
        /// Name of the task.
        task: Option<String> = "taskName",
        /// Project that has created the task, for example `Disk://name/name.pjx`.
        created_by: Option<String> = "createdBy",
    }
}

operation!(TaskSuspend: V2 "taskSuspend" => Empty, "taskSuspendResponse");
