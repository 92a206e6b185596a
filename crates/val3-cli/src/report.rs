//! The result of a check as plain data, ready for every output format.

#[cfg(test)]
pub(crate) mod sample;

use std::collections::BTreeSet;
use std::ops::Range;
use std::sync::Arc;

use clap::ValueEnum;
use serde::Serialize;
use val3_check::rule;
use val3_syntax::encoding::Encoding;

use crate::baseline::Outcome;
use crate::line_index::{LineIndex, Position};
use crate::user_error::UserError;

/// How serious a finding is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, ValueEnum)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Severity {
    /// Advice.
    Info,
    /// Nearly always a mistake.
    Warning,
    /// The controller refuses to load it, or it certainly fails when it runs.
    Error,
}

impl Severity {
    /// The word all outputs use.
    pub(crate) fn word(self) -> &'static str {
        match self {
            Self::Info => "info",
            Self::Warning => "warning",
            Self::Error => "error",
        }
    }
}

impl From<rule::Severity> for Severity {
    fn from(severity: rule::Severity) -> Self {
        match severity {
            rule::Severity::Info => Self::Info,
            rule::Severity::Warning => Self::Warning,
            rule::Severity::Error => Self::Error,
        }
    }
}

/// A file that findings point at.
#[derive(Debug)]
pub(crate) struct SourceFile {
    /// The path relative to the folder asked for, with `/`.
    pub(crate) path: String,
    /// The path as people open it: relative to the current folder where that is shorter.
    pub(crate) shown: String,
    /// The path on the controller (`Disk://app/prog.pgx`), where it has one.
    pub(crate) disk: Option<String>,
    /// The text, decoded.
    pub(crate) text: Arc<str>,
    /// The lines of the text.
    pub(crate) lines: LineIndex,
}

impl SourceFile {
    /// A file under one path, without a place on a controller.
    pub(crate) fn new(path: &str, text: Arc<str>, encoding: Encoding) -> Self {
        Self { path: path.to_owned(), shown: path.to_owned(), disk: None, lines: LineIndex::new(&text, encoding), text }
    }
}

/// A range of a file.
#[derive(Debug, Clone)]
pub(crate) struct Place {
    /// The file.
    pub(crate) file: Arc<SourceFile>,
    /// Bytes of the decoded text.
    pub(crate) range: Range<usize>,
}

impl Place {
    /// Where it starts.
    pub(crate) fn start(&self) -> Position {
        self.file.lines.position(self.range.start)
    }

    /// Where it ends: the first place that is not part of it.
    pub(crate) fn end(&self) -> Position {
        self.file.lines.position(self.range.end)
    }
}

/// One finding.
#[derive(Debug, Clone)]
pub(crate) struct Finding {
    /// `V0203`
    pub(crate) code: &'static str,
    /// `argument-type`
    pub(crate) name: &'static str,
    /// Its level.
    pub(crate) severity: Severity,
    /// What is wrong, in one sentence.
    pub(crate) message: String,
    /// A few words under the place; may be empty.
    pub(crate) label: String,
    /// What to write instead; may be empty.
    pub(crate) help: String,
    /// Where.
    pub(crate) place: Place,
    /// The program it lies in.
    pub(crate) program: Option<String>,
    /// The line within the program's code, where the line of `begin` is 1.
    pub(crate) code_line: Option<usize>,
    /// The path of the application's `.pjx`, like [`SourceFile::path`].
    pub(crate) application: Option<String>,
    /// The other sides of the fault.
    pub(crate) related: Vec<Related>,
    /// A fix exists.
    pub(crate) fixable: bool,
}

/// Another side of a finding.
#[derive(Debug, Clone)]
pub(crate) struct Related {
    /// Where.
    pub(crate) place: Place,
    /// What stands there.
    pub(crate) message: String,
}

/// What was checked.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(crate) struct Statistics {
    /// Projects that are applications or libraries.
    pub(crate) applications: usize,
    /// Files read.
    pub(crate) files: usize,
    /// Programs.
    pub(crate) programs: usize,
    /// Lines of code without blank lines and comments.
    pub(crate) code_lines: usize,
    /// Wall-clock time in seconds.
    pub(crate) seconds: f64,
}

/// Everything a check says.
#[derive(Debug)]
pub(crate) struct Report {
    /// What was checked.
    pub(crate) statistics: Statistics,
    /// In the order of file, place and code: the same input gives the same order on every machine.
    pub(crate) findings: Vec<Finding>,
    /// How many findings comments in the code silence.
    pub(crate) silenced: usize,
    /// What the baselines left out.
    pub(crate) baseline: Outcome,
    /// Folders that could not be read, so that the findings may not be all.
    pub(crate) unreadable: Vec<UserError>,
}

impl Report {
    /// Puts the findings in order and drops repetitions.
    pub(crate) fn new(statistics: Statistics, mut findings: Vec<Finding>, unreadable: Vec<UserError>) -> Self {
        findings.sort_by(|a, b| order(a).cmp(&order(b)));
        // A file that two applications use may be judged twice.
        findings.dedup_by(|a, b| order(a) == order(b));
        Self { statistics, findings, silenced: 0, baseline: Outcome::default(), unreadable }
    }

    /// How many findings have a level.
    pub(crate) fn count(&self, severity: Severity) -> usize {
        let same = |finding: &&Finding| finding.severity == severity;
        self.findings.iter().filter(same).count()
    }

    /// How many files have findings.
    pub(crate) fn faulty_files(&self) -> usize {
        let paths = self.findings.iter().map(|finding| &finding.place.file.path);
        paths.collect::<BTreeSet<_>>().len()
    }

    /// There is a finding of the rule with this code.
    pub(crate) fn has(&self, code: &str) -> bool {
        self.findings.iter().any(|finding| finding.code == code)
    }

    /// Whether a finding reaches a level.
    pub(crate) fn reaches(&self, level: Severity) -> bool {
        self.findings.iter().any(|finding| finding.severity >= level)
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
    fn findings_are_in_order_of_file_and_place() {
        let report = sample::report();
        let codes: Vec<_> = report.findings.iter().map(|finding| finding.code).collect();
        assert_eq!(codes, ["V0701", "V0203", "V0101"]);
    }

    #[test]
    fn counts() {
        let report = sample::report();
        assert_eq!(report.count(Severity::Error), 1);
        assert_eq!(report.faulty_files(), 2);
        assert!(report.reaches(Severity::Error));
        assert!(!sample::clean().reaches(Severity::Info));
    }

    #[test]
    fn offsets_are_those_of_the_stored_file() {
        let start = sample::report().findings[1].place.start();
        assert_eq!((start.line, start.column, start.offset), (6, 21, 200));
    }
}
