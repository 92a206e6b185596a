//! Axis speeds above the maximum speed.

use std::fmt;

use crate::Arm;

/// Relative tolerance within which speeds are equal.
const ROUNDING: f64 = 1e-9;

/// Key in the arm file. Its values are not limits if the file lists them as model choices.
const MAXIMUM_SPEED: &str = "maximum_speed";

/// An axis whose speed under a motion descriptor may exceed its maximum speed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ExcessSpeed {
    /// Axis number, from 1.
    pub axis: usize,
    /// Speed that the descriptor allows, in degrees/s or mm/s.
    pub speed: f64,
    /// Maximum speed of the axis, in degrees/s or mm/s.
    pub maximum: f64,
    /// Whether the axis moves along a line, with speeds in mm/s.
    pub is_stroke: bool,
    /// Largest `vel` at which no moving axis exceeds its maximum speed, in whole percent.
    pub greatest_vel: f64,
}

impl fmt::Display for ExcessSpeed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { axis, speed, maximum, is_stroke, .. } = *self;
        let unit = if is_stroke { "mm/s" } else { "degrees/s" };
        let speed = (speed * 10.0).round() / 10.0;
        write!(f, "axis {axis} may move at {speed} {unit}, its maximum is {maximum} {unit}")
    }
}

impl Arm {
    /// Returns the moving axis that exceeds its maximum speed most at `vel` percent of the nominal speed. `is_moving`
    /// is called with axes from 0.
    ///
    /// `None` if no axis exceeds its maximum speed, or if the arm's maximum speeds are choices of this model.
    #[must_use]
    pub fn excess_speed(&self, vel: f64, is_moving: impl Fn(usize) -> bool) -> Option<ExcessSpeed> {
        if self.model_choices().iter().any(|entry| entry == MAXIMUM_SPEED) {
            return None;
        }
        let moving = self.limits().iter().enumerate().filter(|(index, _)| is_moving(*index));
        let greatest = moving.map(|(index, axis)| (index, axis, 100.0 * axis.maximum_speed / axis.nominal_speed));
        let (index, axis, greatest) = greatest.reduce(|least, next| if next.2 < least.2 { next } else { least })?;
        (vel > greatest * (1.0 + ROUNDING)).then(|| ExcessSpeed {
            axis: index + 1,
            speed: vel / 100.0 * axis.nominal_speed,
            maximum: axis.maximum_speed,
            is_stroke: self.is_stroke(index),
            greatest_vel: (greatest * (1.0 + ROUNDING)).floor(),
        })
    }
}
