//! Results of tests.

use val3_lang::ports::Time;

use crate::exemption::Exemption;
use crate::failure::Failure;
use crate::golden_text::GoldenText;
use crate::journal::RepeatedEvent;
use crate::recorded::RecordedMotion;

/// The result of a test.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct TestResult {
    /// Failures; empty if the test has passed. Only expectations can cause several failures.
    pub failures: Vec<Failure>,
    /// Reason why the test counts neither as passed nor as failed.
    pub exemption: Option<Exemption>,
    /// Reason with which the test states a known failure, until [`judge_known_failure`](Self::judge_known_failure) is
    /// called.
    pub known_failure: Option<String>,
    /// Duration on the controller's clock, in nanoseconds.
    pub duration: Time,
    /// Lines printed by `?`, at most the last 100.
    pub prints: Vec<String>,
    /// Last events that may explain a failure, at most 100 different events.
    pub events: Vec<RepeatedEvent>,
    /// Values of the test's row: column names with the values at the start of the test.
    pub row: Vec<(String, String)>,
    /// Title and lines of the user page that was displayed at the failure; `None` if it was empty.
    pub page: Option<String>,
    /// Note on cycle times; `None` unless a cycle with motion was compared with a limit, and the arm has model times.
    pub times_note: Option<String>,
    /// Texts to compare with recorded texts.
    pub golden_texts: Vec<GoldenText>,
    /// Drawing of the motion and the recorded motion as SVG, if they differ.
    pub picture: Option<String>,
    /// Motion to compare with a recorded motion, if `expect.trace` requests it.
    pub motion: Option<Box<RecordedMotion>>,
}

impl TestResult {
    /// Whether the test has passed, or is exempt.
    #[must_use]
    pub fn has_passed(&self) -> bool {
        self.failures.is_empty()
    }

    /// Keeps at most `most` events of a failed test, and none otherwise.
    pub fn keep_last_events(&mut self, most: usize) {
        let most = if self.has_passed() { 0 } else { most };
        self.events.drain(..self.events.len().saturating_sub(most));
    }
}
