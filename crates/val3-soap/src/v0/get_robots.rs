//! `getRobots`: the arms of the controller.

use super::RobotDescription;
use crate::structure::{operation, structure};

structure! {
    /// Request `getRobots`.
    GetRobots {}
}

structure! {
    /// Answer of `getRobots`.
    GetRobotsAnswer {
        /// Arms, sorted by index.
        robots: Vec<RobotDescription> = "out" of "Robots",
    }
}

operation!(GetRobots: V0 "getRobots" => GetRobotsAnswer, "getRobotsResponse");
