//! Data of a picture.

use val3_motion::{MotionPhase, SpeedLimit};

/// Data of a run's picture.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Picture {
    /// Title, such as the name of the application.
    pub title: String,
    /// Model of the arm.
    pub arm: String,
    /// Axes of the arm.
    pub axes: Vec<PictureAxis>,
    /// Samples of the motion, sorted by time.
    pub samples: Vec<Sample>,
    /// Moves, in the order in which they were recorded.
    pub moves: Vec<MoveMark>,
    /// Smallest distances between things; empty without things around the arm.
    pub distances: Vec<DistanceSample>,
    /// Recorded motion for comparison; empty without a comparison.
    pub reference: Vec<Sample>,
    /// Largest deviation from the recorded motion.
    pub deviation: Option<Deviation>,
    /// Whether accelerations are drawn.
    pub has_accelerations: bool,
    /// Note on the times, drawn below the charts; `None` if the times come from a measured arm.
    pub times_note: Option<String>,
}

/// Smallest distance between things at one time.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DistanceSample {
    /// Time in seconds.
    pub t: f64,
    /// Distance in mm, negative for an overlap; `None` if it is too large to matter.
    pub distance: Option<f64>,
    /// Distance in mm below which these things are too near to each other.
    pub clearance: f64,
    /// Names of the things, for example `gripper - rack`.
    pub pair: String,
}

/// A point on a motion's path and the nearest point on the other path.
#[derive(Clone, Debug, PartialEq)]
pub struct Deviation {
    /// Distance as text, for example `12.3 mm`.
    pub label: String,
    /// Point in world, in mm.
    pub at: [f64; 3],
    /// Nearest point in world, in mm.
    pub nearest: [f64; 3],
    /// Time at the point, in seconds.
    pub t: f64,
}

/// An axis of the arm, in degrees, or in mm for a linear axis.
#[derive(Clone, Debug, PartialEq)]
pub struct PictureAxis {
    /// Whether the axis is linear.
    pub is_stroke: bool,
    /// Lower software limit.
    pub min: f64,
    /// Upper software limit.
    pub max: f64,
    /// Nominal speed, per second.
    pub nominal_speed: f64,
    /// Nominal acceleration, per second squared.
    pub nominal_acceleration: f64,
    /// Nominal deceleration, per second squared.
    pub nominal_deceleration: f64,
}

/// State of the arm at one time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// Time in seconds.
    pub t: f64,
    /// Positions of the axes.
    pub joints: [f64; 6],
    /// Position of the tool centre point in world, in mm.
    pub position: [f64; 3],
    /// Speed of the tool centre point, in mm/s.
    pub speed: f64,
    /// Rotation speed of the tool, in degrees per second.
    pub rotation: f64,
    /// Kind of motion.
    pub phase: MotionPhase,
    /// Limit that determines the speed from this sample to the next; `None` if unknown.
    pub limit: Option<SpeedLimit>,
}

/// A move.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MoveMark {
    /// Program name.
    pub program: String,
    /// Line in the program's file, from 1.
    pub line: u32,
    /// Tool centre point at the destination, in world, in mm.
    pub target: [f64; 3],
    /// Intermediate point of a circle, in world, in mm.
    pub intermediate: Option<[f64; 3]>,
    /// Beginning of the blend around the destination, in world, in mm.
    pub leave: Option<[f64; 3]>,
    /// End of the blend, in world, in mm.
    pub reach: Option<[f64; 3]>,
    /// Note on the blend, drawn at its beginning, for example `leave 50 → 30 mm`.
    pub note: Option<String>,
    /// Explanation of the note, which viewers show as a tooltip.
    pub explanation: Option<String>,
    /// Limits of the motion descriptor; `None` if unknown.
    pub limits: Option<MoveLimits>,
    /// Start time of the move in seconds.
    pub started: Option<f64>,
    /// Start time of the blend around the destination, in seconds.
    pub blended: Option<f64>,
    /// End time of the move in seconds.
    pub ended: Option<f64>,
}

impl MoveMark {
    /// Formats the program and the line: `start:12`.
    pub(crate) fn label(&self) -> String {
        format!("{}:{}", self.program, self.line)
    }
}

/// Limits of a motion descriptor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MoveLimits {
    /// `vel`: axis speeds in % of the nominal speeds.
    pub joint_speed: f64,
    /// `accel`: axis accelerations in % of the nominal accelerations.
    pub acceleration: f64,
    /// `decel`: axis decelerations in % of the nominal decelerations.
    pub deceleration: f64,
    /// `tvel`: speed of the tool centre point, in mm/s.
    pub tool_speed: f64,
    /// `rvel`: rotation speed of the tool, in degrees per second.
    pub tool_rotation: f64,
}

impl Picture {
    /// Returns the name of the program that requested all moves; `None` if there are several programs or no moves.
    pub(crate) fn only_program(&self) -> Option<&str> {
        let first = self.moves.first()?;
        self.moves.iter().all(|mark| mark.program == first.program).then_some(&first.program)
    }
}
