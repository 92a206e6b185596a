//! Measured times in words, for reports and comments.

use super::estimate::{AxisTimes, Estimate};

/// Describes axis times.
pub(super) fn described(unit: &str, times: &AxisTimes) -> String {
    let AxisTimes { speed, acceleration, deceleration, delay, residual, moves, .. } = times;
    format!(
        "nominal speed {}, acceleration {}, deceleration {} ({moves} measurements, delay {:.0} ms, residual {:.1} ms)",
        with_uncertainty(speed, &format!("{unit}/s")),
        with_uncertainty(acceleration, &format!("{unit}/s²")),
        with_uncertainty(deceleration, &format!("{unit}/s²")),
        delay * 1000.0,
        residual * 1000.0,
    )
}

fn with_uncertainty(estimate: &Estimate, unit: &str) -> String {
    format!("{} {unit} ± {:.2} %", rounded(estimate.value), 100.0 * estimate.uncertainty / estimate.value)
}

/// Rounds the value to five significant digits.
pub(super) fn rounded(value: f64) -> f64 {
    format!("{value:.4e}").parse().unwrap_or(value)
}
