//! Rows of a trace.

use val3_geometry::{IsometryMatrix3, Vector3};
use val3_kinematics::Joints;
use val3_lang::ports::Time;
use val3_motion::{MotionPhase, Sample};

/// A recorded motion.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Trace {
    /// Name of the arm; `None` in a trace without a heading.
    pub arm: Option<String>,
    /// Number of axes.
    pub axes: usize,
    /// Rows while the arm moves, and the first row at rest after each motion, sorted by time.
    pub rows: Vec<TraceRow>,
}

/// State of the arm at the end of a cycle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TraceRow {
    /// Start time of the cycle in nanoseconds of the controller's clock.
    pub time: Time,
    /// Move id, as returned by `getMoveId`.
    pub id: f64,
    /// Kind of motion.
    pub phase: MotionPhase,
    /// Commanded joint position.
    pub joints: Joints,
    /// Pose of the tool centre point in world, in mm.
    pub pose: IsometryMatrix3<f64>,
    /// Speed of the tool centre point in the cycle, in mm/s.
    pub speed: f64,
}

/// Precision of the id in a file, with which [`TraceRow::number`] is equal before and after writing.
const ID_DECIMALS: f64 = 1e6;

impl TraceRow {
    /// Creates the row of the cycle that began at `time`.
    #[must_use]
    pub fn new(time: Time, sample: &Sample) -> Self {
        let Sample { joints, pose, speed, id, phase } = *sample;
        Self { time, id: (id * ID_DECIMALS).round() / ID_DECIMALS, phase, joints, pose, speed: speed.0 }
    }

    /// Returns the position of the tool centre point in world, in mm.
    #[must_use]
    pub fn position(&self) -> Vector3<f64> {
        self.pose.translation.vector
    }

    /// Whether the arm has moved in the cycle.
    #[must_use]
    pub fn is_moving(&self) -> bool {
        self.phase != MotionPhase::Waiting
    }

    /// Returns the integer part of the id during the move: at the end of move 4, `getMoveId` is already 5.
    #[must_use]
    pub(crate) fn number(&self) -> i64 {
        self.id.ceil() as i64 - 1
    }
}
