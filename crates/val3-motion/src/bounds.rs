//! Bounds on speeds and accelerations between two points of the path.
//!
//! With s as the parameter of the path, x = ṡ² and u = s̈, axis j has the speed q′ⱼ·√x and the acceleration q′ⱼ·u +
//! q″ⱼ·x. Between two points u is constant, so x at the second point is x + 2·u·step. Every limit at either point, or
//! on the mean, is therefore a half plane of (u, x) at the first point, and the permitted values of u at a given x form
//! an interval.
//!
//! An interval's mean acceleration is exactly within the limit. If the path bends within the interval, the acceleration
//! at an end may exceed the limit slightly, so that a coarse plan is as fast as a fine plan.

use std::borrow::Cow;
use std::ops::Range;

use arrayvec::ArrayVec;

use crate::model::Axes;

/// Maximum number of arm axes.
pub(crate) const AXES: usize = 6;

/// Speed relative to the fastest axis below which an axis counts as not moving. Its acceleration then limits only x.
const AT_REST: f64 = 1e-9;

/// Value of x without a speed limit.
const FASTEST: f64 = 1e30;

/// Permitted acceleration at the ends of intervals, relative to the limit.
const AT_END: f64 = 1.012;

/// Interval of u that one axis permits at x: from `low - slope * x` to `high - slope * x`.
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

    /// Whether this bound is at least as strict as `other` for every x from 0 to `top`. The two ends suffice, because
    /// both bounds are linear in x.
    fn implies(&self, other: &Self, top: f64) -> bool {
        let is_within = |x| self.low_at(x) >= other.low_at(x) && self.high_at(x) <= other.high_at(x);
        is_within(0.0) && is_within(top)
    }
}

/// Axis derivatives along the path at one point, with the acceleration limits.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct AxisMotion {
    /// q′: change of the axis per unit of the path parameter.
    pub(crate) tangent: f64,
    /// q″: second derivative by the path parameter.
    pub(crate) curvature: f64,
    /// Acceleration limit, per second squared.
    pub(crate) acceleration: f64,
    /// Deceleration limit, per second squared.
    pub(crate) deceleration: f64,
}

/// Path point at which intervals end and begin.
#[derive(Clone, Copy, Debug)]
pub(crate) struct IntervalEnd {
    pub(crate) axes: [AxisMotion; AXES],
    /// Maximum x permitted by the speed limits.
    pub(crate) top: f64,
}

impl IntervalEnd {
    /// Returns the point at a fraction of the distance from this point to the next. Derivatives are interpolated
    /// linearly.
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

    /// Possible excess of accelerations between this point and its neighbours, relative to the limits.
    ///
    /// At the greatest x, the acceleration between two points exceeds their mean by an eighth of the second difference.
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

/// Half planes of (u, x) at an interval's start.
#[derive(Clone, Debug)]
pub(crate) struct Bounds<'a> {
    /// Bounds of the axes, without most of the bounds that another bound implies.
    axes: Cow<'a, [AxisBound]>,
    /// Maximum x at the start, permitted by the speed limits and by the accelerations of axes at rest.
    top: f64,
    /// Maximum x in the entire interval, permitted by the speed limits.
    level: f64,
}

/// Bounds of consecutive intervals.
#[derive(Debug)]
pub(crate) struct BoundsTable {
    axes: Vec<AxisBound>,
    intervals: Vec<IntervalBounds>,
}

/// Interval bounds in a [`BoundsTable`].
#[derive(Debug)]
struct IntervalBounds {
    axes: Range<usize>,
    top: f64,
    level: f64,
}

impl BoundsTable {
    /// Computes the bounds from each point to the next, at a distance of `step`. The last point has the bounds of the
    /// preceding interval.
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

    /// Bounds of the interval that begins at a point.
    pub(crate) fn get(&self, index: usize) -> Option<Bounds<'_>> {
        let IntervalBounds { axes, top, level } = self.intervals.get(index)?;
        Some(Bounds { axes: Cow::Borrowed(self.axes.get(axes.clone())?), top: *top, level: *level })
    }
}

/// Bounds of the axes that are relevant up to a greatest x.
struct AxisBounds {
    axes: ArrayVec<AxisBound, { 3 * AXES }>,
    top: f64,
}

