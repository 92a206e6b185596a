//! Results as JUnit XML, valid in the schema of Jenkins (`tests/tools/reports`): each application is a suite. Times are real
//! times, which dashboards compare.

use std::io;
use std::time::Duration;

use codespan_reporting::term::termcolor::WriteColor;
use quick_xml::events::BytesText;
use val3_machine::event::seconds;
use val3_suite::{Exemption, TestCase, TestResult};

use super::events;
use super::results::Results;
use super::tested::{FinishedTest, described};
use crate::format::xml::{XmlWriter, allowed, allowed_name, document};
use crate::paths::Paths;
use crate::printable::one_line;

/// A test with its result, or with the reason why it was not executed.
#[derive(Clone, Copy)]
enum JunitCase<'r> {
    Run(&'r FinishedTest),
    NotRun(&'r TestCase, &'static str),
}

impl<'r> JunitCase<'r> {
    fn case(self) -> &'r TestCase {
        match self {
            Self::Run(tested) => &tested.case,
            Self::NotRun(case, _) => case,
        }
    }

    /// Reason why the test has neither passed nor failed.
    fn omission(self) -> Option<String> {
        match self {
            Self::Run(tested) => tested.result.exemption.as_ref().map(Exemption::label),
            Self::NotRun(_, reason) => Some(reason.to_owned()),
        }
    }
}

/// Writes one `<testsuite>` element for each application.
pub(super) fn write(results: &Results, paths: &Paths, out: &mut dyn WriteColor) -> io::Result<()> {
    let run = results.tested.iter().map(JunitCase::Run);
    let mut all: Vec<JunitCase<'_>> =
        run.chain(results.not_run().map(|(case, reason)| JunitCase::NotRun(case, reason))).collect();
    let mut applications: Vec<&str> = Vec::new();
    for entry in &all {
        if !applications.contains(&entry.case().shown_application()) {
            applications.push(entry.case().shown_application());
        }
    }
    // A stable sort keeps the order of the tests.
    all.sort_by_key(|entry| applications.iter().position(|name| *name == entry.case().shown_application()));
    document(out, |writer| {
        let root = writer.create_element("testsuites").with_attributes([
            ("name", "val3 test"),
            ("tests", all.len().to_string().as_str()),
            ("failures", results.failed().to_string().as_str()),
            ("time", wall(results.wall).as_str()),
        ]);
        let suites = all.chunk_by(|one, other| one.case().shown_application() == other.case().shown_application());
        root.write_inner_content(|writer| suites.into_iter().try_for_each(|tests| suite(tests, paths, writer)))
            .map(drop)
    })
}

fn suite(tests: &[JunitCase<'_>], paths: &Paths, writer: &mut XmlWriter<'_>) -> io::Result<()> {
    let name = tests.first().map_or("", |test| test.case().shown_application());
    let run = || tests.iter().filter_map(|test| if let JunitCase::Run(tested) = test { Some(*tested) } else { None });
    let failures = run().filter(|test| !test.result.has_passed()).count();
    let suite = writer.create_element("testsuite").with_attributes([
        ("name", allowed_name(name).as_str()),
        ("tests", tests.len().to_string().as_str()),
        ("failures", failures.to_string().as_str()),
        ("errors", "0"),
        ("skipped", tests.iter().filter(|entry| entry.omission().is_some()).count().to_string().as_str()),
        ("time", wall(run().map(|test| test.wall).sum()).as_str()),
    ]);
    suite
        .write_inner_content(|writer| {
            controller_times(run(), writer)?;
            tests.iter().try_for_each(|entry| test(*entry, paths, writer))
        })
        .map(drop)
}

/// Writes the controller time of each test in seconds. The schema has properties only in a suite.
fn controller_times<'t>(mut run: impl Iterator<Item = &'t FinishedTest>, writer: &mut XmlWriter<'_>) -> io::Result<()> {
    let properties = writer.create_element("properties");
    properties.write_inner_content(|writer| run.try_for_each(|test| controller_time(test, writer))).map(drop)
}

fn controller_time(test: &FinishedTest, writer: &mut XmlWriter<'_>) -> io::Result<()> {
    let name = allowed_name(&format!("controllerSeconds.{}", test.case.shown_title()));
    let seconds = format!("{:.3}", seconds(test.result.duration));
    let property = writer.create_element("property");
    property.with_attributes([("name", name.as_str()), ("value", seconds.as_str())]).write_empty().map(drop)
}

