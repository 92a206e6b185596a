//! Results as one HTML page without scripts or other files. Its colours follow the light or dark setting of the system.

use std::io;

use codespan_reporting::term::termcolor::WriteColor;
use quick_xml::escape::escape;
use val3_machine::event::seconds;

use super::events;
use super::results::Results;
use super::tested::{FinishedTest, described};
use crate::paths::Paths;

const STYLE: &str = include_str!("html/style.css");

/// Writes the page: the counts, then each application's tests. Failed tests are expanded, with drawings of motions
/// that differ from recorded motions.
pub(super) fn write(results: &Results, paths: &Paths, out: &mut dyn WriteColor) -> io::Result<()> {
    let numbers = numbers(results);
    writeln!(
        out,
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width\">\n<meta name=\"color-scheme\" content=\"light dark\">\n\
         <title>val3 test: {numbers}</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n<h1>Tests</h1>\n<p>{numbers}, in \
         {:.2} s</p>",
        results.wall.as_secs_f64()
    )?;
    failures(results, out)?;
    let of_application =
        results.tested.chunk_by(|one, other| one.case.shown_application() == other.case.shown_application());
    for tests in of_application {
        let name = tests.first().map_or("", |test| test.case.shown_application());
        writeln!(out, "<h2>{}</h2>", escape(name))?;
        tests.iter().try_for_each(|tested| test(tested, paths, out))?;
    }
    if !results.not_run.is_empty() {
        writeln!(out, "<h2>Not run</h2>")?;
    }
    for (case, reason) in results.not_run() {
        writeln!(out, "<p class=\"test exempt\"><b>–</b> {} <small>{reason}</small></p>", escape(case.shown_name()))?;
    }
    writeln!(out, "</body>\n</html>")
}

/// Writes the failed tests with each failure's first line, linked to the details.
fn failures(results: &Results, out: &mut dyn WriteColor) -> io::Result<()> {
    let failed: Vec<&FinishedTest> = results.tested.iter().filter(|test| !test.result.has_passed()).collect();
    if failed.is_empty() {
        return Ok(());
    }
    writeln!(out, "<ul>")?;
    for FinishedTest { case, result, .. } in failed {
        let message = result.failures.first().and_then(|failure| failure.message.lines().next()).unwrap_or_default();
        let name = case.shown_name();
        let (name, message) = (escape(name.as_str()), escape(message));
        writeln!(out, "<li><a href=\"#{name}\">{name}</a>: {message}</li>")?;
    }
    writeln!(out, "</ul>")
}

fn numbers(results: &Results) -> String {
    let all = [
        (results.passed(), "passed"),
        (results.failed(), "failed"),
        (results.skipped(), "skipped"),
        (results.known_failures(), "with a known failure"),
        (results.flaky(), "flaky"),
        (results.not_run.len(), "not run"),
    ];
    let shown = all.into_iter().enumerate().filter(|(place, (count, _))| *place < 2 || *count > 0);
    shown.map(|(_, (count, what))| format!("{count} {what}")).collect::<Vec<_>>().join(", ")
}

/// Writes a row for a test, with its circumstances if there are any.
fn test(tested: &FinishedTest, paths: &Paths, out: &mut dyn WriteColor) -> io::Result<()> {
    let FinishedTest { case, result, .. } = tested;
    let (class, sign) = match (&result.exemption, result.has_passed()) {
        (Some(_), _) => ("exempt", "–"),
        (None, true) => ("passed", "✓"),
        (None, false) => ("failed", "✗"),
    };
    let title =
        format!("<b>{sign}</b> {} <small>{:.3} s</small>", escape(case.shown_title()), seconds(result.duration));
    let mut lines = described(result, paths);
    if let Some(page) = &result.page {
        lines.push(format!("the screen shows:\n{page}"));
    }
    lines.extend(result.prints.iter().map(|print| format!("| {print}")));
    if !result.events.is_empty() {
        lines.push("last events:".to_owned());
        lines.extend(result.events.iter().map(|event| format!("  {}", events::line(event))));
    }
    if lines.is_empty() {
        return writeln!(out, "<p class=\"test {class}\">{title}</p>");
    }
    let open = if result.has_passed() { "" } else { " open" };
    let id = case.shown_name();
    let id = escape(id.as_str());
    writeln!(out, "<details id=\"{id}\" class=\"{class}\"{open}><summary>{title}</summary>")?;
    writeln!(out, "<pre>{}</pre>", escape(lines.join("\n")))?;
    if let Some(picture) = &result.picture {
        writeln!(out, "<figure>{picture}</figure>")?;
    }
    writeln!(out, "</details>")
}
