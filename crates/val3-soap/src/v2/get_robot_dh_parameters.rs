//! `getRobotDhParameters`: Denavit-Hartenberg parameters of the arm's joints.

use super::DhParameters;
use crate::structure::{operation, structure};

structure! {
    /// Request `getRobotDhParameters`.
    GetRobotDhParameters {
        /// Index of the robot, from 0.
        robot: i32 = "robot",
    }
}

structure! {
    /// Answer of `getRobotDhParameters`.
    GetRobotDhParametersAnswer {
        /// Parameters, by joint.
        joints: Vec<DhParameters> = "dhParametersArray" of "DhParameters",
        /// Distance of the flange from the last joint, in m.
        last_d: f64 = "lastDParam",
    }
}

operation!(GetRobotDhParameters: V2 "getRobotDhParameters" => GetRobotDhParametersAnswer, "SoapRobotDhParameters");
