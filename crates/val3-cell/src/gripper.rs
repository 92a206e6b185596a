//! Grippers.

use val3_geometry::IsometryMatrix3;

use crate::carriers::Carrier;

/// A gripper.
#[derive(Debug, Clone)]
pub struct Gripper {
    /// Name in messages: the tool's name, or for example `gripper 1` without a tool.
    pub name: String,
    /// Output that controls the gripper.
    pub control: GripperControl,
    /// Carrier: the flange or a tool.
    pub carrier: Carrier,
    /// Pose of the grip point in the carrier's frame; for a tool, the tool centre point.
    pub pose: IsometryMatrix3<f64>,
    /// Largest distance between a gripped part and the grip point, in mm.
    pub within: f64,
    /// Input values that the cell sets while the gripper holds a part.
    pub holding: Vec<SignalWrite>,
    /// Input values that the cell sets while the gripper holds no part.
    pub empty: Vec<SignalWrite>,
    /// Indexes of the things that belong to the gripper and may touch parts.
    pub(crate) pieces: Vec<usize>,
}

/// Output that controls a gripper.
#[derive(Debug, Clone, PartialEq)]
pub enum GripperControl {
    /// The output of a tool, with the tool's delays.
    Tool {
        /// Name of the tool.
        tool: String,
        /// Whether the gripper holds while the output is true.
        holds_when_open: bool,
    },
    /// Signals. The gripper holds while all of them have these values.
    Signals(Vec<SignalWrite>),
}

/// A signal and its value.
#[derive(Debug, Clone, PartialEq)]
pub struct SignalWrite {
    /// Path or name of the signal.
    pub path: String,
    /// Value; 0 or 1 for a digital signal.
    pub value: f64,
}

/// Commanded state of a gripper at the end of a cycle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GripperCommand {
    /// Whether the output has its value for holding.
    pub holds: bool,
    /// Time in seconds until a change becomes effective.
    pub delay: f64,
}
