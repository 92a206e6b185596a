//! End of a run: its reason, and the rest of a served run.

use val3_machine::controller::RunStatus;
use val3_machine::event::EndReason;

use super::standby::Standby;
use super::viewers::Viewers;

/// End reason of a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum End {
    /// The controller, with its last status.
    Controller(RunStatus),
    /// The replayed recording has ended, for this reason.
    Recorded(EndReason),
    /// The output is closed.
    Unread,
    /// An output cannot be written.
    Unwritten,
    /// The debug client has ended the run.
    Left,
    /// The debug client has requested a restart.
    Restart,
    /// The operator has aborted `stop`, or a signal arrived. The value is the exit code.
    BrokenOff(u8),
}

/// Ended run with its viewers.
pub(super) struct EndedRun {
    pub(super) viewers: Viewers,
    /// The controller, in whose memory points are changed and whose arm is moved by hand.
    pub(super) standby: Standby,
}
