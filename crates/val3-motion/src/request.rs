//! Move request, in numbers only.

use val3_geometry::IsometryMatrix3;
use val3_moves::{Blend, DegreesPerSecond, Manner, MillimetresPerSecond, MovePath};

/// Move with its limits.
#[derive(Clone, Debug)]
pub struct Move {
    /// Path and destination.
    pub path: MovePath,
    /// Tool centre point relative to the flange.
    pub tool: IsometryMatrix3<f64>,
    /// Limits of speed and acceleration.
    pub limits: SpeedLimits,
    /// Blend around the destination if another move follows.
    pub blend: Blend,
    /// Id that `getMoveId` returns during the move (manual 10.6).
    pub id: f64,
    /// Manner in which the arm follows the path.
    pub manner: Manner,
}

/// Maximum speeds and accelerations of a move, as absolute values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpeedLimits {
    /// Axis speeds, in degrees (linear axes: mm) per second.
    pub speed: [f64; 6],
    /// Axis accelerations, per second squared.
    pub acceleration: [f64; 6],
    /// Axis decelerations, per second squared.
    pub deceleration: [f64; 6],
    /// `tvel`: speed of the tool centre point.
    pub translation: MillimetresPerSecond,
    /// `rvel`: rotation speed of the tool.
    pub rotation: DegreesPerSecond,
}

impl Move {
    /// Blend at the destination; [`Blend::Off`] for a compliant move.
    pub(crate) fn corner(&self) -> Blend {
        match self.manner {
            Manner::Compliant(_) => Blend::Off,
            Manner::Rigid | Manner::Alterable => self.blend,
        }
    }
}
