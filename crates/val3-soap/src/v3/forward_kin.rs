//! `forwardKin`: the position of the flange for joints.

use super::{ArmConfig, Matrix};
use crate::structure::{operation, structure};

structure! {
    /// Request `forwardKin`.
    ForwardKin {
        /// Index of the robot, from 0.
        robot: i32 = "robot",
        /// Joints, in rad or m.
        joints: Vec<f64> = "joint" of "item",
    }
}

structure! {
    /// Answer of `forwardKin`.
    ForwardKinAnswer {
        /// Flange in `world`.
        position: Matrix = "position",
        /// Configuration of the arm.
        config: ArmConfig = "config",
    }
}

operation!(ForwardKin: V3 "forwardKin" => ForwardKinAnswer, "forwardKinResponse");
