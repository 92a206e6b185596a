//! Results as text.

use std::io;

use codespan_reporting::term::termcolor::{Color, ColorSpec, WriteColor};
use val3_machine::event::seconds;
use val3_suite::TestResult;

use super::events;
use super::tested::{Tested, described};
use crate::paths::Paths;
use crate::printable::one_line;

/// Writes a line for each test, and what has failed.
pub(super) fn write(tested: &[Tested], paths: &Paths, out: &mut dyn WriteColor) -> io::Result<()> {
    let mut application = "";
    for Tested { case, result, .. } in tested {
        if application != case.application {
            writeln!(out, "{}", one_line(&case.application))?;
            application = &case.application;
        }
        let (word, color) = if result.has_passed() { ("ok  ", Color::Green) } else { ("FAIL", Color::Red) };
        out.set_color(ColorSpec::new().set_fg(Some(color)))?;
        write!(out, "  {word}")?;
        out.reset()?;
        writeln!(out, "  {} ({:.3} s)", one_line(&case.title()), seconds(result.duration))?;
        for line in described(result, paths) {
            writeln!(out, "        {line}")?;
        }
        if !result.has_passed() {
            circumstances(result, out)?;
        }
    }
    let failed = tested.iter().filter(|test| !test.result.has_passed()).count();
    writeln!(out, "{} passed, {failed} failed", tested.len() - failed)
}

/// Writes what a failed test has shown and printed, and its last events.
fn circumstances(result: &TestResult, out: &mut dyn WriteColor) -> io::Result<()> {
    if let Some(page) = &result.page {
        writeln!(out, "        the screen shows:")?;
        page.lines().try_for_each(|line| writeln!(out, "          {line}"))?;
    }
    for line in result.prints.iter().flat_map(|print| print.split('\n')) {
        writeln!(out, "        | {line}")?;
    }
    if !result.events.is_empty() {
        writeln!(out, "        last events:")?;
    }
    result.events.iter().try_for_each(|event| writeln!(out, "          {}", one_line(&events::line(event))))
}
