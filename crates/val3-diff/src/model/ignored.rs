//! Differences that were left out.

use serde::Serialize;

use crate::exclusions::Tolerance;

/// Numbers of differences that were left out on request, and the request. They are no differences for the exit code.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct Ignored {
    /// The tolerance of positions.
    pub tolerance: Option<Tolerance>,
    /// Positions within the tolerance.
    pub within_tolerance: usize,
    /// The patterns of names.
    pub patterns: Vec<String>,
    /// Data whose names match a pattern.
    pub data: usize,
    /// Positions that moved with a frame or tool whose name matches a pattern.
    pub moved_along: usize,
    /// Programs of which the layout of the code was ignored.
    pub layouts: usize,
}
