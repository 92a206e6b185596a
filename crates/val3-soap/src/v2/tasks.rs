//! Tasks and lines of programs.

use crate::structure::{enumeration, structure};

structure! {
    /// Line of a program.
    ProgramLine {
        /// Project, for example `Disk://name/name.pjx`.
        project: Option<String> = "appName",
        /// Name of the program.
        program: Option<String> = "pgmName",
        /// Number of the line; the line with `begin` is 1 (inferred).
        number: i32 = "lineNumber",
        /// Code of the line.
        content: Option<String> = "lineContent",
    }
}

structure! {
    /// Task with its state.
    TaskStatus {
        /// Name.
        name: Option<String> = "name",
        /// State.
        state: TaskState = "state",
        /// Priority.
        priority: i32 = "priority",
        /// Project that has created the task.
        created_by: Option<String> = "createdBy",
        /// Number of the run-time error; 0 without.
        error: i32 = "runtimeError",
        /// Description of the run-time error.
        error_description: Option<String> = "runtimeErrorDescription",
        /// Line that the task executes.
        line: ProgramLine = "programLine",
    }
}

enumeration! {
    /// State of a task.
    TaskState {
        /// The task has not begun.
        Idle = "TASKSTATE-IDLE",
        /// The task changes its state.
        Transition = "TASKSTATE-TRANSITION",
        /// The task runs.
        Running = "TASKSTATE-RUNNING",
        /// The task executes a step.
        Stepping = "TASKSTATE-STEPPING",
        /// The task is suspended, or has a run-time error.
        Stopped = "TASKSTATE-STOPPED",
    }
}

enumeration! {
    /// Extent of a step.
    TaskStepKind {
        /// To the next line, also in a called program.
        Into = "TASKSTEP-INTO",
        /// To the next line of the program.
        Over = "TASKSTEP-OVER",
        /// To the end of the program.
        Out = "TASKSTEP-OUT",
    }
}
