//! A piece of the path that can be executed, with the limits at its knots.
//!
//! A span never changes once it is made. Its knots are at equal distances of the parameter p: σ of a segment, or u of a
//! blend.

mod load;
mod reduction;

pub(crate) use reduction::Reduction;

use std::sync::Arc;

use val3_geometry::{IsometryMatrix3, Vector3};
use val3_kinematics::{Unreachable, Violation};

use crate::blend::BlendCurve;
use crate::bounds::{AxisMotion, Bounds, BoundsTable, IntervalEnd};
use crate::derivatives::{self, tangents};
use crate::fault::Cause;
use crate::model::{Axes, Model};
use crate::request::{Limits, Manner};
use crate::segment::Segment;
use crate::speed_limits::speed_limits;

/// Distances between knots of a nominal path, at least.
const INTERVALS: usize = 64;

/// Distances between knots of a blend, which bends more, at least.
const BLEND_INTERVALS: usize = 128;

/// Distances between knots at most.
const MOST_INTERVALS: usize = 1600;

/// Fewer knots have no derivatives.
const LEAST_KNOTS: usize = 7;

/// There are more knots where an axis would move further than this between two, in degrees or mm.
const FINE: f64 = 1.0;

/// There are more knots where the acceleration of an axis between two could exceed its limit by more than this share.
const FINE_ACCELERATION: f64 = 0.008;

/// Knots are not nearer than this because of accelerations, in degrees or mm: rounding would determine derivatives.
const FINEST: f64 = 1e-3;

/// An axis that moves further than this between two of as many knots as there can be jumps, in degrees or mm.
const JUMP: f64 = 5.0;

/// Values of p that differ by less are one, as are places between knots.
pub(crate) const SAME: f64 = 1e-9;

/// The curve of a span.
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

    fn least_intervals(&self) -> usize {
        match self {
            Self::Nominal(_) => INTERVALS,
            Self::Blend(_) => BLEND_INTERVALS,
        }
    }

    /// The tool centre point at p, where the axes are known.
    fn tip(&self, model: &Model<'_>, p: f64, axes: &Axes, tool: &IsometryMatrix3<f64>) -> IsometryMatrix3<f64> {
        match self {
            Self::Nominal(segment) => segment.pose_at(model, p),
            Self::Blend(_) => model.flange(axes) * tool,
        }
    }
}

/// The part of the recorded moves that a span executes; ids are those of `getMoveId`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Part {
    /// The nominal path of a move.
    Nominal {
        /// Number of the move.
        serial: u64,
        /// Id of the move.
        id: f64,
    },
    /// The blend from one move to the next.
    Blend {
        /// The move before the corner.
        from: BlendPart,
        /// The move after it.
        to: BlendPart,
    },
}

/// One of the moves of a blend.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct BlendPart {
    /// Number of the move.
    pub(crate) serial: u64,
    /// Id of the move.
    pub(crate) id: f64,
    /// Where its nominal path ends or begins.
    pub(crate) sigma: f64,
}

impl Part {
    /// The number of the move whose corner it rounds.
    pub(crate) fn blend_of(&self) -> Option<u64> {
        match self {
            Self::Nominal { .. } => None,
            Self::Blend { from, .. } => Some(from.serial),
        }
    }

    /// `getMoveId` at p (section (b) of the motion model).
    pub(crate) fn id_at(&self, p: f64) -> f64 {
        match self {
            Self::Nominal { id, .. } => id + p,
            Self::Blend { from, .. } if p <= 0.5 => from.id + from.sigma + (1.0 - from.sigma) * 2.0 * p,
            Self::Blend { to, .. } => to.id + to.sigma * (2.0 * p - 1.0),
        }
    }
}

/// Limits along a span: those before and after its middle.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SpanLimits(pub(crate) [Limits; 2]);

impl SpanLimits {
    /// On a blend the smaller speeds count; accelerations are those of the nearer move.
    pub(crate) fn of_blend(first: &Limits, second: &Limits) -> Self {
        let mut speed = first.speed;
        speed.iter_mut().zip(second.speed).for_each(|(speed, other)| *speed = speed.min(other));
        let translation = if first.translation < second.translation { first.translation } else { second.translation };
        let rotation = if first.rotation < second.rotation { first.rotation } else { second.rotation };
        Self([first, second].map(|limits| Limits { speed, translation, rotation, ..*limits }))
    }

    fn at(&self, p: f64) -> &Limits {
        let [first, second] = &self.0;
        if p <= 0.5 { first } else { second }
    }
}

