//! Limit that determines the current speed of the arm.

use std::fmt;
use std::sync::Arc;

use crate::bounds::AXES;
use crate::model::Model;
use crate::span::{Reduction, Span};
use crate::timeline::Timeline;

/// Fraction of full speed below which the monitor speed counts as the limit; above it, a limit of the path does.
const FULL_PACE: f64 = 0.98;

/// Limit that determines the speed of the arm. Axes count from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum SpeedLimit {
    /// Axis acceleration.
    Acceleration(usize),
    /// Axis deceleration, before a slower part of the path or a stop.
    Deceleration(usize),
    /// Axis speed.
    AxisSpeed(usize),
    /// Speed of the tool centre point (`tvel`).
    Translation,
    /// Rotation speed of the tool (`rvel`).
    Rotation,
    /// Axis acceleration caused by a blend's curvature.
    Corner,
    /// Reduced speed of the tool, as in manual mode.
    ReducedSpeed,
    /// Monitor speed below 100 %, or its ramp.
    MonitorSpeed,
    /// The arm brakes for a stop.
    Stop,
    /// The arm returns to its path at the speed of connection moves.
    Connection,
    /// A force moves the arm along its path.
    Force,
    /// A deviation moves an arm that rests on its path.
    Alter,
    /// The arm rests because its next move is not recorded yet.
    NextMove,
    /// The arm rests at a path fault.
    Fault,
    /// A stop, no power, step mode, or a position away from the path holds the arm.
    Held,
    /// The arm rests because all recorded moves are done.
    End,
}

impl SpeedLimit {
    /// All limits.
    pub fn all() -> impl Iterator<Item = Self> {
        let axes =
            (0..AXES).flat_map(|axis| [Self::Acceleration(axis), Self::Deceleration(axis), Self::AxisSpeed(axis)]);
        axes.chain([
            Self::Translation,
            Self::Rotation,
            Self::Corner,
            Self::ReducedSpeed,
            Self::MonitorSpeed,
            Self::Stop,
            Self::Connection,
            Self::Force,
            Self::Alter,
            Self::NextMove,
            Self::Fault,
            Self::Held,
            Self::End,
        ])
    }

    /// Axis of the limit, from 0; `None` for a limit without an axis.
    #[must_use]
    pub const fn axis(self) -> Option<usize> {
        match self {
            Self::Acceleration(axis) | Self::Deceleration(axis) | Self::AxisSpeed(axis) => Some(axis),
            _ => None,
        }
    }

    /// Limit with this name; `None` if the name is unknown.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        Self::all().find(|limit| limit.to_string() == name)
    }
}

/// Name of the limit, without commas.
impl fmt::Display for SpeedLimit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Acceleration(axis) => write!(f, "acceleration of axis {}", axis + 1),
            Self::Deceleration(axis) => write!(f, "deceleration of axis {}", axis + 1),
            Self::AxisSpeed(axis) => write!(f, "speed of axis {}", axis + 1),
            Self::Translation => f.write_str("tvel"),
            Self::Rotation => f.write_str("rvel"),
            Self::Corner => f.write_str("corner"),
            Self::ReducedSpeed => f.write_str("manual mode"),
            Self::MonitorSpeed => f.write_str("monitor speed"),
            Self::Stop => f.write_str("stop"),
            Self::Connection => f.write_str("connection"),
            Self::Force => f.write_str("force"),
            Self::Alter => f.write_str("alter"),
            Self::NextMove => f.write_str("next move"),
            Self::Fault => f.write_str("path fault"),
            Self::Held => f.write_str("held"),
            Self::End => f.write_str("end"),
        }
    }
}

/// Source of a cycle's speed limit. A limit on the path is computed only when an observer requests it.
#[derive(Clone, Debug)]
pub(crate) enum ActingLimit {
    /// Limit without further computation.
    Known(SpeedLimit),
    /// The arm followed its path.
    OnPath(PathState),
}

/// Arm state on the path, at full monitor speed.
#[derive(Clone, Debug)]
pub(crate) struct PathState {
    span: Arc<Span>,
    reduction: Option<Reduction>,
    pub(crate) p: f64,
    /// ṗ².
    pub(crate) x: f64,
    /// p̈ of the current interval, or of the interval that the arm has just completed.
    pub(crate) u: f64,
    /// Fraction of full speed at which the arm moves.
    pace: f64,
}

impl PathState {
    /// Limit that determines the speed.
    pub(crate) fn speed_limit(&self, model: &Model<'_>) -> SpeedLimit {
        match self.pace < FULL_PACE {
            true => SpeedLimit::MonitorSpeed,
            false => self.span.speed_limit(model, self, self.reduction.as_ref()).0,
        }
    }

    /// Load of the acting limit: the limited quantity relative to the limit.
    #[cfg(test)]
    pub(crate) fn load(&self, model: &Model<'_>) -> f64 {
        self.span.speed_limit(model, self, self.reduction.as_ref()).1
    }
}

impl Timeline {
    /// State of the arm on the path; `None` without a path.
    pub(crate) fn state(&self, pace: f64) -> Option<PathState> {
        let front = self.spans.front()?;
        let before = self.cursor.point.checked_sub(1).filter(|_| self.cursor.elapsed == 0.0);
        let interval = front.interval(before.unwrap_or(self.cursor.point))?;
        let (p, rate) = (self.p()?, self.rate());
        let (span, reduction) = (Arc::clone(&front.span), front.reduction.clone());
        Some(PathState { span, reduction, p, x: rate * rate, u: interval.acceleration(), pace })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_unique_and_fit_in_a_column() {
        for limit in SpeedLimit::all() {
            assert_eq!(SpeedLimit::named(&limit.to_string()), Some(limit));
            assert!(!limit.to_string().contains(','));
        }
        assert_eq!(SpeedLimit::named("speed of axis 7"), None);
    }
}
