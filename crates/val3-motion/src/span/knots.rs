//! Knots of a span with derivatives and limits, and the check of the knot density.

use std::ops::RangeInclusive;

use super::SpanRequest;
use crate::bounds::{AxisMotion, BoundsTable, IntervalEnd};
use crate::derivatives::{self, edge_error, tangents};
use crate::model::{Axes, Model};
use crate::request::SpeedLimits;
use crate::speed_limits::speed_limits;

/// Minimum number of knots for the computation of derivatives.
pub(super) const LEAST_KNOTS: usize = 7;

/// Relative excess acceleration between two knots above which more knots are necessary.
const FINE_ACCELERATION: f64 = 0.008;

/// Relative error of the derivative at an end of the path above which more knots are necessary.
const FINE_TANGENT: f64 = 1e-3;

/// Knots equidistant in p, with their derivatives and limits.
pub(super) struct LimitedKnots {
    pub(super) knots: Vec<Axes>,
    pub(super) interval_ends: Vec<IntervalEnd>,
    /// |dq/dp| at the start and the end.
    pub(super) ends: [f64; 2],
}

impl LimitedKnots {
    /// Computes the derivatives and limits of the knots; `None` for fewer than [`LEAST_KNOTS`].
    pub(super) fn new(model: &Model<'_>, request: &SpanRequest, step: f64, knots: Vec<Axes>) -> Option<Self> {
        if knots.len() < LEAST_KNOTS {
            return None;
        }
        let ps: Vec<_> = (0..knots.len()).map(|index| request.range[0] + step * index as f64).collect();
        let tip = |(p, axes)| request.curve.tip(model, p, axes, &request.tool);
        let tips: Vec<_> = ps.iter().copied().zip(&knots).map(tip).collect();
        let limits: Vec<_> = ps.iter().map(|p| request.limits.at(*p)).collect();
        let tangents: Vec<_> = tangents(&knots, step).collect();
        let tops = speed_limits(&tangents, &tips, step, &limits);
        let interval_ends = interval_ends(&tangents, &tops, step, &limits);
        let ends = [tangents.first()?, tangents.last()?].map(|tangent| tangent.norm());
        Some(Self { knots, interval_ends, ends })
    }

    /// Indices of the knots next to which derivatives or accelerations are not exact enough.
    fn coarse_knots(&self) -> impl Iterator<Item = usize> {
        let last = self.knots.len() - 1;
        let inner = self.interval_ends.windows(3).zip(1..).filter_map(|(three, index)| match three {
            [before, here, after] if here.bulge(before, after) >= FINE_ACCELERATION => Some(index),
            _ => None,
        });
        let first_is_coarse = edge_error(self.knots.iter()) > FINE_TANGENT;
        let last_is_coarse = edge_error(self.knots.iter().rev()) > FINE_TANGENT;
        first_is_coarse.then_some(0).into_iter().chain(inner).chain(last_is_coarse.then_some(last))
    }

    /// Range of the knots that are not dense enough; `None` if all are.
    pub(super) fn coarse_range(&self) -> Option<RangeInclusive<usize>> {
        let mut coarse = self.coarse_knots();
        let first = coarse.next()?;
        Some(first..=coarse.last().unwrap_or(first))
    }

    /// Number of knots before the coarse knots at the end.
    pub(super) fn fine_len(&self) -> usize {
        let coarse: Vec<_> = self.coarse_knots().collect();
        let is_next = |fine: usize, index: usize| index + LEAST_KNOTS > fine;
        coarse.into_iter().rev().fold(self.knots.len(), |fine, index| if is_next(fine, index) { index } else { fine })
    }

    /// Bounds from each knot to the next.
    pub(super) fn bounds(&self, step: f64) -> BoundsTable {
        BoundsTable::between(&self.interval_ends, step)
    }
}

/// Derivatives of the axes, and limits, at each knot.
fn interval_ends(tangents: &[Axes], tops: &[f64], step: f64, limits: &[&SpeedLimits]) -> Vec<IntervalEnd> {
    let curvatures = derivatives::tangents(tangents, step);
    let knots = tangents.iter().zip(curvatures).zip(tops).zip(limits);
    knots.map(|(((tangent, curvature), top), limits)| interval_end(tangent, &curvature, limits, *top)).collect()
}

fn interval_end(tangent: &Axes, curvature: &Axes, limits: &SpeedLimits, top: f64) -> IntervalEnd {
    let axes = std::array::from_fn(|axis| AxisMotion {
        acceleration: limits.acceleration.get(axis).copied().unwrap_or(f64::INFINITY),
        deceleration: limits.deceleration.get(axis).copied().unwrap_or(f64::INFINITY),
        ..AxisMotion::at(tangent, curvature, axis)
    });
    IntervalEnd { axes, top }
}
