//! Reasons why execution stops.

use val3_lang::fault::Fault;
use val3_lang::ports::{TaskNumber, Time};

/// Reason why a turn of a task, a cycle or an entire run has stopped.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Outcome {
    /// The lines of the turn are used up, or the cycle has ended and tasks can continue in the next one.
    Busy,
    /// The task waits, or all tasks wait: until this time, or for another event.
    Waiting(Option<Time>),
    /// The task pauses until this time after an instruction that used time outside the program.
    Pausing(Time),
    /// The host has interrupted the turn or the cycle. The next call resumes it.
    Suspended,
    /// A task has reached a line with a stop mark. The next call resumes the cycle, and the task begins the line.
    AtStop(TaskNumber),
    /// A task that the caller [watches](crate::Watch) has executed a line or failed. The next call resumes the cycle.
    Seen(TaskNumber),
    /// The clock has reached the limit of the run. With a later limit, the next call resumes the cycle.
    Limit,
    /// The program of the task, or the application, has ended.
    Finished,
    /// The task has halted or killed itself.
    Halted,
    /// A run-time error has stopped the task.
    Failed(Fault),
    /// No task can continue: all are halted or in error.
    Stuck,
    /// A task has reached an instruction that this controller does not support. Its effects are unknown, so the run
    /// cannot continue.
    Lacking,
    /// The application or the run was stopped from outside.
    Stopped,
    /// The application was not started because of its faults.
    Refused,
}

impl Outcome {
    /// Whether the cycle has stopped before its end, so that the next call resumes it.
    #[must_use]
    pub fn is_within_cycle(self) -> bool {
        matches!(self, Self::Suspended | Self::AtStop(_) | Self::Seen(_) | Self::Limit)
    }

    /// Whether execution cannot continue without a change from outside.
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
