//! GitLab's code quality report: a JSON array of findings, shown in the merge request.

use std::io;

use codespan_reporting::term::termcolor::WriteColor;
use serde::Serialize;

use crate::fingerprint::fingerprints;
use crate::report::{CheckReport, Finding, FindingSeverity};

/// Writes the array and a line end.
pub(crate) fn write(report: &CheckReport, out: &mut dyn WriteColor) -> io::Result<()> {
    let marked = report.findings.iter().zip(fingerprints(&report.findings));
    let issues: Vec<_> = marked.map(|(finding, fingerprint)| Issue::of(finding, fingerprint)).collect();
    serde_json::to_writer_pretty(&mut *out, &issues)?;
    writeln!(out)
}

#[derive(Serialize)]
struct Issue<'a> {
    description: String,
    check_name: &'a str,
    fingerprint: String,
    severity: &'static str,
    location: Location<'a>,
}

#[derive(Serialize)]
struct Location<'a> {
    path: &'a str,
    lines: Lines,
}

#[derive(Serialize)]
struct Lines {
    begin: usize,
    end: usize,
}

impl<'a> Issue<'a> {
    fn of(finding: &'a Finding, fingerprint: String) -> Self {
        let place = &finding.place;
        Self {
            description: format!("{}: {}", finding.code, finding.message_with_help()),
            check_name: finding.name,
            fingerprint,
            severity: severity(finding.severity),
            location: Location {
                path: &place.file.in_repository,
                lines: Lines { begin: place.start().line, end: place.end().line },
            },
        }
    }
}

fn severity(severity: FindingSeverity) -> &'static str {
    match severity {
        FindingSeverity::Info => "info",
        FindingSeverity::Warning => "minor",
        FindingSeverity::Error => "major",
    }
}

#[cfg(test)]
mod tests {
    use crate::format::{ReportFormat, rendered};
    use crate::report::sample;

    #[test]
    fn the_report_lists_issues() {
        insta::assert_snapshot!(rendered(ReportFormat::Gitlab, &sample::report()));
    }

    #[test]
    fn nothing_found_is_an_empty_array() {
        assert_eq!(rendered(ReportFormat::Gitlab, &sample::clean()), "[]\n");
    }
}
