//! One JSON object per line and finding, with the schema of the [`json`](super::json) format.

use std::io;

use codespan_reporting::term::termcolor::WriteColor;

use super::json::JsonDiagnostic;
use crate::report::CheckReport;

/// Writes the findings; without findings, the output is empty.
pub(crate) fn write(report: &CheckReport, out: &mut dyn WriteColor) -> io::Result<()> {
    for finding in &report.findings {
        serde_json::to_writer(&mut *out, &JsonDiagnostic::of(finding))?;
        writeln!(out)?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use crate::format::{ReportFormat, rendered};
    use crate::report::sample;

    #[test]
    fn each_finding_is_an_object_on_its_line() {
        insta::assert_snapshot!(rendered(ReportFormat::JsonLines, &sample::report()));
    }

    #[test]
    fn nothing_found_writes_nothing() {
        assert_eq!(rendered(ReportFormat::JsonLines, &sample::clean()), "");
    }
}
