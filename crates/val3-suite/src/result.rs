//! The results of tests.

use val3_lang::ports::Time;

use crate::exemption::Exemption;
use crate::failure::Failure;
use crate::golden_text::GoldenText;
use crate::journal::RepeatedEvent;
use crate::recorded::RecordedMotion;

/// The result of a test.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct TestResult {
    /// Its failures; none if it has passed. Only expectations can cause several.
    pub failures: Vec<Failure>,
    /// The reason why the test counts neither as passed nor as failed.
    pub exemption: Option<Exemption>,
    /// The reason by which the test says that it fails, until
    /// [`judge_known_failure`](Self::judge_known_failure) is called.
    pub known_failure: Option<String>,
    /// The controller's clock at its end, in nanoseconds.
    pub duration: Time,
    /// The lines that `?` has printed, at most the last 100.
    pub prints: Vec<String>,
    /// The last events that may explain a failure, at most 100 that differ.
    pub events: Vec<RepeatedEvent>,
    /// The values of its row: the name of each column, and its value at the start of the test.
    pub row: Vec<(String, String)>,
    /// The title and the lines of the user page that was shown at the failure; `None` if nothing was written on it.
    pub page: Option<String>,
    /// The note for readers of cycle times; `None` unless a cycle in which the arm has moved was compared with a limit, with
    /// times of a model arm.
    pub times_note: Option<String>,
    /// The texts that are to be compared with recorded ones.
    pub golden_texts: Vec<GoldenText>,
    /// The drawing of the motion and the recorded one as SVG, if they differ.
    pub picture: Option<String>,
    /// The motion, if it is to be compared with a recorded one, as `expect.trace` asks.
    pub motion: Option<Box<RecordedMotion>>,
}

impl TestResult {
    /// Whether the test has passed, or is exempt.
    #[must_use]
    pub fn has_passed(&self) -> bool {
        self.failures.is_empty()
    }

    /// Keeps so many of the last events if it has failed, and none otherwise.
    pub fn keep_last_events(&mut self, most: usize) {
        let most = if self.has_passed() { 0 } else { most };
        self.events.drain(..self.events.len().saturating_sub(most));
    }
}
