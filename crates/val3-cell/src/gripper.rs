//! Grippers.

use val3_geometry::IsometryMatrix3;

use crate::carriers::Carrier;

/// A gripper.
#[derive(Debug, Clone)]
pub struct Gripper {
    /// Name in messages: the name of the tool.
    pub name: String,
    /// Output that controls it.
    pub control: GripperControl,
    /// Carrier: the flange or a tool.
    pub carrier: Carrier,
    /// Pose of the grip point in the frame of the carrier: the tool centre point, for a tool.
    pub pose: IsometryMatrix3<f64>,
    /// Greatest distance in mm of a gripped part from the grip point.
    pub within: f64,
    /// Paths and values of signals while it holds a part.
    pub holding: Vec<SignalWrite>,
    /// Paths and values of signals while it holds no part.
    pub empty: Vec<SignalWrite>,
    /// Numbers of the things that may touch parts.
    pub(crate) pieces: Vec<usize>,
}

/// Output that controls a gripper.
#[derive(Debug, Clone, PartialEq)]
pub enum GripperControl {
    /// The output of a tool, after the times of the tool.
    Tool {
        /// Name of the tool.
        tool: String,
        /// Whether the gripper holds while the output is true.
        holds_when_open: bool,
    },
    /// Signals: it holds while all of them have these values.
    Signals(Vec<SignalWrite>),
}

/// A value of a signal.
#[derive(Debug, Clone, PartialEq)]
pub struct SignalWrite {
    /// Path or name of the signal.
    pub path: String,
    /// Value; 0 or 1 for a digital signal.
    pub value: f64,
}

/// State of a gripper's output at the end of a cycle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GripperCommand {
    /// Whether the output has the value for holding.
    pub holds: bool,
    /// Delay of a change, in seconds.
    pub delay: f64,
}