/// A piece of the path.
#[derive(Debug)]
pub(crate) struct Span {
    pub(crate) curve: Curve,
    pub(crate) part: Part,
    pub(crate) manner: Manner,
    pub(crate) tool: IsometryMatrix3<f64>,
    limits: SpanLimits,
    from: f64,
    step: f64,
    knots: Vec<Axes>,
    /// Derivatives and limits at each knot.
    interval_ends: Vec<IntervalEnd>,
    bounds: BoundsTable,
    /// |dq/dp| at both ends.
    ends: [f64; 2],
}

/// The ingredients of a span.
pub(crate) struct SpanRequest {
    pub(crate) curve: Curve,
    pub(crate) part: Part,
    pub(crate) manner: Manner,
    pub(crate) tool: IsometryMatrix3<f64>,
    pub(crate) limits: SpanLimits,
    /// Range of p.
    pub(crate) range: [f64; 2],
    /// The axes at the start.
    pub(crate) start: Axes,
}

impl Span {
    /// The span, up to where the arm can follow; if it cannot follow to the end, why.
    ///
    /// None if it cannot follow at all.
    pub(crate) fn new(model: &Model<'_>, request: SpanRequest) -> (Option<Self>, Option<Cause>) {
        let [from, to] = request.range;
        let mut intervals = request.curve.least_intervals();
        loop {
            let step = (to - from) / intervals as f64;
            let (knots, fault) = follow(model, &request, step, intervals);
            let widest = knots.windows(2).map(widest_of).fold(0.0, f64::max);
            let wanted = if fault.is_some() { MOST_INTERVALS } else { intervals * (widest / FINE).ceil() as usize };
            if wanted > intervals && intervals < MOST_INTERVALS {
                intervals = wanted.min(MOST_INTERVALS);
                continue;
            }
            let (knots, fault) = without_jump(model, knots, fault);
            let Some(limited) = LimitedKnots::new(model, &request, step, &knots) else { return (None, fault) };
            let can_be_finer = fault.is_none() && intervals < MOST_INTERVALS && widest > FINEST;
            if can_be_finer && !limited.are_fine() {
                intervals = (2 * intervals).min(MOST_INTERVALS);
                continue;
            }
            let LimitedKnots { interval_ends, ends } = limited;
            let bounds = BoundsTable::between(&interval_ends, step);
            let SpanRequest { curve, part, manner, tool, limits, .. } = request;
            let span = Self { curve, part, manner, tool, limits, from, step, knots, interval_ends, bounds, ends };
            return (Some(span), fault);
        }
    }

    /// The range of p.
    pub(crate) fn range(&self) -> [f64; 2] {
        [self.from, self.at_knot(self.knots.len().saturating_sub(1))]
    }

    /// Whether its end is the end of a blend, or the destination of its move.
    pub(crate) fn ends_its_move(&self) -> bool {
        let [_, end] = self.range();
        end > 1.0 - SAME
    }

    /// p at a knot.
    pub(crate) fn at_knot(&self, index: usize) -> f64 {
        self.from + self.step * index as f64
    }

    /// Number of knots, at least [`LEAST_KNOTS`].
    pub(crate) fn len(&self) -> usize {
        self.knots.len()
    }

    /// |dq/dp| at both ends.
    pub(crate) fn ends(&self) -> [f64; 2] {
        self.ends
    }

    /// The limits from p on to the next knot or to `to`, which is nearer.
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

    /// The last knot that is not after p, and whether p is between it and the next one.
    fn knot_before(&self, p: f64) -> (usize, bool) {
        let place = ((p - self.from) / self.step).max(0.0);
        let index = ((place + SAME) as usize).min(self.len().saturating_sub(1));
        (index, place > index as f64 + SAME)
    }

    /// The axes at p.
    pub(crate) fn axes(&self, model: &Model<'_>, p: f64) -> Axes {
        let place = ((p - self.from) / self.step).max(0.0);
        let knot = |index: usize| self.knots.get(index).or(self.knots.last()).copied().unwrap_or_default();
        // A path along a limit may exceed it by a hair between two knots that can be reached.
        let between = || {
            let before = knot(place as usize);
            before + (knot(place as usize + 1) - before) * place.fract()
        };
        self.curve.axes(model, p, &knot(place.round() as usize)).unwrap_or_else(|_| between())
    }

    /// The tool centre point at p, in mm.
    pub(crate) fn tip(&self, model: &Model<'_>, p: f64) -> Vector3<f64> {
        self.curve.tip(model, p, &self.axes(model, p), &self.tool).translation.vector
    }

    /// The axes at the last knot.
    pub(crate) fn end(&self) -> Axes {
        self.knots.last().copied().unwrap_or_default()
    }

    /// Whether p belongs to a blend.
    pub(crate) fn is_blend(&self) -> bool {
        matches!(self.part, Part::Blend { .. })
    }
}

