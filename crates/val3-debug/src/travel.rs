//! Motions for which all tasks rest.

use val3_lang::ports::TaskNumber;
use val3_machine::arm::ArmHold;
use val3_machine::controller::MotionPiece;

/// The end of a motion for which all tasks have rested.
#[derive(Debug, Clone, PartialEq)]
pub struct MotionStop {
    /// The task whose line has released the arm; none after [`step_motion`](crate::Debugger::step_motion).
    pub task: Option<TaskNumber>,
    /// The piece at whose end the arm is, or in which it does not move on. None if it has begun none.
    pub piece: Option<MotionPiece>,
    /// Whether another piece is determined.
    pub has_next: bool,
    /// Why the arm does not move, where it has not arrived.
    pub hold: Option<ArmHold>,
}

/// A motion for which all tasks rest.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Travel {
    /// The task whose line has released the arm.
    pub(crate) task: Option<TaskNumber>,
    pub(crate) then: Then,
}

/// The continuation after a motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Then {
    /// The pending stop of the run.
    Stop,
    /// The run stops for the motion.
    StopForMotion,
    /// A step that is not done continues.
    Continue,
}
