//! Results of all tests in a run.

use std::time::Duration;

use val3_suite::{Exemption, TestCase};

use super::tested::FinishedTest;

/// Results of a run.
pub(super) struct Results {
    /// Executed tests, sorted by name.
    pub(super) tested: Vec<FinishedTest>,
    /// Selected tests that were not executed, because the run ended early.
    pub(super) not_run: Vec<TestCase>,
    /// Reason why the run ended early.
    pub(super) early_end: Option<EarlyEnd>,
    /// Real duration of the run.
    pub(super) wall: Duration,
}

/// Reason why tests were not executed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum EarlyEnd {
    /// The option `--fail-fast`.
    FirstFailure,
    /// Ctrl-C, or another signal with this exit code.
    Signal(u8),
    /// The output is closed.
    UnreadOutput,
}

impl EarlyEnd {
    /// Reason in words.
    pub(super) fn reason(self) -> &'static str {
        match self {
            Self::FirstFailure => "not run, because --fail-fast ends at the first failure",
            Self::Signal(_) => "not run, because the run was interrupted",
            Self::UnreadOutput => "not run, because nothing reads the output",
        }
    }
}

impl Results {
    /// Number of failed tests.
    pub(super) fn failed(&self) -> usize {
        failed(&self.tested)
    }

    /// Number of passed tests.
    pub(super) fn passed(&self) -> usize {
        self.tested.len() - self.failed() - self.skipped() - self.known_failures()
    }

    /// Number of tests that have only passed in a retry.
    pub(super) fn flaky(&self) -> usize {
        self.tested.iter().filter(|test| test.is_flaky()).count()
    }

    /// Slowest tests, slowest first.
    pub(super) fn slowest(&self, count: usize) -> Vec<&FinishedTest> {
        let mut all: Vec<&FinishedTest> = self.tested.iter().collect();
        all.sort_by_key(|test| std::cmp::Reverse(test.wall));
        all.truncate(count);
        all
    }

    /// Number of skipped tests.
    pub(super) fn skipped(&self) -> usize {
        self.exempt(|exemption| matches!(exemption, Exemption::Skipped { .. }))
    }

    /// Number of tests with a known failure.
    pub(super) fn known_failures(&self) -> usize {
        self.exempt(|exemption| matches!(exemption, Exemption::KnownFailure { .. }))
    }

    fn exempt(&self, is_of_kind: impl Fn(&Exemption) -> bool) -> usize {
        self.tested
            .iter()
            .filter_map(|test| test.result.exemption.as_ref())
            .filter(|exemption| is_of_kind(exemption))
            .count()
    }

    /// Tests that were not executed, each with the reason.
    pub(super) fn not_run(&self) -> impl Iterator<Item = (&TestCase, &'static str)> {
        let reason = self.early_end.map_or("not run", EarlyEnd::reason);
        self.not_run.iter().map(move |case| (case, reason))
    }
}

/// Number of failed tests.
pub(super) fn failed(tested: &[FinishedTest]) -> usize {
    tested.iter().filter(|test| !test.result.has_passed()).count()
}
