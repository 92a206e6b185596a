//! The results of tests.

use val3_lang::ports::Time;
use val3_machine::event::Event;

use crate::recorded::RecordedMotion;

/// The result of a test.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct TestResult {
    /// Its failures; none if it has passed. Only expectations can cause several.
    pub failures: Vec<Failure>,
    /// The controller's clock at its end, in nanoseconds.
    pub duration: Time,
    /// The lines that `?` has printed, at most the last 100.
    pub prints: Vec<String>,
    /// The last events that may explain a failure, at most 10.
    pub events: Vec<Event>,
    /// The note for readers of cycle times; `None` unless a cycle in which the arm has moved was compared with a limit, with
    /// times of a model arm.
    pub times_note: Option<String>,
    /// The motion, if it is to be compared with a recorded one, as `expect.trace` asks.
    pub motion: Option<Box<RecordedMotion>>,
}

impl TestResult {
    /// Whether the test has passed.
    #[must_use]
    pub fn has_passed(&self) -> bool {
        self.failures.is_empty()
    }
}

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
