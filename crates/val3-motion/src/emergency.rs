//! Braking after a power cut or an emergency stop.

use crate::bounds::{AxisMotion, Bounds, IntervalEnd};
use crate::derivatives;
use crate::model::Model;
use crate::span::Span;

/// Deceleration as a multiple of the nominal deceleration, independently of the move's limits (model choice).
const STRENGTH: f64 = 2.0;

/// Distance between the points from which derivatives are computed, as a fraction of the span.
const STENCIL: f64 = 1e-3;

/// Returns the smallest p̈ that the arm can reach at p and x = ṗ².
pub(crate) fn braking(model: &Model<'_>, span: &Span, p: f64, x: f64) -> f64 {
    let [from, to] = span.range();
    let step = (to - from) * STENCIL;
    let first = (p - 2.0 * step).clamp(from, to - 4.0 * step);
    let values = [0.0, 1.0, 2.0, 3.0, 4.0].map(|k| span.axes(model, first + k * step));
    let index = ((p - first) / step).round() as usize;
    let [tangent, curvature] = derivatives::at(&values, index, step);
    let axes = std::array::from_fn(|axis| {
        let limit = STRENGTH * model.0.nominal_deceleration(axis);
        AxisMotion { acceleration: limit, deceleration: limit, ..AxisMotion::at(&tangent, &curvature, axis) }
    });
    let here = IntervalEnd { axes, top: f64::INFINITY };
    Bounds::between(&here, &here, 0.0).lowest(x)
}
