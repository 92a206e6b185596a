//! `getStackFrame`: the variables of a stack frame.

use super::MimeData;
use crate::structure::{operation, structure};

structure! {
    /// Request `getStackFrame`.
    GetStackFrame {
        /// Name of the task.
        task: Option<String> = "taskName",
        /// Project that has created the task, for example `Disk://name/name.pjx`.
        created_by: Option<String> = "createdBy",
        /// Index of the stack frame; 0 is the innermost.
        frame: i32 = "stackFrameIndex",
    }
}

structure! {
    /// Answer of `getStackFrame`.
    GetStackFrameAnswer {
        /// Variables.
        data: MimeData = "data",
    }
}

operation!(GetStackFrame: V2 "getStackFrame" => GetStackFrameAnswer, "getStackFrameResponse");
