//! Limits of x = ṡ² by the speeds of the axes and of the tool, so that they hold between knots too.

use nalgebra::Vector3;
use val3_geometry::{IsometryMatrix3, rotation};

use crate::bounds::AXES;
use crate::derivatives::derivatives;
use crate::model::Axes;
use crate::request::Limits;

/// The limits of x by all speeds at each knot: axes, tool centre point and rotation of the tool.
pub(crate) fn speed_limits(
    courses: &[[Axes; 2]],
    tips: &[IsometryMatrix3<f64>],
    step: f64,
    limits: &[&Limits],
) -> Vec<f64> {
    let mut tops = vec![f64::INFINITY; courses.len()];
    let mut limit = |speeds: Vec<f64>, of: &dyn Fn(&Limits) -> f64| {
        let allowed = speeds.iter().zip(limits).map(|(speed, limits)| (of(limits) / speed).powi(2)).collect();
        tops.iter_mut().zip(without_bulges(allowed)).for_each(|(top, allowed)| *top = top.min(allowed));
    };
    for axis in 0..AXES {
        let speeds = courses.iter().map(|[tangent, _]| tangent.get(axis).copied().unwrap_or_default().abs());
        limit(speeds.collect(), &|limits| limits.speed.get(axis).copied().unwrap_or(f64::INFINITY));
    }
    let positions: Vec<Vector3<f64>> = tips.iter().map(|tip| tip.translation.vector).collect();
    let speeds = derivatives(&positions, step).map(|[tangent, _]| tangent.norm());
    limit(speeds.collect(), &|limits| limits.translation.0);
    limit(rotations(tips, step), &|limits| limits.rotation.0);
    tops
}

/// The speed of rotation at each knot in degrees for each unit of p: the greater one to both sides.
fn rotations(tips: &[IsometryMatrix3<f64>], step: f64) -> Vec<f64> {
    let turn = |pair: &[IsometryMatrix3<f64>]| match pair {
        [one, other] => rotation::to_vector(&(one.rotation.inverse() * other.rotation)).norm().to_degrees() / step,
        _ => 0.0,
    };
    let turns: Vec<f64> = tips.windows(2).map(turn).collect();
    let around = |index: usize| turns.get(index.saturating_sub(1)..(index + 1).min(turns.len())).unwrap_or_default();
    (0..tips.len()).map(|index| around(index).iter().copied().fold(0.0, f64::max)).collect()
}

/// Lowers limits of x where they bulge downwards between knots.
///
/// Between two knots x is linear. A limit is below that line where its second derivative is positive, by an eighth of
/// its second difference. Twice as much is taken off, because the second difference of the neighbours is an estimate.
fn without_bulges(limits: Vec<f64>) -> Vec<f64> {
    let bulge =
        |three: &[f64]| if let [before, here, after] = three { (before - 2.0 * here + after) / 4.0 } else { 0.0 };
    let inner: Vec<f64> = limits.windows(3).map(bulge).collect();
    let around = |index: usize| inner.get(index.saturating_sub(2)..(index + 1).min(inner.len())).unwrap_or_default();
    let lowered = |(index, limit): (usize, &f64)| {
        let widest = around(index).iter().copied().filter(|bulge| bulge.is_finite()).fold(0.0, f64::max);
        (limit - widest).max(limit / 2.0)
    };
    limits.iter().enumerate().map(lowered).collect()
}
