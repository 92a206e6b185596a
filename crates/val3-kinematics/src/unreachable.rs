//! Reasons why an arm cannot reach a pose.

use std::error::Error;
use std::fmt;

/// Reason why an arm cannot reach a pose, on one branch or on all allowed branches.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Unreachable {
    /// The target is too far from the shoulder or too near to it.
    OutOfReach {
        /// Distance from the shoulder (axis 1 of a SCARA arm) to the centre of the wrist, in mm.
        distance: f64,
        /// Smallest distance that the arm reaches, in mm.
        min: f64,
        /// Largest distance that the arm reaches, in mm.
        max: f64,
    },
    /// The centre of the wrist is inside the cylinder about axis 1 whose radius is the lateral offset of the forearm.
    InsideCylinder {
        /// Distance from axis 1 to the centre of the wrist, in mm.
        distance: f64,
        /// Radius of the cylinder, in mm.
        radius: f64,
    },
    /// An axis would leave its range.
    Limit {
        /// Axis number, from 1.
        axis: usize,
        /// Position of the axis, in degrees, or in mm for a stroke.
        position: f64,
        /// Lower limit.
        min: f64,
        /// Upper limit.
        max: f64,
        /// Unit of the positions: `degrees` or `mm`.
        unit: &'static str,
    },
    /// The flange of a SCARA arm would be tilted, but its z axis always points down.
    Tilted {
        /// Angle between the requested z axis and the vertical, in degrees.
        angle: f64,
    },
    /// The joints of a calibrated arm could not be computed, which happens near singularities.
    NotConverged,
}

impl Unreachable {
    /// Returns a rank by which reasons on several branches are compared: a higher one is closer to a solution.
    pub(crate) const fn progress(&self) -> u8 {
        match self {
            Self::Tilted { .. } => 0,
            Self::InsideCylinder { .. } => 1,
            Self::OutOfReach { .. } => 2,
            Self::NotConverged => 3,
            Self::Limit { .. } => 4,
        }
    }
}

impl fmt::Display for Unreachable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::OutOfReach { distance, min, max } => write!(
                f,
                "the centre of the wrist would be {distance:.1} mm from the shoulder, the arm reaches {min:.1} to \
                 {max:.1} mm"
            ),
            Self::InsideCylinder { distance, radius } => write!(
                f,
                "the centre of the wrist would be {distance:.1} mm from axis 1, the arm needs at least {radius:.1} mm"
            ),
            Self::Limit { axis, position, min, max, unit } => {
                write!(f, "axis {axis} would be at {position:.3}, its limits are {min} and {max} {unit}")
            }
            Self::Tilted { angle } => {
                write!(f, "the flange would be tilted by {angle:.3} degrees, this arm keeps it vertical")
            }
            Self::NotConverged => {
                f.write_str("the joints of the calibrated arm cannot be computed near this singular position")
            }
        }
    }
}

impl Error for Unreachable {}
