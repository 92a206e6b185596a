//! Speeds beyond the maximum of an axis.

use std::fmt;

use crate::Arm;

/// Speeds are equal if they differ by no more than this share.
const ROUNDING: f64 = 1e-9;

/// Entry of an arm's file whose values are no limits if they are choices of the model.
const MAXIMUM_SPEED: &str = "maximum_speed";

/// An axis that a motion descriptor lets move faster than its maximum speed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ExcessSpeed {
    /// The axis, counted from 1.
    pub axis: usize,
    /// The speed that the descriptor allows, in degrees/s or mm/s.
    pub speed: f64,
    /// The maximum speed of the axis, in degrees/s or mm/s.
    pub maximum: f64,
    /// Whether the axis moves along a line, with speeds in mm/s.
    pub is_stroke: bool,
    /// The greatest `vel` with which none of the moving axes exceeds its maximum speed, in whole per cent.
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
    /// The axis that `vel` per cent of the nominal speed takes furthest beyond its maximum speed, of those that move.
    /// `is_moving` gets axes counted from 0.
    ///
    /// `None` if no axis exceeds its maximum speed, or if the maximum speeds of the arm are choices of this model.
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
