//! `moveL`: moves to a position on a line.

use super::{Matrix, MotionDescription, MoveAnswer};
use crate::structure::{operation, structure};

structure! {
    /// Request `moveL`.
    MoveL {
        /// Index of the robot, from 0.
        robot: i32 = "robot",
        /// Destination.
        frame: Matrix = "frame",
        /// Tool, frame, speeds and blending.
        description: MotionDescription = "mdesc",
    }
}

operation!(MoveL: V3 "moveL" => MoveAnswer, "moveResponse");
