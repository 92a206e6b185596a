//! `getRobotJointPos`: the arm's joints.

use crate::structure::{operation, structure};

structure! {
    /// Request `getRobotJointPos`.
    GetRobotJointPos {
        /// Index of the robot, from 0.
        robot: i32 = "robot",
    }
}

structure! {
    /// Answer of `getRobotJointPos`.
    GetRobotJointPosAnswer {
        /// Joints, in rad or m.
        position: Vec<f64> = "pos" of "item",
    }
}

operation!(GetRobotJointPos: V0 "getRobotJointPos" => GetRobotJointPosAnswer, "getRobotJointPosResponse");
