//! Workflow commands of GitHub Actions: each finding becomes a line annotation in the pull request.

use std::io;

use codespan_reporting::term::termcolor::WriteColor;

use crate::report::{CheckReport, Finding, FindingSeverity};

/// Number of annotations per level that GitHub shows for a job step.
const SHOWN: usize = 10;

/// Writes one command for each finding.
pub(crate) fn write(report: &CheckReport, out: &mut dyn WriteColor) -> io::Result<()> {
    for finding in &report.findings {
        writeln!(out, "{}", command(finding))?;
    }
    let levels = [FindingSeverity::Error, FindingSeverity::Warning, FindingSeverity::Info].map(level);
    let count = |name: &str| report.findings.iter().filter(|finding| level(finding.severity) == name).count();
    write_limit(&levels.map(|level| (level, count(level))), out)
}

/// Writes a line about the levels with more annotations than GitHub shows, if any.
pub(crate) fn write_limit(counts: &[(&str, usize)], out: &mut dyn WriteColor) -> io::Result<()> {
    let exceeded = counts.iter().filter(|(_, count)| *count > SHOWN);
    let exceeded: Vec<_> = exceeded.map(|(level, count)| format!("{SHOWN} of {count} {level}s")).collect();
    if exceeded.is_empty() {
        return Ok(());
    }
    writeln!(out, "GitHub shows {} as annotations. This log has all of them.", exceeded.join(", "))
}

fn command(finding: &Finding) -> String {
    let place = &finding.place;
    let (start, end) = (place.start(), place.end());
    // GitHub rejects columns of a range that spans several lines.
    let columns =
        if start.line == end.line { format!("col={},endColumn={},", start.column, end.column) } else { String::new() };
    format!(
        "::{level} file={file},line={line},endLine={end_line},{columns}title={title}::{message}",
        level = level(finding.severity),
        file = property(&place.file.in_repository),
        line = start.line,
        end_line = end.line,
        title = property(&format!("{} {}", finding.code, finding.name)),
        message = data(&finding.message_with_help()),
    )
}

fn level(severity: FindingSeverity) -> &'static str {
    match severity {
        FindingSeverity::Info => "notice",
        FindingSeverity::Warning => "warning",
        FindingSeverity::Error => "error",
    }
}

pub(crate) fn data(text: &str) -> String {
    text.replace('%', "%25").replace('\r', "%0D").replace('\n', "%0A")
}

pub(crate) fn property(text: &str) -> String {
    data(text).replace(':', "%3A").replace(',', "%2C")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::format::{ReportFormat, rendered};
    use crate::report::sample;

    #[test]
    fn each_finding_is_a_command() {
        insta::assert_snapshot!(rendered(ReportFormat::Github, &sample::report()));
    }

    #[test]
    fn annotations_beyond_the_limit_are_counted() {
        assert_eq!(limit_note(&[("error", 10), ("notice", 0)]), "");
        assert_eq!(
            limit_note(&[("error", 35), ("warning", 3), ("notice", 11)]),
            "GitHub shows 10 of 35 errors, 10 of 11 notices as annotations. This log has all of them.\n"
        );
    }

    fn limit_note(counts: &[(&str, usize)]) -> String {
        let mut out = codespan_reporting::term::termcolor::NoColor::new(Vec::new());
        write_limit(counts, &mut out).unwrap();
        String::from_utf8(out.into_inner()).unwrap()
    }

    #[test]
    fn special_characters_are_escaped() {
        assert_eq!(data("100 %\r\n::error::x"), "100 %25%0D%0A::error::x");
        assert_eq!(property("a,b:c"), "a%2Cb%3Ac");
    }
}
