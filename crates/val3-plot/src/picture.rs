//! The data of a picture.

use val3_motion::{Phase, SpeedLimit};

/// The data of a picture of a run.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Picture {
    /// Its title, such as the name of the application.
    pub title: String,
    /// The model of the arm.
    pub arm: String,
    /// The axes of the arm.
    pub axes: Vec<Axis>,
    /// The motion, in the order of time.
    pub samples: Vec<Sample>,
    /// The moves, in the order in which they were recorded.
    pub moves: Vec<Mark>,
    /// A recorded motion with which this one is compared; empty without one.
    pub reference: Vec<Sample>,
    /// The place at which the motion is the furthest away from the recorded one.
    pub deviation: Option<Deviation>,
    /// Whether accelerations are drawn.
    pub has_accelerations: bool,
    /// Note on the times, drawn below the charts; `None` if they are those of a measured arm.
    pub times_note: Option<String>,
}

/// A place of one motion and the nearest place of another.
#[derive(Clone, Debug, PartialEq)]
pub struct Deviation {
    /// The distance: `12.3 mm`.
    pub label: String,
    /// The place in world, in mm.
    pub at: [f64; 3],
    /// The nearest place in world, in mm.
    pub nearest: [f64; 3],
    /// When the arm was at the place, in seconds.
    pub t: f64,
}

/// An axis of the arm: degrees, or millimetres for a stroke.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// Whether it is a linear axis.
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

/// The arm at one time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// Seconds.
    pub t: f64,
    /// Position of each axis.
    pub joints: [f64; 6],
    /// The tool centre point in world, in mm.
    pub position: [f64; 3],
    /// Speed of the tool centre point, in mm/s.
    pub speed: f64,
    /// Speed of rotation of the tool, in degrees per second.
    pub rotation: f64,
    /// The kind of motion.
    pub phase: Phase,
    /// The limit that determines the speed from here to the next sample; `None` if it is unknown.
    pub limit: Option<SpeedLimit>,
}

/// A move.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mark {
    /// Name of the program.
    pub program: String,
    /// Line in the program's file, from 1.
    pub line: u32,
    /// The tool centre point at the destination, in world, in mm.
    pub target: [f64; 3],
    /// Intermediate point of a circle, in world, in mm.
    pub intermediate: Option<[f64; 3]>,
    /// Where the blend around the destination begins.
    pub leave: Option<[f64; 3]>,
    /// Where it ends.
    pub reach: Option<[f64; 3]>,
    /// Note on the blend, drawn at its beginning: `leave 50 → 30 mm`.
    pub note: Option<String>,
    /// Explanation of the note, which viewers show at it.
    pub explanation: Option<String>,
    /// Limits of the motion descriptor; `None` if they are unknown.
    pub limits: Option<MoveLimits>,
    /// When the arm began with the move, in seconds.
    pub started: Option<f64>,
    /// When the arm began with the blend around the destination, in seconds.
    pub blended: Option<f64>,
    /// When the move was done, in seconds.
    pub ended: Option<f64>,
}

impl Mark {
    /// Program and line: `start:12`.
    pub(crate) fn label(&self) -> String {
        format!("{}:{}", self.program, self.line)
    }
}

/// Limits of a motion descriptor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MoveLimits {
    /// `vel`: speed of each axis, in % of the nominal one.
    pub joint_speed: f64,
    /// `accel`: acceleration of each axis, in % of the nominal one.
    pub acceleration: f64,
    /// `decel`: deceleration of each axis, in % of the nominal one.
    pub deceleration: f64,
    /// `tvel`: speed of the tool centre point, in mm/s.
    pub tool_speed: f64,
    /// `rvel`: speed of rotation of the tool, in degrees per second.
    pub tool_rotation: f64,
}

impl Picture {
    /// Name of the program that requested all moves; `None` if there are several programs or no moves.
    pub(crate) fn only_program(&self) -> Option<&str> {
        let first = self.moves.first()?;
        self.moves.iter().all(|mark| mark.program == first.program).then_some(&first.program)
    }
}
