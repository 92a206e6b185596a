//! Numerical first and second derivatives of equidistant values, to the fourth order.

use nalgebra::SVector;

/// Weights of five neighbours for the first derivative, times 12, for each position among the five.
const FIRST: [[f64; 5]; 5] = [
    [-25.0, 48.0, -36.0, 16.0, -3.0],
    [-3.0, -10.0, 18.0, -6.0, 1.0],
    [1.0, -8.0, 0.0, 8.0, -1.0],
    [-1.0, 6.0, -18.0, 10.0, 3.0],
    [3.0, -16.0, 36.0, -48.0, 25.0],
];

/// Weights of seven neighbours for the first derivative, times 60, for each position among the seven.
const TANGENT: [[f64; 7]; 7] = [
    [-147.0, 360.0, -450.0, 400.0, -225.0, 72.0, -10.0],
    [-10.0, -77.0, 150.0, -100.0, 50.0, -15.0, 2.0],
    [2.0, -24.0, -35.0, 80.0, -30.0, 8.0, -1.0],
    [-1.0, 9.0, -45.0, 0.0, 45.0, -9.0, 1.0],
    [1.0, -8.0, 30.0, -80.0, 35.0, 24.0, -2.0],
    [-2.0, 15.0, -50.0, 100.0, -150.0, 77.0, 10.0],
    [10.0, -72.0, 225.0, -400.0, 450.0, -360.0, 147.0],
];

/// Weights of seven values for their sixth difference.
const SIXTH_DIFFERENCE: [f64; 7] = [1.0, -6.0, 15.0, -20.0, 15.0, -6.0, 1.0];

/// Weights of five neighbours for the second derivative, times 12. At the edges the order is 3.
const SECOND: [[f64; 5]; 5] = [
    [35.0, -104.0, 114.0, -56.0, 11.0],
    [11.0, -20.0, 6.0, 4.0, -1.0],
    [-1.0, 16.0, -30.0, 16.0, -1.0],
    [-1.0, 4.0, 6.0, -20.0, 11.0],
    [11.0, -56.0, 114.0, -104.0, 35.0],
];

/// Returns the first derivative at each of the `values`, which are `step` apart, to the sixth order; zero for fewer
/// than seven values.
pub(crate) fn tangents<const N: usize>(values: &[SVector<f64, N>], step: f64) -> impl Iterator<Item = SVector<f64, N>> {
    let scale = 1.0 / (60.0 * step);
    (0..values.len()).map(move |index| {
        let first = index.saturating_sub(3).min(values.len().saturating_sub(7));
        let values = values.get(first..first + 7).unwrap_or_default();
        let weights = TANGENT.get(index - first).copied().unwrap_or_default();
        values.iter().zip(weights).fold(SVector::zeros(), |sum, (value, weight)| sum + value * (weight * scale))
    })
}

/// Estimates the relative error of [`tangents`] at the first of at least seven values: the last term of the series
/// divided by the derivative. The result is NaN for constant values.
pub(crate) fn edge_error<'a, const N: usize>(values: impl Iterator<Item = &'a SVector<f64, N>>) -> f64 {
    let [first, ..] = &TANGENT;
    let terms = values.zip(first).zip(SIXTH_DIFFERENCE);
    let sums = terms.fold([SVector::zeros(); 2], |[derivative, difference], ((value, weight), sixth)| {
        [derivative + value * (weight / 60.0), difference + value * (sixth / 6.0)]
    });
    let [derivative, difference] = sums.map(|sum: SVector<f64, N>| sum.norm());
    difference / derivative
}

/// Returns the first and second derivative at one of five values that are `step` apart.
pub(crate) fn at<const N: usize>(values: &[SVector<f64, N>], index: usize, step: f64) -> [SVector<f64, N>; 2] {
    let [first, second] = [&FIRST, &SECOND].map(|weights| weights.get(index).copied().unwrap_or_default());
    [weighted_sum(values, first, 12.0 * step), weighted_sum(values, second, 12.0 * step * step)]
}

fn weighted_sum<const N: usize>(values: &[SVector<f64, N>], weights: [f64; 5], divisor: f64) -> SVector<f64, N> {
    let terms = values.iter().zip(weights).map(|(value, weight)| value * (weight / divisor));
    terms.fold(SVector::zeros(), |sum, term| sum + term)
}

#[cfg(test)]
mod tests {
    use nalgebra::Vector1;

    use super::*;

    #[test]
    fn polynomials_of_the_fourth_degree_are_exact() {
        let value = |x: f64| Vector1::new(1.0 - 2.0 * x + 3.0 * x * x - 4.0 * x.powi(3) + 0.5 * x.powi(4));
        let values: Vec<_> = (0..9).map(|index| value(f64::from(index) * 0.1)).collect();
        for (index, tangent) in tangents(&values, 0.1).enumerate() {
            let x = index as f64 * 0.1;
            let first = index.saturating_sub(2).min(values.len() - 5);
            let [first, second] = at(&values[first..first + 5], index - first, 0.1);
            assert!((first - tangent).norm() < 1e-12, "{index}");
            assert!((first.x - (-2.0 + 6.0 * x - 12.0 * x * x + 2.0 * x.powi(3))).abs() < 1e-11, "{index}");
            assert!((second.x - (6.0 - 24.0 * x + 6.0 * x * x)).abs() < 1e-10, "{index}");
        }
    }

    #[test]
    fn the_error_at_an_edge_shows_a_value_that_changes_within_a_step() {
        let root = |offset: f64| (0..7).map(|k| Vector1::new((f64::from(k) + offset).sqrt())).collect::<Vec<_>>();
        assert!(edge_error(root(20.0).iter()) < 1e-6);
        assert!(edge_error(root(0.05).iter()) > 1e-2);
        let exact = tangents(&root(5.0), 1.0).next().unwrap().x * 2.0 * 5.0_f64.sqrt();
        assert!(edge_error(root(5.0).iter()) > (exact - 1.0).abs());
    }

    #[test]
    fn too_few_values_have_no_derivative() {
        let values = [Vector1::new(1.0), Vector1::new(2.0)];
        assert_eq!(tangents(&values, 1.0).collect::<Vec<_>>(), [Vector1::zeros(); 2]);
    }
}
