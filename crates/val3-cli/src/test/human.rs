//! Results as text.

use std::io;

use codespan_reporting::term::termcolor::{Color, ColorSpec, WriteColor};
use val3_machine::event::seconds;

use super::tested::{Tested, described};
use crate::paths::Paths;

/// Writes a line for each test, and what has failed.
pub(super) fn write(tested: &[Tested], paths: &Paths, out: &mut dyn WriteColor) -> io::Result<()> {
    let mut application = "";
    for Tested { case, result, .. } in tested {
        if application != case.application {
            writeln!(out, "{}", case.application)?;
            application = &case.application;
        }
        let (word, color) = if result.has_passed() { ("ok  ", Color::Green) } else { ("FAIL", Color::Red) };
        out.set_color(ColorSpec::new().set_fg(Some(color)))?;
        write!(out, "  {word}")?;
        out.reset()?;
        writeln!(out, "  {} ({:.3} s)", case.title(), seconds(result.duration))?;
        for line in described(&result.failures, paths) {
            writeln!(out, "        {line}")?;
        }
        for line in result.prints.iter().filter(|_| !result.has_passed()) {
            writeln!(out, "        | {line}")?;
        }
    }
    let failed = tested.iter().filter(|test| !test.result.has_passed()).count();
    writeln!(out, "{} passed, {failed} failed", tested.len() - failed)
}
