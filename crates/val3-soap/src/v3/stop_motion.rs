//! `stopMotion`: stops the arm on its path.

use super::MotionAnswer;
use crate::structure::{operation, structure};

structure! {
    /// Request `stopMotion`.
    StopMotion {}
}

operation!(StopMotion: V3 "stopMotion" => MotionAnswer, "motionResponse");
