//! Logging commands of Azure Pipelines: each finding becomes an issue of the pipeline run.

use std::io;

use codespan_reporting::term::termcolor::WriteColor;

use crate::report::{CheckReport, Finding, FindingSeverity};

/// Writes one command for each finding.
pub(crate) fn write(report: &CheckReport, out: &mut dyn WriteColor) -> io::Result<()> {
    for finding in &report.findings {
        writeln!(out, "{}", command(finding))?;
    }
    Ok(())
}

fn command(finding: &Finding) -> String {
    let start = finding.place.start();
    format!(
        "##vso[task.logissue type={level};sourcepath={path};linenumber={line};columnnumber={column};code={code};]{message}",
        level = level(finding.severity),
        path = property(&finding.place.file.in_repository),
        line = start.line,
        column = start.column,
        code = finding.code,
        message = data(&finding.message_with_help()),
    )
}

/// Level of the issue. Azure has no level below a warning.
fn level(severity: FindingSeverity) -> &'static str {
    match severity {
        FindingSeverity::Info | FindingSeverity::Warning => "warning",
        FindingSeverity::Error => "error",
    }
}

fn data(text: &str) -> String {
    text.replace('%', "%AZP25").replace('\r', "%0D").replace('\n', "%0A")
}

fn property(text: &str) -> String {
    data(text).replace(';', "%3B").replace(']', "%5D")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::format::{ReportFormat, rendered};
    use crate::report::sample;

    #[test]
    fn each_finding_is_a_command() {
        insta::assert_snapshot!(rendered(ReportFormat::Azure, &sample::report()));
    }

    #[test]
    fn special_characters_are_escaped() {
        assert_eq!(data("100 %\r\n##vso"), "100 %AZP25%0D%0A##vso");
        assert_eq!(property("a;b]c"), "a%3Bb%5Dc");
    }
}
