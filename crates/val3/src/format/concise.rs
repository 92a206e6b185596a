//! One line for each finding, in the form that editors and terminals convert to links.

use std::io;

use codespan_reporting::term::termcolor::WriteColor;

use crate::report::{CheckReport, Finding};

/// Writes `path:line:column: level[CODE] message` lines.
pub(crate) fn write(report: &CheckReport, out: &mut dyn WriteColor) -> io::Result<()> {
    report.findings.iter().try_for_each(|finding| write_finding(finding, out))
}

fn write_finding(finding: &Finding, out: &mut dyn WriteColor) -> io::Result<()> {
    let (code, message) = (finding.code, finding.marked_message());
    let start = finding.place.start();
    let path = &finding.place.file.shown;
    let level = finding.severity.word();
    writeln!(out, "{path}:{}:{}: {level}[{code}] {message}", start.line, start.column)
}

#[cfg(test)]
mod tests {
    use crate::format::{ReportFormat, rendered};
    use crate::report::sample;

    #[test]
    fn each_finding_is_a_line() {
        insta::assert_snapshot!(rendered(ReportFormat::Concise, &sample::report()));
    }
}
