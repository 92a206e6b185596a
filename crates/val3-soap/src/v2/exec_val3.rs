//! `execVal3`: executes code in a stack frame.

use super::ExecutionResult;
use crate::structure::{operation, structure};

structure! {
    /// Request `execVal3`.
    ExecVal3 {
        /// Project of the code.
        project: Option<String> = "prjName",
        /// Name of the task.
        task: Option<String> = "taskName",
        /// Project that has created the task, for example `Disk://name/name.pjx`.
        created_by: Option<String> = "createdBy",
        /// Index of the stack frame; 0 is the innermost.
        frame: i32 = "stackFrameIndex",
        /// Code.
        command: Option<String> = "cmd",
    }
}

structure! {
    /// Answer of `execVal3`.
    ExecVal3Answer {
        /// Result.
        code: ExecutionResult = "retCode",
        /// Value, or description of the error.
        output: Option<String> = "strOut",
    }
}

operation!(ExecVal3: V2 "execVal3" => ExecVal3Answer, "execVal3Response");
