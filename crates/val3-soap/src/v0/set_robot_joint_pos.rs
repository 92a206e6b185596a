//! `setRobotJointPos`: moves a simulated arm without power to a position, in no time.

use crate::structure::{operation, structure};
use crate::value::Empty;

structure! {
    /// Request `setRobotJointPos`.
    SetRobotJointPos {
        /// Index of the robot, from 0.
        robot: i32 = "robot",
        /// Joints, in rad or m.
        position: Vec<f64> = "pos" of "item",
    }
}

operation!(SetRobotJointPos: V0 "setRobotJointPos" => Empty, "setRobotPosResponse");
