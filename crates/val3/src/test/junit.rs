//! Results as JUnit XML: an application is a suite.

use std::io;

use codespan_reporting::term::termcolor::WriteColor;
use quick_xml::events::BytesText;
use val3_machine::event::seconds;

use super::tested::{Tested, described};
use crate::format::xml::{XmlWriter, allowed, allowed_name, document};
use crate::paths::Paths;

/// Writes one `<testsuite>` an application.
pub(super) fn write(tested: &[Tested], paths: &Paths, out: &mut dyn WriteColor) -> io::Result<()> {
    document(out, |writer| {
        let root = writer.create_element("testsuites").with_attributes([
            ("name", "val3 test"),
            ("tests", tested.len().to_string().as_str()),
            ("failures", failures(tested).to_string().as_str()),
        ]);
        let suites = tested.chunk_by(|one, other| one.case.application == other.case.application);
        root.write_inner_content(|writer| suites.into_iter().try_for_each(|tests| suite(tests, paths, writer)))
            .map(drop)
    })
}

fn failures(tests: &[Tested]) -> usize {
    tests.iter().filter(|test| !test.result.has_passed()).count()
}

fn suite(tests: &[Tested], paths: &Paths, writer: &mut XmlWriter<'_>) -> io::Result<()> {
    let name = tests.first().map_or("", |test| test.case.application.as_str());
    let suite = writer.create_element("testsuite").with_attributes([
        ("name", allowed_name(name).as_str()),
        ("tests", tests.len().to_string().as_str()),
        ("failures", failures(tests).to_string().as_str()),
        ("errors", "0"),
    ]);
    suite.write_inner_content(|writer| tests.iter().try_for_each(|test| self::test(test, paths, writer))).map(drop)
}

fn test(Tested { case, result, .. }: &Tested, paths: &Paths, writer: &mut XmlWriter<'_>) -> io::Result<()> {
    let test = writer.create_element("testcase").with_attributes([
        ("name", allowed_name(&case.title()).as_str()),
        ("classname", allowed_name(&case.application).as_str()),
        ("time", format!("{:.3}", seconds(result.duration)).as_str()),
    ]);
    let Some(failure) = result.failures.first() else { return test.write_empty().map(drop) };
    let lines = allowed(&described(result, paths).join("\n"));
    let message = allowed(&failure.message);
    test.write_inner_content(|writer| {
        let element = writer.create_element("failure").with_attribute(("message", message.as_str()));
        element.write_text_content(BytesText::new(&lines)).map(drop)
    })
    .map(drop)
}
