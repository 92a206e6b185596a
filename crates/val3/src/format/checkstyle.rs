//! Checkstyle XML 4.3, a format that many CI services and editors read.

use std::io;

use codespan_reporting::term::termcolor::WriteColor;

use super::xml::{XmlWriter, allowed, allowed_name, document};
use crate::report::{CheckReport, Finding};

/// Writes one `<file>` element for each file with findings.
pub(crate) fn write(report: &CheckReport, out: &mut dyn WriteColor) -> io::Result<()> {
    document(out, |writer| {
        let root = writer.create_element("checkstyle").with_attribute(("version", "4.3"));
        if report.findings.is_empty() {
            return root.write_empty().map(drop);
        }
        root.write_inner_content(|writer| files(report, writer)).map(drop)
    })
}

/// Writes the elements. Findings are sorted by file, so each file's findings are adjacent.
fn files(report: &CheckReport, writer: &mut XmlWriter<'_>) -> io::Result<()> {
    for findings in report.findings.chunk_by(|a, b| a.place.file.path == b.place.file.path) {
        let Some(first) = findings.first() else { continue };
        let path = allowed_name(&first.place.file.in_repository);
        let file = writer.create_element("file").with_attribute(("name", path.as_str()));
        file.write_inner_content(|writer| findings.iter().try_for_each(|finding| error(finding, writer)))?;
    }
    Ok(())
}

fn error(finding: &Finding, writer: &mut XmlWriter<'_>) -> io::Result<()> {
    let start = finding.place.start();
    let element = writer.create_element("error").with_attributes([
        ("line", start.line.to_string().as_str()),
        ("column", start.column.to_string().as_str()),
        ("severity", finding.severity.word()),
        ("message", allowed(&finding.message_with_help()).as_str()),
        ("source", format!("val3.{}", finding.code).as_str()),
    ]);
    element.write_empty().map(drop)
}

#[cfg(test)]
mod tests {
    use crate::format::{ReportFormat, rendered};
    use crate::report::sample;

    #[test]
    fn the_document_lists_errors_by_file() {
        insta::assert_snapshot!(rendered(ReportFormat::Checkstyle, &sample::report()));
    }

    #[test]
    fn an_empty_report_is_a_document() {
        insta::assert_snapshot!(rendered(ReportFormat::Checkstyle, &sample::clean()));
    }

    #[test]
    fn no_text_breaks_the_document() {
        insta::assert_snapshot!(rendered(ReportFormat::Checkstyle, &sample::hostile()));
    }
}
