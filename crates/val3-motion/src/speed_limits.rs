//! Limits of x = ṡ² by the speeds of the axes and of the tool. The limits also hold between knots.

use nalgebra::{SVector, Vector3};
use val3_geometry::{IsometryMatrix3, rotation};

use crate::bounds::AXES;
use crate::derivatives::tangents;
use crate::model::Axes;
use crate::request::SpeedLimits;

/// Speeds or speed limits of the axes, the tool centre point and the rotation of the tool.
type Speeds = SVector<f64, { AXES + 2 }>;

/// Computes the limit of x at each knot by all speeds.
pub(crate) fn speed_limits(
    axes: &[Axes],
    tips: &[IsometryMatrix3<f64>],
    step: f64,
    limits: &[&SpeedLimits],
) -> Vec<f64> {
    let positions: Vec<Vector3<f64>> = tips.iter().map(|tip| tip.translation.vector).collect();
    let translations = tangents(&positions, step).map(|tangent| tangent.norm());
    let rotations = rotations(tips, step);
    let tools = translations.zip(rotations);
    let tops = axes.iter().zip(tools).zip(limits).map(|((axes, (translation, rotation)), limits)| {
        let limit = speeds(&limits.speed.into(), limits.translation.0, limits.rotation.0);
        limit.zip_map(&speeds(axes, translation, rotation), allowed)
    });
    without_bulges(&tops.collect::<Vec<_>>()).map(|tops| tops.min()).collect()
}

/// Maximum x by one limit; infinite for a speed of 0, for example if the arm does not have the axis.
fn allowed(limit: f64, speed: f64) -> f64 {
    if speed == 0.0 { f64::INFINITY } else { (limit / speed).powi(2) }
}

fn speeds(axes: &Axes, translation: f64, rotation: f64) -> Speeds {
    let [a, b, c, d, e, f] = axes.data.0[0];
    [a, b, c, d, e, f, translation, rotation].into()
}

/// Rotation speed at each knot, in degrees per unit of p: the greater of the speeds before and after the knot.
fn rotations(tips: &[IsometryMatrix3<f64>], step: f64) -> Vec<f64> {
    let pairs = tips.iter().zip(tips.iter().skip(1));
    let turns: Vec<f64> =
        pairs.map(|(one, other)| rotation::angle_between(&one.rotation, &other.rotation).to_degrees() / step).collect();
    let around = |index: usize| turns.get(index.saturating_sub(1)..(index + 1).min(turns.len())).unwrap_or_default();
    (0..tips.len()).map(|index| around(index).iter().copied().fold(0.0, f64::max)).collect()
}

/// Lowers the limits of x at knots between which a limit bulges downwards.
///
/// Between two knots x is linear. A limit with a positive second derivative is below this line by an eighth of the
/// second difference. Twice this value is subtracted, because the second difference of the neighbours is only an
/// estimate.
fn without_bulges(limits: &[Speeds]) -> impl Iterator<Item = Speeds> {
    let bulges: Vec<Speeds> = limits.windows(3).map(bulge).collect();
    limits.iter().enumerate().map(move |(index, limit)| {
        let around = bulges.get(index.saturating_sub(2)..(index + 1).min(bulges.len())).unwrap_or_default();
        let widest = around.iter().fold(Speeds::zeros(), |widest, bulge| widest.sup(bulge));
        (limit - widest).sup(&(limit / 2.0))
    })
}

/// A quarter of the second difference of three limits; 0 where it is not finite.
fn bulge(three: &[Speeds]) -> Speeds {
    let [before, here, after] = three else { return Speeds::zeros() };
    ((before - here * 2.0 + after) / 4.0).map(|bulge| if bulge.is_finite() { bulge } else { 0.0 })
}
