//! The speeds and accelerations that the limits allow between two points of the path.
//!
//! With s as the parameter of the path, x = ṡ² and u = s̈, axis j moves at q′ⱼ·√x and accelerates by q′ⱼ·u + q″ⱼ·x.
//! Between two points u is constant, so x at the second one is x + 2·u·step. Every limit at either point, or in the mean, is
//! therefore a half plane of (u, x) at the first one, and the values of u that are allowed at a given x are an interval.
//!
//! The mean acceleration of an interval is exactly within the limit. Where a path bends within it, the acceleration at an
//! end may exceed the limit a little, so that a coarse plan takes as little time as a fine one.

use std::borrow::Cow;
use std::ops::Range;

use arrayvec::ArrayVec;

/// Greatest number of arm axes.
pub(crate) const AXES: usize = 6;

/// Below this share of the fastest axis an axis counts as not moving: its acceleration then limits only x.
const AT_REST: f64 = 1e-9;

/// Greatest x where nothing limits the speed.
const FASTEST: f64 = 1e30;

/// Acceleration at an end of an interval, as a share of its limit.
const AT_END: f64 = 1.012;

/// The interval of u that one axis allows at x: from `low - slope * x` to `high - slope * x`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct AxisBound {
    low: f64,
    high: f64,
    slope: f64,
}

impl AxisBound {
    const NONE: Self = Self { low: f64::NEG_INFINITY, high: f64::INFINITY, slope: 0.0 };

    fn low_at(&self, x: f64) -> f64 {
        self.low - self.slope * x
    }

    fn high_at(&self, x: f64) -> f64 {
        self.high - self.slope * x
    }

    /// Whether this bound allows nothing that `other` forbids, for every x from 0 to `top`: both are linear in x.
    fn implies(&self, other: &Self, top: f64) -> bool {
        let is_within = |x| self.low_at(x) >= other.low_at(x) && self.high_at(x) <= other.high_at(x);
        is_within(0.0) && is_within(top)
    }
}

/// How an axis moves along the path at one point, and what it can do.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct AxisMotion {
    /// q′: change of the axis for each unit of the path parameter.
    pub(crate) tangent: f64,
    /// q″.
    pub(crate) curvature: f64,
    /// Greatest increase of speed, per second squared.
    pub(crate) acceleration: f64,
    /// Greatest decrease of speed, per second squared.
    pub(crate) deceleration: f64,
}

/// One end of an interval of the path.
#[derive(Clone, Copy, Debug)]
pub(crate) struct IntervalEnd {
    pub(crate) axes: [AxisMotion; AXES],
    /// Greatest x by the limits of speed.
    pub(crate) top: f64,
}

impl IntervalEnd {
    /// A point between this one and the next, at a share of their distance: derivatives are linear there.
    pub(crate) fn towards(&self, next: &Self, share: f64) -> Self {
        let between = |one: f64, other: f64| one + (other - one) * share;
        let mut point = *self;
        point.top = self.top.min(next.top);
        for (axis, next) in point.axes.iter_mut().zip(&next.axes) {
            axis.tangent = between(axis.tangent, next.tangent);
            axis.curvature = between(axis.curvature, next.curvature);
        }
        point
    }

    /// How far accelerations may exceed their limits between this point and its neighbours, as a share of the limits.
    ///
    /// At the greatest x an acceleration between two points is above their mean by an eighth of the second difference.
    pub(crate) fn bulge(&self, before: &Self, after: &Self) -> f64 {
        let top = self.axes.iter().map(AxisMotion::at_rest).fold(self.top, f64::min);
        let axes = self.axes.iter().zip(&before.axes).zip(&after.axes);
        let bulges = axes.map(|((here, before), after)| {
            let difference = before.curvature - 2.0 * here.curvature + after.curvature;
            difference.abs() * top / 8.0 / here.acceleration.min(here.deceleration)
        });
        bulges.filter(|bulge| bulge.is_finite()).fold(0.0, f64::max)
    }
}

/// Half planes of (u, x) at the start of an interval.
#[derive(Clone, Debug)]
pub(crate) struct Bounds<'a> {
    /// Without most of those that another one implies.
    axes: Cow<'a, [AxisBound]>,
    /// Greatest x by the limits of speed, and by the accelerations of axes that are at rest.
    top: f64,
    /// Greatest x by the limits of speed up to the end of the interval.
    level: f64,
}

/// The bounds of many intervals.
#[derive(Debug)]
pub(crate) struct BoundsTable {
    axes: Vec<AxisBound>,
    intervals: Vec<IntervalBounds>,
}

/// The bounds of an interval in a table.
#[derive(Debug)]
struct IntervalBounds {
    axes: Range<usize>,
    top: f64,
    level: f64,
}

