//! `restartMotion`: continues the moves after a stop.

use super::MotionAnswer;
use crate::structure::{operation, structure};

structure! {
    /// Request `restartMotion`.
    RestartMotion {}
}

operation!(RestartMotion: V3 "restartMotion" => MotionAnswer, "motionResponse");
