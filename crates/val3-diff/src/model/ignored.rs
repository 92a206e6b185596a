//! Differences that were omitted.

use serde::Serialize;

use crate::exclusions::Tolerance;

/// Exclusions and the number of differences omitted for each. They do not affect the exit code.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct Ignored {
    /// Tolerance of positions.
    pub tolerance: Option<Tolerance>,
    /// Number of positions within the tolerance.
    pub within_tolerance: usize,
    /// Patterns of data names.
    pub patterns: Vec<String>,
    /// Number of data whose names match a pattern.
    pub data: usize,
    /// Number of positions that moved with a frame or tool whose name matches a pattern.
    pub moved_along: usize,
    /// Number of programs whose layout differences were ignored.
    pub layouts: usize,
}
