//! `resetMotion`: removes all moves.

use super::MotionAnswer;
use crate::structure::{operation, structure};

structure! {
    /// Request `resetMotion`.
    ResetMotion {}
}

operation!(ResetMotion: V3 "resetMotion" => MotionAnswer, "motionResponse");
