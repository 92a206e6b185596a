//! Motions during which all tasks rest.

use val3_lang::ports::TaskNumber;
use val3_machine::arm::ArmHold;
use val3_machine::controller::MotionPiece;

/// End of a motion during which all tasks rested.
#[derive(Debug, Clone, PartialEq)]
pub struct MotionStop {
    /// Task whose line released the arm; `None` after [`step_motion`](crate::Debugger::step_motion).
    pub task: Option<TaskNumber>,
    /// Piece that the arm has completed, or within which it does not continue; `None` if it has begun no piece.
    pub piece: Option<MotionPiece>,
    /// Whether another piece is determined.
    pub has_next: bool,
    /// Reason why the arm does not move, if it has not arrived.
    pub hold: Option<ArmHold>,
}

/// A motion during which all tasks rest.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Travel {
    /// Task whose line released the arm.
    pub(crate) task: Option<TaskNumber>,
    pub(crate) then: Then,
}

/// Continuation after the motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Then {
    /// The pending stop of the run.
    Stop,
    /// A stop for the motion.
    StopForMotion,
    /// The current step, if it is not complete.
    Continue,
}
