//! Status of a run after a step of the controller.

use val3_lang::ports::{TaskNumber, Time};
use val3_vm::CycleEnd;

/// Status of a run after a step of the controller.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RunStatus {
    /// The cycle is complete, and tasks can continue in the next one.
    Busy,
    /// The cycle is complete, and all tasks wait until this time, or for another event.
    Waiting(Option<Time>),
    /// The host has interrupted the cycle. The next step resumes it.
    Suspended,
    /// A task has reached a line with a stop mark. The next step resumes the cycle, and the task begins the line.
    AtStop(TaskNumber),
    /// A task that the caller [watches](val3_vm::CycleWatch) has executed a line or failed. The next step resumes the cycle.
    Seen(TaskNumber),
    /// The clock has reached the limit of the run. With a later limit, the next step resumes the cycle.
    Limit,
    /// The application has ended.
    Finished,
    /// The application was stopped from outside.
    Stopped,
    /// No task can continue: all are halted or in error.
    Stuck,
    /// A task has reached an instruction that this controller does not support. Its effects are unknown, so the run
    /// cannot continue.
    Unsupported,
}

impl RunStatus {
    /// Whether the cycle has stopped before its end, so that the next step resumes it.
    #[must_use]
    pub fn is_within_cycle(self) -> bool {
        matches!(self, Self::Suspended | Self::AtStop(_) | Self::Seen(_) | Self::Limit)
    }

    /// Whether the run cannot continue without a change from outside.
    #[must_use]
    pub fn is_final(self) -> bool {
        matches!(self, Self::Finished | Self::Stopped | Self::Stuck | Self::Unsupported)
    }
}

impl From<CycleEnd> for RunStatus {
    fn from(end: CycleEnd) -> Self {
        match end {
            CycleEnd::Busy => Self::Busy,
            CycleEnd::Waiting(wake) => Self::Waiting(wake),
            CycleEnd::Suspended => Self::Suspended,
            CycleEnd::AtStop(task) => Self::AtStop(task),
            CycleEnd::Seen(task) => Self::Seen(task),
            CycleEnd::Limit => Self::Limit,
        }
    }
}
