//! Span: executable piece of the path, with the limits at its knots.
//!
//! A span is immutable. The knots are equidistant in the parameter p, which is σ of a segment or u of a blend.

mod follow;
mod knots;
mod load;
mod pieces;
mod reduction;

pub(crate) use pieces::Pieces;
pub(crate) use reduction::Reduction;

use std::sync::Arc;

use val3_geometry::{IsometryMatrix3, Vector3};
use val3_moves::Manner;

use self::knots::LimitedKnots;
use crate::blend::BlendCurve;
use crate::bounds::{Bounds, BoundsTable, IntervalEnd};
use crate::fault::Cause;
use crate::model::{Axes, Model};
use crate::request::SpeedLimits;
use crate::segment::Segment;

/// Difference below which two values of p, or two positions in units of a knot distance, are the same.
pub(crate) const SAME: f64 = 1e-9;

/// Curve of a span.
#[derive(Clone, Debug)]
pub(crate) enum Curve {
    Nominal(Arc<Segment>),
    Blend(BlendCurve),
}

impl Curve {
    fn axes(&self, model: &Model<'_>, p: f64, near: &Axes) -> Result<Axes, Cause> {
        match self {
            Self::Nominal(segment) => segment.axes(model, p),
            Self::Blend(blend) => blend.axes(model, p, near),
        }
    }

    /// Tool centre point at p. `axes` are the axes at p.
    fn tip(&self, model: &Model<'_>, p: f64, axes: &Axes, tool: &IsometryMatrix3<f64>) -> IsometryMatrix3<f64> {
        match self {
            Self::Nominal(segment) => segment.pose_at(model, p),
            Self::Blend(_) => model.flange(axes) * tool,
        }
    }
}

/// Part of the recorded moves that a span executes. Ids are as in `getMoveId`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum SpanPart {
    /// Nominal path of a move.
    Nominal {
        /// Serial number of the move.
        serial: u64,
        /// Id of the move.
        id: f64,
    },
    /// Blend from one move to the next.
    Blend {
        /// Move before the corner.
        from: BlendPart,
        /// Move after the corner.
        to: BlendPart,
    },
}

/// Move of a blend.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct BlendPart {
    /// Serial number of the move.
    pub(crate) serial: u64,
    /// Id of the move.
    pub(crate) id: f64,
    /// σ at which its nominal path ends or begins.
    pub(crate) sigma: f64,
}

impl SpanPart {
    /// Serial number of the move whose corner a blend rounds; `None` for a nominal part.
    pub(crate) fn blend_of(&self) -> Option<u64> {
        match self {
            Self::Nominal { .. } => None,
            Self::Blend { from, .. } => Some(from.serial),
        }
    }

    /// Result of `getMoveId` at p (section (b) of the motion model).
    pub(crate) fn id_at(&self, p: f64) -> f64 {
        match self {
            Self::Nominal { id, .. } => id + p,
            Self::Blend { from, .. } if p <= 0.5 => from.id + from.sigma + (1.0 - from.sigma) * 2.0 * p,
            Self::Blend { to, .. } => to.id + to.sigma * (2.0 * p - 1.0),
        }
    }
}

/// Limits along a span: before its middle, and after it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SpanLimits(pub(crate) [SpeedLimits; 2]);

impl SpanLimits {
    /// Returns the limits of a blend: the lower speeds of both moves, and the accelerations of the nearer move.
    pub(crate) fn of_blend(first: &SpeedLimits, second: &SpeedLimits) -> Self {
        let mut speed = first.speed;
        speed.iter_mut().zip(second.speed).for_each(|(speed, other)| *speed = speed.min(other));
        let translation = if first.translation < second.translation { first.translation } else { second.translation };
        let rotation = if first.rotation < second.rotation { first.rotation } else { second.rotation };
        Self([first, second].map(|limits| SpeedLimits { speed, translation, rotation, ..*limits }))
    }

    fn at(&self, p: f64) -> &SpeedLimits {
        let [first, second] = &self.0;
        if p <= 0.5 { first } else { second }
    }
}

