//! Structures of debugging.

use super::ProgramLine;
use crate::fault::ExceptionCode;
use crate::structure::{enumeration, structure};

structure! {
    /// Line at which a breakpoint is, or a stack frame.
    LineReference {
        /// Line.
        line: ProgramLine = "programLine",
    }
}

structure! {
    /// Result of setting or removing a breakpoint.
    BreakpointResponse {
        /// Index of the breakpoint in the request.
        index: i32 = "breakpointIndex",
        /// Reason of a failure. The enumeration has no value for a success: `UNKNOWN-CODE` (inferred).
        code: ExceptionCode = "errorCode",
    }
}

structure! {
    /// Stack frame.
    StackFrameSummary {
        /// Line that the stack frame executes.
        current: LineReference = "currentInstruction",
    }
}

structure! {
    /// Data whose value is requested.
    WatchedData {
        /// Project of the data.
        project: Option<String> = "appName",
        /// Name of the data.
        name: Option<String> = "dataName",
        /// Index, as text.
        index: Option<String> = "dataIndex",
    }
}

enumeration! {
    /// Result of executed code.
    ExecutionResult {
        /// The code was executed.
        NoError = "EXV-NO-ERROR",
        /// The code cannot be compiled.
        CompilationError = "EXV-COMPILATION-ERROR",
        /// The code has caused a run-time error.
        RuntimeError = "EXV-RUNTIME-ERROR",
    }
}

enumeration! {
    /// Result of a replaced line.
    ReplacementResult {
        /// The line was replaced.
        NoError = "RLI-NO-ERROR",
        /// Another editor changes the program.
        ProgramInEdition = "RLI-PROGRAM-IN-EDITION",
        /// The line cannot be compiled.
        CompilationError = "RLI-COMPILATION-ERROR",
        /// A task executes the line.
        InstructionBusy = "RLI-INSTRUCTION-BUSY",
        /// The line is part of a control structure.
        InstructionControl = "RLI-INSTRUCTION-CONTROL",
        /// Any other reason. The spelling is the vendor's.
        Unknown = "RLI-UNKNOW-RET-CODE",
    }
}
