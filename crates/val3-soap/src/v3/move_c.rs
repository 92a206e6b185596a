//! `moveC`: moves to a position on a circle.

use super::{Matrix, MotionDescription, MoveAnswer};
use crate::structure::{operation, structure};

structure! {
    /// Request `moveC`.
    MoveC {
        /// Index of the robot, from 0.
        robot: i32 = "robot",
        /// Position on the circle.
        intermediate: Matrix = "frameB",
        /// Destination.
        destination: Matrix = "frameC",
        /// Tool, frame, speeds and blending.
        description: MotionDescription = "mdesc",
    }
}

operation!(MoveC: V3 "moveC" => MoveAnswer, "moveResponse");
