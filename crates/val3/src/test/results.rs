//! The results of all tests of a run.

use std::time::Duration;

use val3_suite::{Exemption, TestCase};

use super::tested::Tested;

/// The results of a run.
pub(super) struct Results {
    /// The executed tests, in the order of their names.
    pub(super) tested: Vec<Tested>,
    /// The tests that were chosen and not executed, because the run has ended early.
    pub(super) not_run: Vec<TestCase>,
    /// The reason for its early end.
    pub(super) early_end: Option<EarlyEnd>,
    /// The time that the run has taken on the clock on the wall.
    pub(super) wall: Duration,
}

/// The reason why tests were not executed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum EarlyEnd {
    /// `--fail-fast`
    FirstFailure,
    /// Ctrl-C, or another signal with this exit code.
    Signal(u8),
    /// Nothing reads the output any more.
    UnreadOutput,
}

impl EarlyEnd {
    /// The reason in words.
    pub(super) fn reason(self) -> &'static str {
        match self {
            Self::FirstFailure => "not run, because --fail-fast ends at the first failure",
            Self::Signal(_) => "not run, because the run was interrupted",
            Self::UnreadOutput => "not run, because nothing reads the output",
        }
    }
}

impl Results {
    /// The number of tests that have failed.
    pub(super) fn failed(&self) -> usize {
        failed(&self.tested)
    }

    /// The number of tests that have passed.
    pub(super) fn passed(&self) -> usize {
        self.tested.len() - self.failed() - self.skipped() - self.known_failures()
    }

    /// The number of tests that have passed only when they were executed again.
    pub(super) fn flaky(&self) -> usize {
        self.tested.iter().filter(|test| test.is_flaky()).count()
    }

    /// The slowest tests, the slowest first.
    pub(super) fn slowest(&self, count: usize) -> Vec<&Tested> {
        let mut all: Vec<&Tested> = self.tested.iter().collect();
        all.sort_by_key(|test| std::cmp::Reverse(test.wall));
        all.truncate(count);
        all
    }

    /// The number of tests that were skipped.
    pub(super) fn skipped(&self) -> usize {
        self.exempt(|exemption| matches!(exemption, Exemption::Skipped { .. }))
    }

    /// The number of tests that have failed as they say.
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

    /// The tests that were not executed, each with the reason.
    pub(super) fn not_run(&self) -> impl Iterator<Item = (&TestCase, &'static str)> {
        let reason = self.early_end.map_or("not run", EarlyEnd::reason);
        self.not_run.iter().map(move |case| (case, reason))
    }
}

/// The number of tests that have failed.
pub(super) fn failed(tested: &[Tested]) -> usize {
    tested.iter().filter(|test| !test.result.has_passed()).count()
}
