//! Conveyors.

use val3_collision::Bounds;
use val3_geometry::IsometryMatrix3;

use crate::carriers::Carrier;
use crate::file::ConveyorEnd;
use crate::gripper::SignalWrite;

/// A conveyor. The thing with the same name is the belt.
#[derive(Debug, Clone)]
pub struct Conveyor {
    /// Name in messages.
    pub name: String,
    /// Signal values at which the conveyor runs; empty if it always runs.
    pub when: Vec<SignalWrite>,
    /// Speed of the belt, in mm/s.
    pub speed: f64,
    /// Effect on a part that reaches the end of the belt.
    pub end: ConveyorEnd,
    /// Parts that arrive on the conveyor from outside of the cell.
    pub feed: Option<Feed>,
    /// Carrier of the belt: `world` or a frame.
    pub(crate) carrier: Carrier,
    /// Pose of the track in the carrier. The track is the frame in the centre of the belt with x in the transport
    /// direction.
    pub(crate) track: IsometryMatrix3<f64>,
    /// Box of the belt, in the track's frame.
    pub(crate) belt: Bounds,
}

/// Parts that arrive on a conveyor from outside of the cell.
#[derive(Debug, Clone)]
pub struct Feed {
    /// Part indexes, in the order of arrival.
    pub(crate) parts: Vec<usize>,
    /// Time between two parts in seconds, counted while the conveyor runs.
    pub(crate) every: f64,
    /// Pose of a new part in the conveyor's carrier.
    pub(crate) pose: IsometryMatrix3<f64>,
}
