//! `getJointRange`: the arm's joint limits.

use super::JointRange;
use crate::structure::{operation, structure};

structure! {
    /// Request `getJointRange`.
    GetJointRange {
        /// Index of the robot, from 0.
        robot: i32 = "robot",
    }
}

structure! {
    /// Answer of `getJointRange`.
    GetJointRangeAnswer {
        /// Limits.
        range: JointRange = "range",
    }
}

operation!(GetJointRange: V1 "getJointRange" => GetJointRangeAnswer, "getJointRangeResponse");
