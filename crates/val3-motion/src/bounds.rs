//! The speeds and accelerations that the limits allow at one point of the path.
//!
//! With s as the parameter of the path, x = ṡ² and u = s̈, axis j moves at q′ⱼ·√x and accelerates by q′ⱼ·u + q″ⱼ·x.
//! Every limit is therefore a half plane of (u, x), and the values of u that are allowed at a given x are an interval.

/// Axes of an arm, at most.
pub(crate) const AXES: usize = 6;

/// Below this share of the fastest axis an axis counts as not moving: its acceleration then limits x alone.
const AT_REST: f64 = 1e-9;

/// The interval of u that one axis allows at x: from `low - slope * x` to `high - slope * x`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct AxisBound {
    low: f64,
    high: f64,
    slope: f64,
}

impl AxisBound {
    const NONE: Self = Self { low: f64::NEG_INFINITY, high: f64::INFINITY, slope: 0.0 };
}

/// How an axis moves along the path at one point, and what it can do.
#[derive(Clone, Copy, Debug)]
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

/// Half planes of (u, x) at one point of the path.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bounds {
    axes: [AxisBound; AXES],
    /// Greatest x by the limits of speed, and by the accelerations of axes that are at rest.
    top: f64,
    /// Greatest x by the limits of speed up to the next knot.
    level: f64,
}

impl Bounds {
    /// The bounds by the accelerations of these axes. The limits of speed allow `top` at most for x here, and `next_top`
    /// at the next knot.
    pub(crate) fn new(motions: impl Iterator<Item = AxisMotion> + Clone, [top, next_top]: [f64; 2]) -> Self {
        let fastest = motions.clone().map(|axis| axis.tangent.abs()).fold(0.0, f64::max);
        let mut bounds = Self { axes: [AxisBound::NONE; AXES], top, level: top.min(next_top) };
        for (bound, axis) in bounds.axes.iter_mut().zip(motions) {
            let rate = axis.tangent.abs();
            if rate <= fastest * AT_REST {
                let weaker = axis.acceleration.min(axis.deceleration);
                let most = weaker / axis.curvature.abs();
                (bounds.top, bounds.level) = (bounds.top.min(most), bounds.level.min(most));
            } else {
                *bound = AxisBound {
                    low: -axis.deceleration / rate,
                    high: axis.acceleration / rate,
                    slope: axis.curvature / axis.tangent,
                };
            }
        }
        bounds
    }

    /// Greatest x by the limits of speed.
    pub(crate) fn top(&self) -> f64 {
        self.top
    }

    /// Greatest x that the limits of speed allow from here to the next knot.
    pub(crate) fn level(&self) -> f64 {
        self.level
    }

    /// The bounds at a point between this knot and the next one.
    pub(crate) fn between(&self) -> Self {
        Self { top: self.level, ..*self }
    }

    /// These bounds with x no greater than `top` here, nor than `level` up to the next knot.
    pub(crate) fn reduced(&self, top: f64, level: f64) -> Self {
        Self { top: self.top.min(top), level: self.level.min(level), ..*self }
    }

    /// The bounds at the last knot, which `self` precedes.
    pub(crate) fn last(&self, top: f64) -> Self {
        Self { top, level: top, ..*self }
    }

    /// Greatest u at x.
    pub(crate) fn highest(&self, x: f64) -> f64 {
        self.axes.iter().map(|axis| axis.high - axis.slope * x).fold(f64::INFINITY, f64::min)
    }

    /// Smallest u at x.
    pub(crate) fn lowest(&self, x: f64) -> f64 {
        self.axes.iter().map(|axis| axis.low - axis.slope * x).fold(f64::NEG_INFINITY, f64::max)
    }

    /// Whether x can stay as it is.
    pub(crate) fn allows_constant(&self, x: f64) -> bool {
        self.lowest(x) <= 0.0 && self.highest(x) >= 0.0
    }

    /// The greatest x here from which x can be between 0 and `next` at the following point, `step` further.
    ///
    /// At x = 0 there is always such a u. Each pair of a lower and an upper edge of u ends at the x where they meet.
    /// Computing all pairs without a branch takes half of the time of Newton's method, which visits a few of them.
    pub(crate) fn controllable(&self, step: f64, next: f64) -> f64 {
        let slope = 1.0 / (2.0 * step);
        let halt = AxisBound { low: 0.0, slope, ..AxisBound::NONE };
        let to_next = AxisBound { high: next * slope, slope, ..AxisBound::NONE };
        let mut x = self.top;
        for lower in self.axes.iter().chain([&halt]) {
            for upper in self.axes.iter().chain([&to_next]) {
                let closing = upper.slope - lower.slope;
                let meeting = (upper.high - lower.low) / closing;
                x = if closing > 0.0 && meeting < x { meeting } else { x };
            }
        }
        x.max(0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// One axis that moves 100 degrees for each unit of the parameter.
    fn straight(speed: f64, acceleration: f64, deceleration: f64) -> Bounds {
        let axis = AxisMotion { tangent: -100.0, curvature: 0.0, acceleration, deceleration };
        Bounds::new([axis].into_iter(), [(speed / 100.0).powi(2); 2])
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
        let bounds = Bounds::new([moving, turning].into_iter(), [f64::INFINITY; 2]);
        assert_eq!((bounds.top(), bounds.highest(1.0)), (1.25, 5.0));
    }

    #[test]
    fn a_point_before_a_stop_allows_what_braking_takes_away() {
        let bounds = straight(50.0, 200.0, 300.0);
        let controllable = bounds.controllable(0.01, 0.0);
        assert!((controllable - 2.0 * 0.01 * 3.0).abs() < 1e-12);
        assert_eq!(bounds.controllable(0.1, 0.25), 0.25);
    }

    #[test]
    fn a_curve_reduces_what_is_controllable() {
        let axis = AxisMotion { tangent: 1.0, curvature: 20.0, acceleration: 5.0, deceleration: 5.0 };
        let bounds = Bounds::new([axis].into_iter(), [100.0; 2]);
        let x = bounds.controllable(0.01, 50.0);
        assert!(bounds.lowest(x) <= bounds.highest(x) && x + 0.02 * bounds.lowest(x) >= -1e-12);
    }
}
