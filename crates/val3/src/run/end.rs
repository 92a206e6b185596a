//! The reason why a run has ended.

use val3_machine::controller::Outcome;
use val3_machine::event::EndReason;

/// The reason why a run has ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum End {
    /// The controller, with its last outcome.
    Controller(Outcome),
    /// The replayed recording has ended, for this reason.
    Recorded(EndReason),
    /// The output is no longer read.
    Unread,
    /// The client of the debugger has ended it.
    Left,
    /// The client of the debugger wants it from its beginning.
    Restart,
    /// The operator did not wait for `stop`, or a signal arrived. With the exit code.
    BrokenOff(u8),
}