/// The axes at each knot, and why the arm cannot follow further.
fn follow(model: &Model<'_>, request: &SpanRequest, step: f64, intervals: usize) -> (Vec<Axes>, Option<Cause>) {
    let mut knots = Vec::with_capacity(intervals + 1);
    let mut near = request.start;
    for index in 0..=intervals {
        let p = if index == intervals { request.range[1] } else { request.range[0] + step * index as f64 };
        match request.curve.axes(model, p, &near) {
            Ok(axes) => {
                near = axes;
                knots.push(axes);
            }
            Err(cause) => return (knots, Some(cause)),
        }
    }
    (knots, None)
}

fn widest_of(pair: &[Axes]) -> f64 {
    if let [one, other] = pair { (other - one).amax() } else { 0.0 }
}

/// The knots before the first jump.
fn without_jump(model: &Model<'_>, mut knots: Vec<Axes>, fault: Option<Cause>) -> (Vec<Axes>, Option<Cause>) {
    let jumps = |pair: &[Axes]| widest_of(pair) > JUMP;
    let Some(index) = knots.windows(2).position(jumps) else { return (knots, fault) };
    let after = knots.split_off(index + 1);
    let cause = knots.last().map_or(Cause::Singular, |before| cause_of_jump(model, before, &after));
    (knots, Some(cause))
}

/// An axis at its limit jumps by a full turn, because only its other turn is in range. It may do so before its limit:
/// without the turn, one of the knots after the jump is beyond it.
fn cause_of_jump(model: &Model<'_>, before: &Axes, after: &[Axes]) -> Cause {
    let Some(first) = after.first() else { return Cause::Singular };
    let turns = (first - before).map(|way| (way / 360.0).round() * 360.0);
    let is_turn = turns.amax() > 0.0 && (first - turns - before).amax() <= JUMP;
    let violation = |axes: &Axes| model.0.violations(&(axes - turns).into()).next();
    let violation = after.iter().take_while(|_| is_turn).find_map(violation);
    violation.map_or(Cause::Singular, |Violation { axis, position, min, max }| {
        Cause::Unreachable(Unreachable::Limit { axis, position, min, max })
    })
}

/// Derivatives and limits at the knots of a span.
struct LimitedKnots {
    interval_ends: Vec<IntervalEnd>,
    /// |dq/dp| at both ends.
    ends: [f64; 2],
}

impl LimitedKnots {
    /// `None` for fewer knots than derivatives require.
    fn new(model: &Model<'_>, request: &SpanRequest, step: f64, knots: &[Axes]) -> Option<Self> {
        if knots.len() < LEAST_KNOTS {
            return None;
        }
        let ps: Vec<_> = (0..knots.len()).map(|index| request.range[0] + step * index as f64).collect();
        let tip = |(p, axes)| request.curve.tip(model, p, axes, &request.tool);
        let tips: Vec<_> = ps.iter().copied().zip(knots).map(tip).collect();
        let limits: Vec<_> = ps.iter().map(|p| request.limits.at(*p)).collect();
        let tangents: Vec<_> = tangents(knots, step).collect();
        let tops = speed_limits(&tangents, &tips, step, &limits);
        let interval_ends = interval_ends(&tangents, &tops, step, &limits);
        let ends = [tangents.first()?, tangents.last()?].map(|tangent| tangent.norm());
        Some(Self { interval_ends, ends })
    }

    /// Whether accelerations between knots stay within their limits, at every speed that the knots allow.
    fn are_fine(&self) -> bool {
        self.interval_ends.windows(3).all(|three| match three {
            [before, here, after] => here.bulge(before, after) < FINE_ACCELERATION,
            _ => true,
        })
    }
}

/// The derivatives of the axes and the limits at each knot.
fn interval_ends(tangents: &[Axes], tops: &[f64], step: f64, limits: &[&Limits]) -> Vec<IntervalEnd> {
    let curvatures = derivatives::tangents(tangents, step);
    let knots = tangents.iter().zip(curvatures).zip(tops).zip(limits);
    knots.map(|(((tangent, curvature), top), limits)| interval_end(tangent, &curvature, limits, *top)).collect()
}

fn interval_end(tangent: &Axes, curvature: &Axes, limits: &Limits, top: f64) -> IntervalEnd {
    let axis = |index: usize| AxisMotion {
        tangent: tangent.get(index).copied().unwrap_or_default(),
        curvature: curvature.get(index).copied().unwrap_or_default(),
        acceleration: limits.acceleration.get(index).copied().unwrap_or(f64::INFINITY),
        deceleration: limits.deceleration.get(index).copied().unwrap_or(f64::INFINITY),
    };
    IntervalEnd { axes: std::array::from_fn(axis), top }
}
