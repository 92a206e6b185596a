//! Whole turns of an axis.

use crate::arm::AxisLimits;

/// Amount by which rounding may exceed a limit, in degrees or mm. The result is then at the limit.
const NOISE: f64 = 1e-11;

/// Shifts `angle` by whole turns to the position nearest to `near` within the axis limits.
pub(crate) fn nearest_within(angle: f64, near: f64, axis: &AxisLimits) -> Option<f64> {
    let nearest = nearest(angle, near);
    if axis.min <= nearest && nearest <= axis.max {
        return Some(nearest);
    }
    let above = ((nearest - axis.max - NOISE) / 360.0).ceil().max(0.0);
    let below = ((axis.min - nearest - NOISE) / 360.0).ceil().max(0.0);
    clamped(nearest + (below - above) * 360.0, axis)
}

/// Shifts `angle` by whole turns to the position nearest to `near`.
pub(crate) fn nearest(angle: f64, near: f64) -> f64 {
    let turns = (near - angle) / 360.0;
    // Most angles need no turn, and rounding is slow.
    if turns.abs() < 0.5 { angle } else { angle + turns.round() * 360.0 }
}

/// Returns `position` if it is within the axis limits, up to rounding.
pub(crate) fn clamped(position: f64, axis: &AxisLimits) -> Option<f64> {
    let inside = axis.min - NOISE <= position && position <= axis.max + NOISE;
    inside.then(|| position.clamp(axis.min, axis.max))
}