impl BoundsTable {
    /// Bounds from each point to the next, which is `step` apart. The last point has those of the preceding interval.
    pub(crate) fn between(points: &[IntervalEnd], step: f64) -> Self {
        let mut table = Self { axes: Vec::new(), intervals: Vec::with_capacity(points.len()) };
        for (start, end) in points.iter().zip(points.iter().skip(1)) {
            let (axes, top, level) = AxisBounds::between(start, end, step);
            let first = table.axes.len();
            table.axes.extend(axes);
            table.intervals.push(IntervalBounds { axes: first..table.axes.len(), top, level });
        }
        if let (Some(before), Some(last)) = (table.intervals.last(), points.last()) {
            let last = IntervalBounds { axes: before.axes.clone(), top: last.top, level: last.top };
            table.intervals.push(last);
        }
        table
    }

    /// The bounds from a point on.
    pub(crate) fn get(&self, index: usize) -> Option<Bounds<'_>> {
        let IntervalBounds { axes, top, level } = self.intervals.get(index)?;
        Some(Bounds { axes: Cow::Borrowed(self.axes.get(axes.clone())?), top: *top, level: *level })
    }
}

/// Bounds of the axes that count up to a greatest x.
struct AxisBounds {
    axes: ArrayVec<AxisBound, { 3 * AXES }>,
    top: f64,
}

impl AxisBounds {
    /// The bounds between two points, with `top` and `level` of [`Bounds`].
    fn between(start: &IntervalEnd, end: &IntervalEnd, step: f64) -> (ArrayVec<AxisBound, { 3 * AXES }>, f64, f64) {
        let (mut top, mut level) = (start.top, start.top.min(end.top));
        let mut bounds = Self { axes: ArrayVec::new(), top: top.min(FASTEST) };
        let [first, last] = [start, end].map(|end| end.axes.map(|axis| axis.scaled(AT_END)));
        let [fastest, fastest_at_end] = [&first, &last].map(|axes| fastest(axes) * AT_REST);
        for (axis, next) in start.axes.iter().zip(&end.axes) {
            bounds.add(axis.mean(next, step).bound(step));
        }
        for axis in &first {
            match axis.tangent.abs() <= fastest {
                true => (top, level) = (top.min(axis.at_rest()), level.min(axis.at_rest())),
                false => bounds.add(axis.bound(0.0)),
            }
        }
        for axis in &last {
            match axis.tangent.abs() <= fastest_at_end {
                true => level = level.min(axis.at_rest()),
                false => bounds.add(axis.bound(2.0 * step)),
            }
        }
        (bounds.axes, top, level)
    }

    /// Adds a bound unless another one implies it.
    fn add(&mut self, bound: AxisBound) {
        if !self.axes.iter().any(|other| other.implies(&bound, self.top)) {
            self.axes.push(bound);
        }
    }
}

impl Bounds<'_> {
    /// The bounds between two points that are `step` apart.
    pub(crate) fn between(start: &IntervalEnd, end: &IntervalEnd, step: f64) -> Self {
        let (axes, top, level) = AxisBounds::between(start, end, step);
        Self { axes: Cow::Owned(axes.to_vec()), top, level }
    }

    /// Greatest x by the limits of speed.
    pub(crate) fn top(&self) -> f64 {
        self.top
    }

    /// Greatest x that the limits of speed allow from here to the next knot.
    pub(crate) fn level(&self) -> f64 {
        self.level
    }

    /// These bounds with x no greater than `top` here, nor than `level` up to the end of the interval.
    pub(crate) fn reduced(self, top: f64, level: f64) -> Self {
        Self { top: self.top.min(top), level: self.level.min(level), ..self }
    }

    /// Greatest u at x.
    pub(crate) fn highest(&self, x: f64) -> f64 {
        self.axes.iter().map(|axis| axis.high_at(x)).fold(f64::INFINITY, f64::min)
    }

    /// Smallest u at x.
    pub(crate) fn lowest(&self, x: f64) -> f64 {
        self.axes.iter().map(|axis| axis.low_at(x)).fold(f64::NEG_INFINITY, f64::max)
    }

    /// Whether x can stay constant.
    pub(crate) fn allows_constant(&self, x: f64) -> bool {
        self.lowest(x) <= 0.0 && self.highest(x) >= 0.0
    }

    /// The greatest x here from which x can be between 0 and `next` at the following point, `step` further.
    ///
    /// At x = 0 there is always such a u. The width of the interval of u is a concave function of x, so Newton's method from
    /// above visits a few pairs of edges and ends at its root.
    pub(crate) fn controllable(&self, step: f64, next: f64) -> f64 {
        let slope = 1.0 / (2.0 * step);
        let halt = AxisBound { low: 0.0, slope, ..AxisBound::NONE };
        let to_next = AxisBound { high: next * slope, slope, ..AxisBound::NONE };
        let mut x = self.top.min(FASTEST);
        loop {
            let (mut lower, mut upper) = (&halt, &to_next);
            let (mut low, mut high) = (halt.low_at(x), to_next.high_at(x));
            for bound in self.axes.iter() {
                let (low_here, high_here) = (bound.low_at(x), bound.high_at(x));
                if low_here > low {
                    (lower, low) = (bound, low_here);
                }
                if high_here < high {
                    (upper, high) = (bound, high_here);
                }
            }
            let meeting = (upper.high - lower.low) / (upper.slope - lower.slope);
            // Rounding ends the search as well.
            let is_lower = upper.slope > lower.slope && meeting < x;
            if !is_lower {
                return x.max(0.0);
            }
            x = meeting;
        }
    }
}

