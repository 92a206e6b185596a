//! `moveJC`: moves to a position in joint space.

use super::{Matrix, MotionDescription, MoveAnswer};
use crate::structure::{operation, structure};

structure! {
    /// Request `moveJC`.
    MoveJc {
        /// Index of the robot, from 0.
        robot: i32 = "robot",
        /// Destination.
        frame: Matrix = "frame",
        /// Tool, frame, speeds and blending.
        description: MotionDescription = "mdesc",
    }
}

operation!(MoveJc: V3 "moveJC" => MoveAnswer, "moveResponse");
