//! `getRobotJntCartPos`: the arm's joints, and the tool's position.

use super::CartesianPosition;
use crate::structure::{operation, structure};

structure! {
    /// Request `getRobotJntCartPos`.
    GetRobotJntCartPos {
        /// Index of the robot, from 0.
        robot: i32 = "robot",
        /// Tool relative to the flange; the flange without.
        tool: Option<CartesianPosition> = "tool",
        /// Frame of the answer, relative to `world`; `world` without.
        frame: Option<CartesianPosition> = "frame",
    }
}

structure! {
    /// Answer of `getRobotJntCartPos`.
    GetRobotJntCartPosAnswer {
        /// Joints, in rad or m.
        joints: Vec<f64> = "jntPos" of "item",
        /// Position of the tool in the frame.
        position: CartesianPosition = "cartPos",
    }
}

operation!(GetRobotJntCartPos: V0 "getRobotJntCartPos" => GetRobotJntCartPosAnswer, "getRobotJntCartPosResponse");
