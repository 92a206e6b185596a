//! Conveyors.

use val3_collision::Bounds;
use val3_geometry::IsometryMatrix3;

use crate::carriers::Carrier;
use crate::file::ConveyorEnd;
use crate::gripper::SignalWrite;

/// A conveyor, whose belt is a thing of the cell with the same name.
#[derive(Debug, Clone)]
pub struct Conveyor {
    /// Name in messages.
    pub name: String,
    /// Paths and values of signals while which it runs; empty if it always runs.
    pub when: Vec<SignalWrite>,
    /// Speed of the parts, in mm/s.
    pub speed: f64,
    /// Effect of the end of the belt on a part.
    pub end: ConveyorEnd,
    /// Parts that it receives from outside of the cell.
    pub feed: Option<Feed>,
    /// Carrier of the belt: `world` or a frame.
    pub(crate) carrier: Carrier,
    /// Pose in the carrier of the track: the frame in the centre of the belt whose x axis is the direction of the parts.
    pub(crate) track: IsometryMatrix3<f64>,
    /// The belt in the frame of the track.
    pub(crate) belt: Bounds,
}

/// Parts that a conveyor receives from outside of the cell.
#[derive(Debug, Clone)]
pub struct Feed {
    /// Numbers of the parts, in the order in which they arrive.
    pub(crate) parts: Vec<usize>,
    /// Time in seconds from one part to the next, while the conveyor runs.
    pub(crate) every: f64,
    /// Pose of a new part in the carrier of the conveyor.
    pub(crate) pose: IsometryMatrix3<f64>,
}