fn test(entry: JunitCase<'_>, paths: &Paths, writer: &mut XmlWriter<'_>) -> io::Result<()> {
    let case = entry.case();
    let time = if let JunitCase::Run(tested) = entry { tested.wall } else { Duration::ZERO };
    let test = writer.create_element("testcase").with_attributes([
        ("name", allowed_name(&case.shown_title()).as_str()),
        ("classname", allowed_name(case.shown_application()).as_str()),
        ("time", wall(time).as_str()),
    ]);
    test.write_inner_content(|writer| match entry {
        JunitCase::Run(tested) => {
            result(&tested.result, paths, writer)?;
            flaky_failures(tested, paths, writer)
        }
        JunitCase::NotRun(_, reason) => {
            writer.create_element("skipped").with_attribute(("message", reason)).write_empty().map(drop)
        }
    })
    .map(drop)
}

fn result(result: &TestResult, paths: &Paths, writer: &mut XmlWriter<'_>) -> io::Result<()> {
    if let Some(exemption) = &result.exemption {
        let message = allowed(&exemption.label());
        writer.create_element("skipped").with_attribute(("message", message.as_str())).write_empty()?;
    }
    if let Some(failure) = result.failures.first() {
        let message = allowed(failure.message.lines().next().unwrap_or_default());
        let element = writer.create_element("failure").with_attribute(("message", message.as_str()));
        let lines = allowed(&described(result, paths).join("\n"));
        element.write_text_content(BytesText::new(&lines))?;
    }
    let output = output(result);
    if output.is_empty() {
        return Ok(());
    }
    writer.create_element("system-out").write_text_content(BytesText::new(&allowed(&output))).map(drop)
}

/// Writes the failures of the attempts before the passed attempt.
fn flaky_failures(tested: &FinishedTest, paths: &Paths, writer: &mut XmlWriter<'_>) -> io::Result<()> {
    tested.earlier.iter().filter(|_| tested.is_flaky()).try_for_each(|failed| {
        let message = failed.failures.first().and_then(|failure| failure.message.lines().next());
        let message = allowed(message.unwrap_or_default());
        let element = writer.create_element("flakyFailure");
        let element = element.with_attributes([("message", message.as_str()), ("type", "failure")]);
        let lines = allowed(&described(failed, paths).join("\n"));
        element
            .write_inner_content(|writer| {
                writer.create_element("stackTrace").write_text_content(BytesText::new(&lines)).map(drop)
            })
            .map(drop)
    })
}

/// Printed lines, each with a prefix; for a failed test also the user page and the last events.
fn output(result: &TestResult) -> String {
    let printed = result.prints.iter().flat_map(|print| print.split('\n'));
    let mut lines: Vec<String> = printed.map(|line| format!("| {line}")).collect();
    if let Some(page) = &result.page {
        lines.push(format!("the screen shows:\n{page}"));
    }
    if !result.events.is_empty() {
        lines.push("last events:".to_owned());
        lines.extend(result.events.iter().map(|event| format!("  {}", one_line(&events::line(event)))));
    }
    lines.join("\n")
}

fn wall(time: Duration) -> String {
    format!("{:.3}", time.as_secs_f64())
}

#[cfg(test)]
mod tests {
    use codespan_reporting::term::termcolor::NoColor;

    use super::super::tested::examples::flaky;
    use super::*;

    #[test]
    fn failed_attempts_of_a_flaky_test_are_no_failures() {
        let (tested, paths) = (flaky(), Paths::new(&[], "/".into()));
        let mut out = NoColor::new(Vec::new());
        document(&mut out, |writer| suite(&[JunitCase::Run(&tested)], &paths, writer)).unwrap();
        let text = String::from_utf8(out.into_inner()).unwrap();
        assert!(text.contains(r#"tests="1" failures="0""#), "{text}");
        assert_eq!(text.matches("<flakyFailure").count(), 2, "{text}");
        for part in [r#"message="it was late" type="failure""#, "<stackTrace>no &lt;answer&gt;</stackTrace>"] {
            assert!(text.contains(part), "{part}: {text}");
        }
    }
}
