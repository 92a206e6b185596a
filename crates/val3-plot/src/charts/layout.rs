//! Coordinates and colours that all charts share.

use crate::canvas::WIDTH;

/// Left and right end of the charts.
pub(super) const LEFT: f64 = 120.0;
pub(super) const RIGHT: f64 = WIDTH - 40.0;

/// Colours of axes 1 to 6.
pub(super) const AXES: [&str; 6] = ["#0072b2", "#e69f00", "#009e73", "#cc79a7", "#56b4e9", "#d55e00"];
