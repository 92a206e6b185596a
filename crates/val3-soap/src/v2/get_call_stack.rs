//! `getCallStack`: the stack of a task.

use super::StackFrameSummary;
use crate::structure::{operation, structure};

structure! {
    /// Request `getCallStack`.
    GetCallStack {
        /// Name of the task.
        task: Option<String> = "taskName",
        /// Project that has created the task, for example `Disk://name/name.pjx`.
        created_by: Option<String> = "createdBy",
    }
}

structure! {
    /// Answer of `getCallStack`.
    GetCallStackAnswer {
        /// Stack frames, from the innermost.
        frames: Vec<StackFrameSummary> = "callStack" of "SfAbstract",
    }
}

operation!(GetCallStack: V2 "getCallStack" => GetCallStackAnswer, "getCallStackResponse");
