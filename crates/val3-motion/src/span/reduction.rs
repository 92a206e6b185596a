//! Reduced speed: limits along a span for the speed of the tool centre point and of the flange, as in manual mode.
//!
//! These limits apply to the plan of a span and are not part of the span, so the path does not depend on them.

use std::sync::Arc;

use val3_geometry::IsometryMatrix3;
use val3_moves::{DegreesPerSecond, MillimetresPerSecond};

use super::Span;
use crate::bounds::{AXES, Bounds};
use crate::model::{Axes, Model};
use crate::request::SpeedLimits;
use crate::speed_limits::speed_limits;

/// Maximum x = ṗ² at each knot of a span.
#[derive(Clone, Debug)]
pub(crate) struct Reduction(Arc<[f64]>);

impl Reduction {
    /// Maximum x = ṗ² from the knot `index` to the next.
    pub(super) fn level(&self, index: usize) -> f64 {
        self.0.iter().skip(index).take(2).copied().fold(f64::INFINITY, f64::min)
    }
}

impl Span {
    /// Computes the limits with which neither the tool centre point nor the flange exceeds `speed`.
    pub(crate) fn reduction(&self, model: &Model<'_>, speed: MillimetresPerSecond) -> Reduction {
        let unlimited = [f64::INFINITY; AXES];
        let limits = SpeedLimits {
            speed: unlimited,
            acceleration: unlimited,
            deceleration: unlimited,
            translation: speed,
            rotation: DegreesPerSecond(f64::INFINITY),
        };
        let limits = vec![&limits; self.len()];
        let axes = vec![Axes::zeros(); self.len()];
        let tops = |poses: &[IsometryMatrix3<f64>]| speed_limits(&axes, poses, self.step, &limits);
        let flanges: Vec<_> = self.knots.iter().map(|axes| model.flange(axes)).collect();
        let tips: Vec<_> = flanges.iter().map(|flange| flange * self.tool).collect();
        Reduction(tops(&flanges).into_iter().zip(tops(&tips)).map(|(flange, tip)| flange.min(tip)).collect())
    }

    /// Limits from p to the next knot, or to `to` before the next knot, with the reduction if one applies.
    pub(crate) fn bounds_within(&self, p: f64, to: Option<f64>, reduction: Option<&Reduction>) -> Option<Bounds<'_>> {
        let bounds = self.bounds_at(p, to)?;
        let Some(Reduction(tops)) = reduction else { return Some(bounds) };
        let (index, is_between) = self.knot_before(p);
        let top = *tops.get(index)?;
        let level = tops.get(index + 1).map_or(top, |next| next.min(top));
        Some(bounds.reduced(if is_between { level } else { top }, level))
    }
}
