//! Quintic polynomials between two points with given derivatives (`blend = joint`).

use nalgebra::SVector;

/// Value with its first and second derivative by the parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Jet<const N: usize> {
    pub(crate) value: SVector<f64, N>,
    pub(crate) first: SVector<f64, N>,
    pub(crate) second: SVector<f64, N>,
}

/// Polynomial over [0, 1] with a given jet at each end, as six Bézier control points.
///
/// The curve starts at the first control point, ends at the last, and stays within their convex hull.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Quintic<const N: usize> {
    points: [SVector<f64, N>; 6],
}

impl<const N: usize> Quintic<N> {
    pub(crate) fn between(start: &Jet<N>, end: &Jet<N>) -> Self {
        let points = [
            start.value,
            start.value + start.first / 5.0,
            start.value + start.first * 0.4 + start.second / 20.0,
            end.value - end.first * 0.4 + end.second / 20.0,
            end.value - end.first / 5.0,
            end.value,
        ];
        Self { points }
    }

    /// Distances in u from each end within which the curve turns from its direction at the end to the overall
    /// direction. At this distance, the cubic term equals the linear term.
    pub(crate) fn turns(&self) -> [f64; 2] {
        let [start, first, _, _, last, end] = &self.points;
        let whole = (end - start).norm().max(f64::MIN_POSITIVE);
        [first - start, end - last].map(|handle| (handle.norm() / (2.0 * whole)).sqrt())
    }

    pub(crate) fn at(&self, u: f64) -> SVector<f64, N> {
        self.points.iter().zip(weights(u)).fold(SVector::zeros(), |sum, (point, weight)| sum + point * weight)
    }
}

/// Value of the quintic polynomial with these control values.
pub(crate) fn bezier(values: [f64; 6], u: f64) -> f64 {
    values.into_iter().zip(weights(u)).map(|(value, weight)| value * weight).sum()
}

/// Weights of six control points: the Bernstein polynomials, whose sum is 1.
fn weights(u: f64) -> [f64; 6] {
    let v = 1.0 - u;
    let [uu, vv] = [u * u, v * v];
    [vv * vv * v, 5.0 * vv * vv * u, 10.0 * vv * v * uu, 10.0 * vv * uu * u, 5.0 * v * uu * uu, uu * uu * u]
}

#[cfg(test)]
mod tests {
    use nalgebra::{Vector1, Vector2};

    use super::*;
    use crate::derivatives;

    #[test]
    fn a_straight_path_at_constant_speed_stays_so() {
        let jet = |value| Jet { value: Vector1::new(value), first: Vector1::new(100.0), second: Vector1::zeros() };
        let quintic = Quintic::between(&jet(-50.0), &jet(50.0));
        for tenth in 0..=10 {
            let u = f64::from(tenth) / 10.0;
            assert!((quintic.at(u).x - (100.0 * u - 50.0)).abs() < 1e-12);
        }
    }

    /// Section (a) of the motion model: 50 mm before and after a right angle, B + (3/16)·d·(tR - tL).
    #[test]
    fn the_middle_of_a_right_angle_is_three_sixteenths_inside() {
        let start = Jet { value: Vector2::new(-50.0, 0.0), first: Vector2::new(100.0, 0.0), second: Vector2::zeros() };
        let end = Jet { value: Vector2::new(0.0, 50.0), first: Vector2::new(0.0, 100.0), second: Vector2::zeros() };
        assert!((Quintic::between(&start, &end).at(0.5) - Vector2::new(-9.375, 9.375)).norm() < 1e-12);
    }

    #[test]
    fn both_ends_have_the_given_derivatives() {
        let jet = |a, b, c| Jet { value: Vector1::new(a), first: Vector1::new(b), second: Vector1::new(c) };
        let (start, end) = (jet(1.0, -2.0, 3.0), jet(4.0, 0.5, -6.0));
        let quintic = Quintic::between(&start, &end);
        let near = |at: f64| [0.0, 1.0, 2.0, 3.0, 4.0].map(|k| quintic.at(at + k * 1e-3));
        let [first, second] = derivatives::at(&near(0.0), 0, 1e-3);
        assert!((first - start.first).norm() < 1e-8 && (second - start.second).norm() < 1e-5);
        let [first, second] = derivatives::at(&near(1.0 - 4e-3), 4, 1e-3);
        assert!((first - end.first).norm() < 1e-8 && (second - end.second).norm() < 1e-5);
    }
}
