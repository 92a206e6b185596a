//! Failures of tests.

/// A failure of a test.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Failure {
    /// A sentence about the problem; further lines show the actual state.
    pub message: String,
    /// Call stack of the task, innermost program first, without programs of `val3assert`; for an expectation, its place
    /// in the scenario file.
    pub places: Vec<FailureLocation>,
}

/// A line of a program or of a scenario.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FailureLocation {
    /// Program name with its application or library, or the key of an expectation.
    pub program: String,
    /// File.
    pub file: String,
    /// Line in the file, from 1.
    pub line: u32,
}
