//! `taskResume`: continues a suspended task.

use crate::structure::{operation, structure};
use crate::value::Empty;

structure! {
    /// Request `taskResume`.
    TaskResume {
        /// Name of the task.
        task: Option<String> = "taskName",
        /// Project that has created the task, for example `Disk://name/name.pjx`.
        created_by: Option<String> = "createdBy",
    }
}

operation!(TaskResume: V2 "taskResume" => Empty, "taskResumeResponse");
