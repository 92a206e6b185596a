//! The failures of tests.

/// A failure of a test.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Failure {
    /// A sentence that says what is wrong; further lines show what there is instead.
    pub message: String,
    /// The programs that the task was in, the innermost first, without those of `val3assert`; of an expectation, its
    /// place in the file of the scenario.
    pub places: Vec<Place>,
}

/// A line of a program or of a scenario.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Place {
    /// The program, with the name of its application or library before it, or the key of an expectation.
    pub program: String,
    /// Its file.
    pub file: String,
    /// The line of the file, from 1.
    pub line: u32,
}
