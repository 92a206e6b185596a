//! `schedulerRefresh`: the state of the moves and the arms.

use super::{RobotPosition, SchedulingMode};
use crate::structure::{operation, structure};

structure! {
    /// Request `schedulerRefresh`.
    SchedulerRefresh {}
}

structure! {
    /// Answer of `schedulerRefresh`.
    SchedulerRefreshAnswer {
        /// Scheduling mode.
        mode: SchedulingMode = "schedulingMode",
        /// Whether all moves are done.
        is_empty: bool = "motionEmpty",
        /// Arms.
        robots: Vec<RobotPosition> = "allRobotsPos" of "RobotsPos",
    }
}

operation!(SchedulerRefresh: V3 "schedulerRefresh" => SchedulerRefreshAnswer, "MotionAndRobotsPos");
