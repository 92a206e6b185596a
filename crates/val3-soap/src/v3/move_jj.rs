//! `moveJJ`: moves to joints in joint space.

use super::{MotionDescription, MoveAnswer};
use crate::structure::{operation, structure};

structure! {
    /// Request `moveJJ`.
    MoveJj {
        /// Index of the robot, from 0.
        robot: i32 = "robot",
        /// Joints, in rad or m.
        joints: Vec<f64> = "joint" of "item",
        /// Tool, frame, speeds and blending.
        description: MotionDescription = "mdesc",
    }
}

operation!(MoveJj: V3 "moveJJ" => MoveAnswer, "moveResponse");
