//! Faults of a path.

use std::error::Error;
use std::fmt;

use val3_geometry::ArcError;
use val3_kinematics::{Unreachable, Violation};

/// Fault of a recorded path that the arm cannot follow to its end.
#[derive(Clone, Debug, PartialEq)]
pub struct PathFault {
    /// Number of the move ([`QueuedMove::serial`](crate::QueuedMove::serial)) whose path is impossible.
    pub serial: u64,
    /// Whether the fault is in the blend around the move's destination, not in the nominal path.
    pub is_blend: bool,
    /// Cause of the fault.
    pub cause: Cause,
}

impl fmt::Display for PathFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let part = if self.is_blend { "on the blend around the destination, " } else { "" };
        write!(f, "{part}{}", self.cause)
    }
}

/// Cause of a path fault.
#[derive(Clone, Debug, PartialEq)]
pub enum Cause {
    /// A pose on the path cannot be reached in the configuration at the start.
    Unreachable(Unreachable),
    /// The intermediate point of a circle cannot be reached in any configuration (manual 10.6).
    Intermediate(Unreachable),
    /// The destination exceeds a software limit.
    OutOfRange(Violation),
    /// Near a singularity, an axis would have to jump.
    Singular,
    /// The three poses define no circle.
    Arc(ArcError),
    /// The required configuration differs from the configuration at the start, which the path cannot change (manual
    /// 10.1.4.2).
    Configuration,
    /// The orientation changes by half a turn or more within a Cartesian blend (manual 10.1.2.3).
    Reorientation,
    /// The speed on the altered path exceeds the limits of `alterBegin` (manual 11.2.6).
    AlterSpeed,
    /// The move before a compliant move has a blend (manual 11.1.4).
    BlendBeforeCompliant,
}

impl fmt::Display for Cause {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unreachable(cause) => cause.fmt(f),
            Self::Intermediate(cause) => write!(f, "at the intermediate point, {cause}"),
            Self::OutOfRange(violation) => violation.fmt(f),
            Self::Singular => f.write_str("the path passes a singularity, where an axis would have to jump"),
            Self::Arc(error) => error.fmt(f),
            Self::Configuration => {
                f.write_str("a straight line or a circle cannot change the configuration; use a joint move, or `free`")
            }
            Self::Reorientation => f.write_str(
                "the orientation changes by 180 degrees or more within the Cartesian blend; add an intermediate point",
            ),
            Self::AlterSpeed => f.write_str(
                "the altered path is faster than `alterBegin` allows; change the alteration in smaller steps",
            ),
            Self::BlendBeforeCompliant => {
                f.write_str("a compliant move starts at rest; use `blend = off` for the move before it")
            }
        }
    }
}

impl Error for Cause {}

impl From<Unreachable> for Cause {
    fn from(cause: Unreachable) -> Self {
        Self::Unreachable(cause)
    }
}

impl From<ArcError> for Cause {
    fn from(error: ArcError) -> Self {
        Self::Arc(error)
    }
}
