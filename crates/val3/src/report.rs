//! Result of a check as plain data for all output formats.

mod finding;
#[cfg(test)]
pub(crate) mod sample;

use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet};

use clap::ValueEnum;
use serde::Serialize;
use val3_check::rule;

use crate::baseline::BaselineResult;
use crate::unread::{UNREAD_ARCHIVE, UNREADABLE_FILE};
use crate::user_error::UserError;

pub(crate) use finding::{Finding, Related, ReportPosition, ReportRange, ReportedEdit, ReportedFix, SourceFile};

/// Level of a finding.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, ValueEnum)]
#[serde(rename_all = "lowercase")]
pub(crate) enum FindingSeverity {
    /// Advice.
    Info,
    /// Nearly always a mistake.
    Warning,
    /// The controller rejects it, or it certainly fails when it runs.
    Error,
}

impl FindingSeverity {
    /// Name of the level in all outputs.
    pub(crate) fn word(self) -> &'static str {
        match self {
            Self::Info => "info",
            Self::Warning => "warning",
            Self::Error => "error",
        }
    }
}

impl From<rule::Severity> for FindingSeverity {
    fn from(severity: rule::Severity) -> Self {
        match severity {
            rule::Severity::Info => Self::Info,
            rule::Severity::Warning => Self::Warning,
            rule::Severity::Error => Self::Error,
        }
    }
}

/// Extent of a check.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(crate) struct ReportStatistics {
    /// Number of applications and libraries.
    pub(crate) applications: usize,
    /// Number of loaded files.
    pub(crate) files: usize,
    /// Number of programs.
    pub(crate) programs: usize,
    /// Number of code lines, without blank lines and comments.
    pub(crate) code_lines: usize,
    /// Wall-clock time in seconds.
    pub(crate) seconds: f64,
}

/// Difference between a check and the previous check.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct ReportChanges {
    /// Number of findings that the previous check did not have.
    pub(crate) new: usize,
    /// Number of findings that only the previous check had.
    pub(crate) gone: usize,
}

/// Complete result of a check.
#[derive(Debug)]
pub(crate) struct CheckReport {
    /// Extent of the check.
    pub(crate) statistics: ReportStatistics,
    /// Paths of all applications' `.pjx`, and of files without an application, as in [`SourceFile::path`], sorted.
    pub(crate) applications: Vec<String>,
    /// Findings, sorted by file, range and code: the order is the same on every machine.
    pub(crate) findings: Vec<Finding>,
    /// Findings beyond the limit of `--max-findings`, which count but are not shown.
    pub(crate) beyond_limit: Vec<Finding>,
    /// Number of findings that `--fix` has fixed before the report; `None` without `--fix`.
    pub(crate) fixed: Option<usize>,
    /// Number of fixes that were omitted because they would have added errors.
    pub(crate) refused: usize,
    /// Number of findings silenced by comments that the command has written before the report; `None` if not requested.
    pub(crate) newly_silenced: Option<usize>,
    /// Difference from the previous check, if the check is repeated.
    pub(crate) changes: Option<ReportChanges>,
    /// Absolute path of the repository's root, with `/`; empty if unknown.
    pub(crate) source_root: String,
    /// Number of findings silenced by comments in the code.
    pub(crate) silenced: usize,
    /// Effect of the baselines.
    pub(crate) baseline: BaselineResult,
    /// Unreadable files and folders without a finding. Their findings may be missing.
    pub(crate) unreadable: Vec<UserError>,
    /// Notice about the arm for the user.
    pub(crate) notice: Option<String>,
}

impl CheckReport {
    /// Sorts the findings and removes duplicates.
    pub(crate) fn new(
        statistics: ReportStatistics,
        applications: Vec<String>,
        mut findings: Vec<Finding>,
        unreadable: Vec<UserError>,
    ) -> Self {
        findings.sort_by(|a, b| order(a).cmp(&order(b)));
        // A file that two applications share may be checked twice.
        findings.dedup_by(|a, b| order(a) == order(b));
        Self {
            statistics,
            applications,
            findings,
            beyond_limit: Vec::new(),
            fixed: None,
            refused: 0,
            newly_silenced: None,
            changes: None,
            source_root: String::new(),
            silenced: 0,
            notice: None,
            baseline: BaselineResult::default(),
            unreadable,
        }
    }

