//! The rows of a trace.

use val3_geometry::{IsometryMatrix3, Vector3};
use val3_kinematics::Joints;
use val3_lang::ports::Time;
use val3_motion::{Phase, Sample};

/// A recorded motion.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Trace {
    /// The name of the arm; none in a trace without a heading.
    pub arm: Option<String>,
    /// The number of its axes.
    pub axes: usize,
    /// The arm while it moves, and the first row at rest after each motion, in the order of time.
    pub rows: Vec<Row>,
}

/// The arm at the end of a cycle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Row {
    /// When the cycle began, in nanoseconds of the controller's clock.
    pub time: Time,
    /// `getMoveId`.
    pub id: f64,
    /// The kind of motion.
    pub phase: Phase,
    /// Commanded joint position.
    pub joints: Joints,
    /// The tool centre point in world, in mm.
    pub pose: IsometryMatrix3<f64>,
    /// Speed of the tool centre point over the cycle, in mm/s.
    pub speed: f64,
}

/// Decimals of the id in a file, with which [`Row::number`] is the same before and after it is written.
const ID_DECIMALS: f64 = 1e6;

impl Row {
    /// The row of the cycle that began at a time.
    #[must_use]
    pub fn new(time: Time, sample: &Sample) -> Self {
        let Sample { joints, pose, speed, id, phase } = *sample;
        Self { time, id: (id * ID_DECIMALS).round() / ID_DECIMALS, phase, joints, pose, speed: speed.0 }
    }

    /// The place of the tool centre point in world, in mm.
    #[must_use]
    pub fn position(&self) -> Vector3<f64> {
        self.pose.translation.vector
    }

    /// Whether the arm has moved in the cycle.
    #[must_use]
    pub fn is_moving(&self) -> bool {
        self.phase != Phase::Waiting
    }

    /// The whole part of the id during its move: at the end of move 4, `getMoveId` is already 5.
    #[must_use]
    pub(crate) fn number(&self) -> i64 {
        self.id.ceil() as i64 - 1
    }
}
