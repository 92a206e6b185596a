//! JUnit XML: each application is a suite, and each finding a failed test.
//!
//! Errors and warnings are failures. Info findings are passed tests with the message as output. An application without
//! findings is a suite with one passed test. The findings of a file without an application have their own suite.

use std::io;

use codespan_reporting::term::termcolor::WriteColor;
use quick_xml::events::BytesText;

use super::xml::{XmlWriter, allowed, allowed_name, document};
use crate::report::{CheckReport, Finding, FindingSeverity};

/// Writes one `<testsuite>` element for each application.
pub(crate) fn write(report: &CheckReport, out: &mut dyn WriteColor) -> io::Result<()> {
    let suites = suites(report);
    document(out, |writer| {
        let root = writer.create_element("testsuites").with_attributes([
            ("name", "val3 check"),
            ("tests", suites.iter().map(Suite::tests).sum::<usize>().to_string().as_str()),
            ("failures", suites.iter().map(Suite::failures).sum::<usize>().to_string().as_str()),
        ]);
        root.write_inner_content(|writer| suites.iter().try_for_each(|suite| suite.write(writer))).map(drop)
    })
}

/// Returns the applications in order, each with its findings, followed by the other files with findings.
fn suites(report: &CheckReport) -> Vec<Suite<'_>> {
    let applications = report.applications.iter().map(|name| Suite { name, findings: findings_of(report, name) });
    let others: Vec<&Finding> = report.findings.iter().filter(|finding| finding.application.is_none()).collect();
    let others = others.chunk_by(|a, b| a.place.file.path == b.place.file.path);
    let others = others
        .filter_map(|findings| Some(Suite { name: &findings.first()?.place.file.path, findings: findings.to_vec() }));
    applications.chain(others).collect()
}

fn findings_of<'r>(report: &'r CheckReport, application: &str) -> Vec<&'r Finding> {
    report.findings.iter().filter(|finding| finding.application.as_deref() == Some(application)).collect()
}

struct Suite<'a> {
    name: &'a str,
    findings: Vec<&'a Finding>,
}

impl Suite<'_> {
    fn tests(&self) -> usize {
        self.findings.len().max(1)
    }

    fn failures(&self) -> usize {
        self.findings.iter().filter(|finding| fails(finding)).count()
    }

    fn write(&self, writer: &mut XmlWriter<'_>) -> io::Result<()> {
        let name = allowed_name(self.name);
        let suite = writer.create_element("testsuite").with_attributes([
            ("name", name.as_str()),
            ("tests", self.tests().to_string().as_str()),
            ("failures", self.failures().to_string().as_str()),
            ("errors", "0"),
        ]);
        suite
            .write_inner_content(|writer| {
                if self.findings.is_empty() {
                    let passed = [("name", "no findings"), ("classname", name.as_str())];
                    writer.create_element("testcase").with_attributes(passed).write_empty()?;
                }
                self.findings.iter().try_for_each(|finding| test(finding, writer))
            })
            .map(drop)
    }
}

fn fails(finding: &Finding) -> bool {
    finding.severity >= FindingSeverity::Warning
}

fn test(finding: &Finding, writer: &mut XmlWriter<'_>) -> io::Result<()> {
    let file = allowed_name(&finding.place.file.in_repository);
    let start = finding.place.start();
    let name = format!("{} {} ({file}:{}:{})", finding.code, finding.name, start.line, start.column);
    let test =
        writer.create_element("testcase").with_attributes([("name", name.as_str()), ("classname", file.as_str())]);
    test.write_inner_content(|writer| outcome(finding, writer)).map(drop)
}

fn outcome(finding: &Finding, writer: &mut XmlWriter<'_>) -> io::Result<()> {
    let message = allowed(&finding.message_with_help());
    let text = BytesText::new(&message);
    if !fails(finding) {
        return writer.create_element("system-out").write_text_content(text).map(drop);
    }
    let summary = allowed(&finding.message);
    let failure = writer.create_element("failure");
    let failure = failure.with_attributes([("type", finding.severity.word()), ("message", summary.as_str())]);
    failure.write_text_content(text).map(drop)
}

#[cfg(test)]
mod tests {
    use crate::format::{ReportFormat, rendered};
    use crate::report::sample;

    #[test]
    fn the_document_has_a_suite_for_each_application() {
        insta::assert_snapshot!(rendered(ReportFormat::Junit, &sample::report()));
    }

    #[test]
    fn a_clean_application_is_a_passed_test() {
        insta::assert_snapshot!(rendered(ReportFormat::Junit, &sample::clean()));
    }

    #[test]
    fn no_text_breaks_the_document() {
        insta::assert_snapshot!(rendered(ReportFormat::Junit, &sample::hostile()));
    }
}
