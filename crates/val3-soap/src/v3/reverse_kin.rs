//! `reverseKin`: joints for a position of the flange.

use super::{ArmConfig, Matrix, ReversingResult};
use crate::structure::{operation, structure};
use crate::v1::JointRange;

structure! {
    /// Request `reverseKin`.
    ReverseKin {
        /// Index of the robot, from 0.
        robot: i32 = "robot",
        /// Joints near which the solution is searched, in rad or m.
        near: Vec<f64> = "jointIn" of "item",
        /// Flange in `world`.
        target: Matrix = "target",
        /// Permitted configurations.
        config: ArmConfig = "config",
        /// Permitted joints; the limits of the arm if the lists are empty.
        range: JointRange = "jointRange",
    }
}

structure! {
    /// Answer of `reverseKin`.
    ReverseKinAnswer {
        /// Joints, in rad or m.
        joints: Vec<f64> = "jointOut" of "item",
        /// Result.
        result: ReversingResult = "reversingResult",
    }
}

operation!(ReverseKin: V3 "reverseKin" => ReverseKinAnswer, "reverseKinResponse");
