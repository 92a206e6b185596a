//! The results of tests.

use val3_lang::ports::Time;

/// The result of a test.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct TestResult {
    /// Its failure; none if it has passed.
    pub failure: Option<Failure>,
    /// The controller's clock at its end, in nanoseconds.
    pub duration: Time,
    /// The lines that `?` has printed, at most the last 100.
    pub prints: Vec<String>,
}

/// The failure of a test.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Failure {
    /// A sentence that says what is wrong.
    pub message: String,
    /// The programs that the task was in, the innermost first, without those of `val3assert`.
    pub places: Vec<Place>,
}

/// A line of a program.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Place {
    /// The program, with the name of its application or library before it.
    pub program: String,
    /// Its file.
    pub file: String,
    /// The line of the file, from 1.
    pub line: u32,
}
