//! The move that a caller records, in numbers only.

use val3_geometry::IsometryMatrix3;
use val3_kinematics::{Joints, RequestedConfiguration};

use crate::units::{DegreesPerSecond, Millimetres, MillimetresPerSecond, Percent};

/// A corner that begins or ends nearer to its destination, in mm, does so at the destination.
const LEAST_CORNER: f64 = 1e-3;

/// One recorded move: where to, with which tool, within which limits, and how its corner is rounded.
#[derive(Clone, Debug)]
pub struct Move {
    /// Path and destination.
    pub path: MovePath,
    /// The tool centre point relative to the flange.
    pub tool: IsometryMatrix3<f64>,
    /// Limits of speed and acceleration.
    pub limits: Limits,
    /// How the corner at the destination is rounded when another move follows.
    pub blend: Blend,
    /// The id that `getMoveId` gives while this move is executed (manual 10.6).
    pub id: f64,
    /// How the arm follows the path.
    pub manner: Manner,
}

/// How the arm follows the path of a move.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Manner {
    /// Exactly.
    #[default]
    Rigid,
    /// A force moves it along the path, in per cent of the nominal load (`movejf`, `movelf`). The arm stops at both ends.
    Compliant(Percent),
    /// [`Motion::alter`](crate::Motion::alter) transforms the path (`alterMovej`, `alterMovel`, `alterMovec`).
    Alterable,
}

/// The shape of a move's nominal path.
#[derive(Clone, Debug)]
pub enum MovePath {
    /// `movej`: a straight line in joint space.
    Joint(Joints),
    /// `movel`: the tool centre point moves on a straight line.
    Line(Destination),
    /// `movec`: the tool centre point moves on the circle through an intermediate pose, which is the first one.
    Circle(IsometryMatrix3<f64>, Destination),
}

/// Where a Cartesian move ends.
#[derive(Clone, Debug)]
pub struct Destination {
    /// The tool centre point in world.
    pub pose: IsometryMatrix3<f64>,
    /// The configuration that the program requires (manual 9.7).
    pub configuration: RequestedConfiguration,
}

/// Greatest speeds and accelerations of a move, as absolute values of the arm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// Speed of each axis, in degrees (linear axes: mm) per second.
    pub speed: [f64; 6],
    /// Increase of speed of each axis, per second squared.
    pub acceleration: [f64; 6],
    /// Decrease of speed of each axis, per second squared.
    pub deceleration: [f64; 6],
    /// `tvel`: speed of the tool centre point.
    pub translation: MillimetresPerSecond,
    /// `rvel`: speed of rotation of the tool.
    pub rotation: DegreesPerSecond,
}

/// The field `blend` with `leave` and `reach` (manual 10.1.2): distances of the tool centre point to the destination.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Blend {
    /// The arm stops at the destination.
    Off,
    /// A smooth curve in joint space.
    Joint {
        /// Distance to the destination at which the nominal path ends.
        leave: Millimetres,
        /// Distance to the destination at which the path of the next move begins.
        reach: Millimetres,
    },
    /// Two circular arcs of the tool centre point.
    Cartesian {
        /// Distance to the destination at which the nominal path ends.
        leave: Millimetres,
        /// Distance to the destination at which the path of the next move begins.
        reach: Millimetres,
    },
}

impl Move {
    /// The blend at the destination. A compliant move has none.
    pub(crate) fn corner(&self) -> Blend {
        match self.manner {
            Manner::Compliant(_) => Blend::Off,
            Manner::Rigid | Manner::Alterable => self.blend,
        }
    }
}

impl Blend {
    /// `leave` and `reach` in mm, where less than a thousandth counts as 0; none if the arm stops.
    #[must_use]
    pub fn distances(&self) -> Option<(f64, f64)> {
        let (Self::Joint { leave, reach } | Self::Cartesian { leave, reach }) = self else { return None };
        let [leave, reach] = [leave.0, reach.0].map(|distance| if distance < LEAST_CORNER { 0.0 } else { distance });
        (leave > 0.0 || reach > 0.0).then_some((leave, reach))
    }
}
