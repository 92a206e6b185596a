//! Tests that are skipped, or known to fail.

use crate::failure::Failure;
use crate::result::TestResult;

/// Reason why a test counts neither as passed nor as failed.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Exemption {
    /// The test was not executed, or not to its end.
    Skipped {
        /// Reason.
        reason: String,
    },
    /// The test has failed, as it states.
    KnownFailure {
        /// Reason.
        reason: String,
        /// Failures.
        failures: Vec<Failure>,
    },
}

impl Exemption {
    /// Kind and reason: `skipped: no scale on this line`.
    #[must_use]
    pub fn label(&self) -> String {
        match self {
            Self::Skipped { reason } => format!("skipped: {reason}"),
            Self::KnownFailure { reason, .. } => format!("known failure: {reason}"),
        }
    }
}

impl TestResult {
    /// Result of a skipped test.
    #[must_use]
    pub fn skipped(reason: &str) -> Self {
        let exemption = Some(Exemption::Skipped { reason: reason.to_owned() });
        Self { exemption, ..Self::default() }
    }

    /// Checks, after all failures are known, that a test with a known failure has failed.
    pub fn judge_known_failure(&mut self) {
        if matches!(self.exemption, Some(Exemption::Skipped { .. })) {
            return;
        }
        let Some(reason) = self.known_failure.take() else { return };
        if self.failures.is_empty() {
            let message = format!("it passes, although it says that it fails ({reason}): remove this statement");
            self.failures.push(Failure { message, places: Vec::new() });
        } else {
            self.exemption = Some(Exemption::KnownFailure { reason, failures: std::mem::take(&mut self.failures) });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_known_failure_must_fail() {
        let failures = vec![Failure { message: "1 instead of 2".to_owned(), places: Vec::new() }];
        let known_failure = Some("the scale is wrong".to_owned());
        let mut result = TestResult { failures, known_failure: known_failure.clone(), ..TestResult::default() };
        result.judge_known_failure();
        assert!(result.has_passed());
        assert_eq!(result.exemption.unwrap().label(), "known failure: the scale is wrong");
        let mut result = TestResult { known_failure, ..TestResult::default() };
        result.judge_known_failure();
        assert!(!result.has_passed() && result.exemption.is_none());
        assert!(result.failures[0].message.starts_with("it passes"));
        let mut result = TestResult { known_failure: Some(String::new()), ..TestResult::skipped("later") };
        result.judge_known_failure();
        assert!(result.has_passed());
    }
}
