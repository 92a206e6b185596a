//! Reasons why a turn of a task or a cycle ends (5.4).

use val3_lang::fault::Fault;
use val3_lang::ports::{TaskNumber, Time};

/// Reason why a turn of a task has ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TurnEnd {
    /// The lines of the turn are used up.
    Busy,
    /// The task waits until this time, or for another event.
    Waiting(Option<Time>),
    /// The task pauses until this time after an instruction that used time outside the program.
    Pausing(Time),
    /// The host has interrupted the turn. The next turn resumes it.
    Suspended,
    /// The task has reached a line with a stop mark. The next turn begins the line.
    AtStop(TaskNumber),
    /// The program of the task has ended.
    Finished,
    /// The task has halted or killed itself.
    Halted,
    /// A run-time error has stopped the task.
    Failed(Fault),
    /// The task has reached an instruction that this controller does not support. Its effects are unknown, so the run
    /// cannot continue.
    Unsupported,
}

impl TurnEnd {
    /// Returns the end of the cycle that such a turn stops; `None` if the cycle continues with other turns.
    pub(crate) fn cycle_end(self) -> Option<CycleEnd> {
        match self {
            Self::Suspended => Some(CycleEnd::Suspended),
            Self::AtStop(task) => Some(CycleEnd::AtStop(task)),
            Self::Busy
            | Self::Waiting(_)
            | Self::Pausing(_)
            | Self::Finished
            | Self::Halted
            | Self::Failed(_)
            | Self::Unsupported => None,
        }
    }
}

/// Reason why a cycle has ended, or stopped before its end.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CycleEnd {
    /// The cycle is complete, and tasks can continue in the next one.
    Busy,
    /// The cycle is complete, and all tasks wait until this time, or for another event.
    Waiting(Option<Time>),
    /// The host has interrupted the cycle. The next call resumes it.
    Suspended,
    /// A task has reached a line with a stop mark. The next call resumes the cycle, and the task begins the line.
    AtStop(TaskNumber),
    /// A task that the caller [watches](crate::CycleWatch) has executed a line or failed. The next call resumes the cycle.
    Seen(TaskNumber),
    /// The clock has reached the limit of the run. With a later limit, the next call resumes the cycle.
    Limit,
}

impl CycleEnd {
    /// Whether the cycle has stopped before its end, so that the next call resumes it.
    #[must_use]
    pub fn is_within_cycle(self) -> bool {
        match self {
            Self::Suspended | Self::AtStop(_) | Self::Seen(_) | Self::Limit => true,
            Self::Busy | Self::Waiting(_) => false,
        }
    }
}