fn fastest(axes: &[AxisMotion; AXES]) -> f64 {
    axes.iter().map(|axis| axis.tangent.abs()).fold(0.0, f64::max)
}

impl AxisMotion {
    fn scaled(self, share: f64) -> Self {
        Self { acceleration: self.acceleration * share, deceleration: self.deceleration * share, ..self }
    }

    /// Greatest x where the axis does not move.
    fn at_rest(&self) -> f64 {
        self.acceleration.min(self.deceleration) / self.curvature.abs()
    }

    /// The mean over an interval, up to whose end the derivatives change to those of `next`.
    fn mean(&self, next: &Self, step: f64) -> Self {
        let tangent = (self.tangent + next.tangent) / 2.0 + (self.curvature - next.curvature) * step / 12.0;
        let curvature = if step > 0.0 { (next.tangent - self.tangent) / step } else { self.curvature };
        if self.tangent * next.tangent > 0.0 {
            return Self { tangent, curvature, ..*self };
        }
        // An axis that turns back brakes before it and then speeds up.
        let most = self.acceleration.max(self.deceleration);
        Self { tangent, curvature, acceleration: most, deceleration: most }
    }

    /// The interval of u that the axis allows at x of a point that is `ahead / 2` before it.
    fn bound(&self, ahead: f64) -> AxisBound {
        let by_u = self.tangent + ahead * self.curvature;
        // The speed increases if the axis accelerates in the direction in which it moves.
        let speeds_up = by_u * self.tangent > 0.0;
        let (up, down) =
            if speeds_up { (self.acceleration, self.deceleration) } else { (self.deceleration, self.acceleration) };
        if by_u == 0.0 {
            return AxisBound::NONE;
        }
        AxisBound { low: -down / by_u.abs(), high: up / by_u.abs(), slope: self.curvature / by_u }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const STEP: f64 = 0.01;

    /// Bounds of axes whose derivatives are the same at both ends.
    fn even(axes: &[AxisMotion], top: f64) -> Bounds<'static> {
        let mut end = IntervalEnd { axes: [AxisMotion::default(); AXES], top };
        end.axes.iter_mut().zip(axes).for_each(|(axis, given)| *axis = *given);
        Bounds::between(&end, &end, STEP)
    }

    /// One axis that moves 100 degrees for each unit of the parameter.
    fn straight(speed: f64, acceleration: f64, deceleration: f64) -> Bounds<'static> {
        let axis = AxisMotion { tangent: -100.0, curvature: 0.0, acceleration, deceleration };
        even(&[axis], (speed / 100.0).powi(2))
    }

    #[test]
    fn speed_limits_x_and_accelerations_limit_u() {
        let bounds = straight(50.0, 200.0, 300.0);
        assert_eq!((bounds.top(), bounds.highest(0.1), bounds.lowest(0.1)), (0.25, 2.0, -3.0));
    }

    #[test]
    fn an_axis_at_its_turning_point_limits_x_by_its_acceleration() {
        let moving = AxisMotion { tangent: 1.0, curvature: 0.0, acceleration: 5.0, deceleration: 5.0 };
        let turning = AxisMotion { tangent: 0.0, curvature: -4.0, ..moving };
        let bounds = even(&[moving, turning], f64::INFINITY);
        assert_eq!((bounds.top(), bounds.highest(1.0)), (1.25 * AT_END, 5.0));
    }

    #[test]
    fn a_point_before_a_stop_allows_what_braking_takes_away() {
        let bounds = straight(50.0, 200.0, 300.0);
        let controllable = bounds.controllable(STEP, 0.0);
        assert!((controllable - 2.0 * STEP * 3.0).abs() < 1e-12);
        assert_eq!(bounds.controllable(0.1, 0.25), 0.25);
    }

    /// At both ends of the interval the axis keeps to its limits at the greatest x.
    #[test]
    fn a_curve_reduces_what_is_controllable() {
        let axis = AxisMotion { tangent: 1.0, curvature: 20.0, acceleration: 5.0, deceleration: 5.0 };
        let bounds = even(&[axis], 100.0);
        let x = bounds.controllable(STEP, 50.0);
        let u = bounds.lowest(x);
        assert!(u <= bounds.highest(x) + 1e-9 && x + 2.0 * STEP * u >= -1e-12);
        for x in [x, x + 2.0 * STEP * u] {
            let acceleration: f64 = axis.tangent * u + axis.curvature * x;
            assert!(acceleration.abs() < 5.0 * AT_END + 1e-9, "{acceleration}");
        }
    }
}