/// Executable piece of the path.
#[derive(Debug)]
pub(crate) struct Span {
    pub(crate) curve: Curve,
    pub(crate) part: SpanPart,
    pub(crate) manner: Manner,
    pub(crate) tool: IsometryMatrix3<f64>,
    limits: SpanLimits,
    from: f64,
    step: f64,
    knots: Vec<Axes>,
    /// Derivatives and limits at each knot.
    interval_ends: Vec<IntervalEnd>,
    bounds: BoundsTable,
    /// |dq/dp| at the start and the end.
    ends: [f64; 2],
}

/// Data from which a span is created.
#[derive(Clone)]
pub(crate) struct SpanRequest {
    pub(crate) curve: Curve,
    pub(crate) part: SpanPart,
    pub(crate) manner: Manner,
    pub(crate) tool: IsometryMatrix3<f64>,
    pub(crate) limits: SpanLimits,
    /// Range of p.
    pub(crate) range: [f64; 2],
    /// Axes at the start.
    pub(crate) start: Axes,
}

impl Span {
    fn new(request: SpanRequest, step: f64, knots: LimitedKnots) -> Self {
        let SpanRequest { curve, part, manner, tool, limits, range: [from, _], .. } = request;
        let bounds = knots.bounds(step);
        let LimitedKnots { knots, interval_ends, ends } = knots;
        Self { curve, part, manner, tool, limits, from, step, knots, interval_ends, bounds, ends }
    }

    /// Range of p.
    pub(crate) fn range(&self) -> [f64; 2] {
        [self.from, self.at_knot(self.knots.len().saturating_sub(1))]
    }

    /// Whether the span ends at the blend's end or at the move's destination.
    pub(crate) fn ends_its_move(&self) -> bool {
        let [_, end] = self.range();
        end > 1.0 - SAME
    }

    /// Value of p at a knot.
    pub(crate) fn at_knot(&self, index: usize) -> f64 {
        self.from + self.step * index as f64
    }

    /// Number of knots, at least seven.
    pub(crate) fn len(&self) -> usize {
        self.knots.len()
    }

    /// |dq/dp| at the start and the end.
    pub(crate) fn ends(&self) -> [f64; 2] {
        self.ends
    }

    /// Limits from p to the next knot, or to `to` before the next knot.
    pub(crate) fn bounds_at(&self, p: f64, to: Option<f64>) -> Option<Bounds<'_>> {
        let (index, is_between) = self.knot_before(p);
        let is_whole = !is_between && to.is_none_or(|to| (to - self.at_knot(index + 1)).abs() < SAME * self.step);
        let (false, Some(start), Some(next)) =
            (is_whole, self.interval_ends.get(index), self.interval_ends.get(index + 1))
        else {
            return self.bounds.get(index);
        };
        let to_end = to.unwrap_or(self.at_knot(index + 1));
        let [start, end] = [p, to_end].map(|p| start.towards(next, (p - self.at_knot(index)) / self.step));
        Some(Bounds::between(&start, &end, to_end - p))
    }

    /// Index of the last knot not after p, and whether p is between this knot and the next.
    fn knot_before(&self, p: f64) -> (usize, bool) {
        let place = ((p - self.from) / self.step).max(0.0);
        let index = ((place + SAME) as usize).min(self.len().saturating_sub(1));
        (index, place > index as f64 + SAME)
    }

    /// Axes at p.
    pub(crate) fn axes(&self, model: &Model<'_>, p: f64) -> Axes {
        let place = ((p - self.from) / self.step).max(0.0);
        self.curve.axes(model, p, &self.knot(place.round() as usize)).unwrap_or_else(|_| {
            // A path along an axis limit may exceed the limit slightly between two reachable knots.
            let before = self.knot(place as usize);
            before + (self.knot(place as usize + 1) - before) * place.fract()
        })
    }

    /// Axes at a knot, or at the last knot if there are fewer knots.
    fn knot(&self, index: usize) -> Axes {
        self.knots.get(index).or(self.knots.last()).copied().unwrap_or_default()
    }

    /// Position of the tool centre point at p, in mm.
    pub(crate) fn tip(&self, model: &Model<'_>, p: f64) -> Vector3<f64> {
        self.curve.tip(model, p, &self.axes(model, p), &self.tool).translation.vector
    }

    /// Axes at the last knot.
    pub(crate) fn end(&self) -> Axes {
        self.knots.last().copied().unwrap_or_default()
    }

    /// Whether the span is part of a blend.
    pub(crate) fn is_blend(&self) -> bool {
        matches!(self.part, SpanPart::Blend { .. })
    }
}