impl AxisBounds {
    /// Computes the bounds between two points, with `top` and `level` of [`Bounds`].
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

    /// Adds a bound unless another bound implies it.
    fn add(&mut self, bound: AxisBound) {
        if !self.axes.iter().any(|other| other.implies(&bound, self.top)) {
            self.axes.push(bound);
        }
    }
}

impl Bounds<'_> {
    /// Computes the bounds between two points at a distance of `step`.
    pub(crate) fn between(start: &IntervalEnd, end: &IntervalEnd, step: f64) -> Self {
        let (axes, top, level) = AxisBounds::between(start, end, step);
        Self { axes: Cow::Owned(axes.to_vec()), top, level }
    }

    /// Maximum x permitted by the speed limits.
    pub(crate) fn top(&self) -> f64 {
        self.top
    }

    /// Maximum x that the speed limits permit up to the next knot.
    pub(crate) fn level(&self) -> f64 {
        self.level
    }

    /// Limits x further: to `top` at the start and to `level` up to the end of the interval.
    pub(crate) fn reduced(self, top: f64, level: f64) -> Self {
        Self { top: self.top.min(top), level: self.level.min(level), ..self }
    }

    /// Maximum u at x.
    pub(crate) fn highest(&self, x: f64) -> f64 {
        self.axes.iter().map(|axis| axis.high_at(x)).fold(f64::INFINITY, f64::min)
    }

    /// Minimum u at x.
    pub(crate) fn lowest(&self, x: f64) -> f64 {
        self.axes.iter().map(|axis| axis.low_at(x)).fold(f64::NEG_INFINITY, f64::max)
    }

    /// Whether x can stay constant.
    pub(crate) fn allows_constant(&self, x: f64) -> bool {
        self.lowest(x) <= 0.0 && self.highest(x) >= 0.0
    }

    /// Greatest x at this point from which an x between 0 and `next` is possible at the following point, at a distance
    /// of `step`.
    ///
    /// At x = 0 such a u always exists. The width of the u interval is a concave function of x, so Newton's method,
    /// started from above, reaches the root after a few pairs of edges.
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
            // Rounding errors end the search as well.
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
    /// Derivatives of an axis, with acceleration limits of 0. The derivatives of a missing axis are 0.
    pub(crate) fn at(tangent: &Axes, curvature: &Axes, axis: usize) -> Self {
        let [tangent, curvature] = [tangent, curvature].map(|axes| axes.get(axis).copied().unwrap_or_default());
        Self { tangent, curvature, ..Self::default() }
    }

    fn scaled(self, share: f64) -> Self {
        Self { acceleration: self.acceleration * share, deceleration: self.deceleration * share, ..self }
    }

    /// Maximum x at a point where the axis does not move.
    fn at_rest(&self) -> f64 {
        self.acceleration.min(self.deceleration) / self.curvature.abs()
    }

    /// Mean over the interval from this point to `next`.
    fn mean(&self, next: &Self, step: f64) -> Self {
        let tangent = (self.tangent + next.tangent) / 2.0 + (self.curvature - next.curvature) * step / 12.0;
        let curvature = if step > 0.0 { (next.tangent - self.tangent) / step } else { self.curvature };
        if self.tangent * next.tangent > 0.0 {
            return Self { tangent, curvature, ..*self };
        }
        // An axis that reverses brakes first and then accelerates.
        let most = self.acceleration.max(self.deceleration);
        Self { tangent, curvature, acceleration: most, deceleration: most }
    }

    /// Interval of u that the axis permits, by the x of a point `ahead / 2` before this point.
    fn bound(&self, ahead: f64) -> AxisBound {
        let by_u = self.tangent + ahead * self.curvature;
        // The speed increases if the axis accelerates in its direction of motion.
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

    /// Bounds of axes with the same derivatives at both ends.
    fn even(axes: &[AxisMotion], top: f64) -> Bounds<'static> {
        let mut end = IntervalEnd { axes: [AxisMotion::default(); AXES], top };
        end.axes.iter_mut().zip(axes).for_each(|(axis, given)| *axis = *given);
        Bounds::between(&end, &end, STEP)
    }

    /// Bounds for one axis that moves 100 degrees per unit of the parameter.
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

    /// At the greatest x, the axis is within its limits at both ends of the interval.
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
