//! Results in the Test Anything Protocol, version 14.

use std::io;

use codespan_reporting::term::termcolor::WriteColor;

use super::tested::{Tested, described};
use crate::paths::Paths;
use crate::printable::one_line;

/// Writes the plan and a line for each test, with the lines of a failure as comments.
pub(super) fn write(tested: &[Tested], paths: &Paths, out: &mut dyn WriteColor) -> io::Result<()> {
    writeln!(out, "TAP version 14\n1..{}", tested.len())?;
    for (Tested { case, result, .. }, number) in tested.iter().zip(1..) {
        let word = if result.has_passed() { "ok" } else { "not ok" };
        writeln!(out, "{word} {number} - {}", one_line(&case.name()))?;
        for line in described(result, paths) {
            writeln!(out, "# {}", one_line(&line))?;
        }
    }
    Ok(())
}