    /// Limits the shown findings. The most serious ones remain, in their order.
    pub(crate) fn limit(&mut self, most: usize) {
        let mut ranks: Vec<usize> = (0..self.findings.len()).collect();
        ranks.sort_by_key(|rank| self.findings.get(*rank).map(|finding| Reverse(finding.severity)));
        let kept: BTreeSet<usize> = ranks.into_iter().take(most).collect();
        let (shown, omitted): (Vec<_>, Vec<_>) =
            std::mem::take(&mut self.findings).into_iter().enumerate().partition(|(rank, _)| kept.contains(rank));
        self.findings = shown.into_iter().map(|(_, finding)| finding).collect();
        self.beyond_limit.extend(omitted.into_iter().map(|(_, finding)| finding));
    }

    /// Shown and omitted findings.
    pub(crate) fn all(&self) -> impl Iterator<Item = &Finding> {
        self.findings.iter().chain(&self.beyond_limit)
    }

    /// Number of omitted findings by rule, most frequent first.
    pub(crate) fn omitted(&self) -> Vec<(&'static str, usize)> {
        let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
        self.beyond_limit.iter().for_each(|finding| *counts.entry(finding.code).or_default() += 1);
        let mut counts: Vec<_> = counts.into_iter().collect();
        counts.sort_by_key(|(_, count)| Reverse(*count));
        counts
    }

    /// Number of findings with this level.
    pub(crate) fn count(&self, severity: FindingSeverity) -> usize {
        let same = |finding: &&Finding| finding.severity == severity;
        self.all().filter(same).count()
    }

    /// Number of findings with a safe fix, or with an unsafe fix.
    pub(crate) fn fixable(&self, safe: bool) -> usize {
        let fixes = self.all().filter_map(|finding| finding.fix.as_ref());
        fixes.filter(|fix| fix.safe == safe).count()
    }

    /// Number of loaded files with findings.
    pub(crate) fn faulty_files(&self) -> usize {
        let read = self.all().filter(|finding| finding.code != UNREAD_ARCHIVE);
        let paths = read.map(|finding| &finding.place.file.path);
        paths.collect::<BTreeSet<_>>().len()
    }

    /// Whether all files were read.
    pub(crate) fn is_complete(&self) -> bool {
        self.unreadable.is_empty() && !self.all().any(|finding| finding.code == UNREADABLE_FILE)
    }

    /// Whether a finding reaches a level.
    pub(crate) fn reaches(&self, level: FindingSeverity) -> bool {
        self.all().any(|finding| finding.severity >= level)
    }
}

fn order(finding: &Finding) -> impl Ord {
    let place = &finding.place;
    (&place.file.path, place.range.start, place.range.end, finding.code, &finding.message)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn findings_are_sorted_by_file_and_position() {
        let report = sample::report();
        let codes: Vec<_> = report.findings.iter().map(|finding| finding.code).collect();
        assert_eq!(codes, ["V0701", "V0203", "V0101"]);
    }

    #[test]
    fn findings_are_counted_by_level() {
        let report = sample::report();
        assert_eq!(report.count(FindingSeverity::Error), 1);
        assert_eq!(report.faulty_files(), 2);
        assert!(report.reaches(FindingSeverity::Error));
        assert!(!sample::clean().reaches(FindingSeverity::Info));
    }

    #[test]
    fn the_most_serious_findings_remain_below_a_limit() {
        let mut report = sample::report();
        let counts = |report: &CheckReport| {
            let levels = [FindingSeverity::Error, FindingSeverity::Warning, FindingSeverity::Info];
            (levels.map(|level| report.count(level)), report.faulty_files(), report.fixable(true))
        };
        let before = counts(&report);
        report.limit(1);
        let shown: Vec<_> = report.findings.iter().map(|finding| finding.severity).collect();
        assert_eq!((shown, report.omitted().len()), (vec![FindingSeverity::Error], 2));
        assert_eq!(counts(&report), before, "what is omitted counts");
        report.limit(9);
        assert_eq!((report.findings.len(), report.omitted().len()), (1, 2));
    }

    #[test]
    fn offsets_refer_to_the_stored_file() {
        let start = sample::report().findings[1].place.start();
        assert_eq!((start.line, start.column, start.offset), (6, 21, 200));
    }
}
