//! The reasons why execution has stopped.

use val3_lang::fault::Fault;
use val3_lang::ports::{TaskNumber, Time};

/// The reason why a turn of a task, a cycle or a whole run has stopped.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Outcome {
    /// The lines of the turn are used up, or the cycle is over and tasks can continue in the next one.
    Busy,
    /// The task waits, or all tasks wait: until this time, or for something else to happen.
    Waiting(Option<Time>),
    /// The task pauses until this time after an instruction, which takes its time outside the program.
    Pausing(Time),
    /// The host has interrupted the turn or the cycle, which resumes with the next call.
    Suspended,
    /// A task has reached a line with a stop mark. The cycle resumes with the next call, and the task begins the line.
    AtStop(TaskNumber),
    /// A task has executed a line or failed, which the caller [watches](crate::Watch). The cycle resumes with the next
    /// call.
    Seen(TaskNumber),
    /// The clock has reached the limit of the run. With a later limit, the cycle resumes with the next call.
    Limit,
    /// The program of the task, or the application, has ended.
    Finished,
    /// The task has halted or killed itself.
    Halted,
    /// A run-time error has stopped the task.
    Failed(Fault),
    /// No task can continue: each is halted or in error.
    Stuck,
    /// A task is at an instruction that this controller lacks. Its effects are unknown, so the run cannot continue.
    Lacking,
    /// The application or the run was stopped from outside.
    Stopped,
    /// The application was not started because of its faults.
    Refused,
}

impl Outcome {
    /// Whether a cycle that has stopped for this is not over, and resumes with the next call.
    #[must_use]
    pub fn is_within_cycle(self) -> bool {
        matches!(self, Self::Suspended | Self::AtStop(_) | Self::Seen(_) | Self::Limit)
    }

    /// Whether nothing can happen any more, unless something outside changes.
    #[must_use]
    pub fn is_final(self) -> bool {
        match self {
            Self::Finished | Self::Stopped | Self::Refused | Self::Failed(_) | Self::Stuck | Self::Lacking => true,
            Self::Busy
            | Self::Waiting(_)
            | Self::Pausing(_)
            | Self::Suspended
            | Self::AtStop(_)
            | Self::Seen(_)
            | Self::Limit
            | Self::Halted => false,
        }
    }
}
