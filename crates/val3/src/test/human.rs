//! Results as text for people.

use std::io;

use codespan_reporting::term::termcolor::{Color, ColorSpec, WriteColor};
use val3_machine::event::seconds;
use val3_suite::{Exemption, Failure, TestResult};

use super::events;
use super::results::Results;
use super::tested::{FinishedTest, described};
use crate::paths::Paths;
use crate::printable::one_line;

/// Output state of the results.
#[derive(Debug, Default)]
pub(super) struct Listing {
    /// Whether passed tests are omitted.
    pub(super) is_quiet: bool,
    /// Application of the last test.
    application: String,
}

impl Listing {
    /// Writes the line of a test, and its failures.
    pub(super) fn add(&mut self, tested: &FinishedTest, paths: &Paths, out: &mut dyn WriteColor) -> io::Result<()> {
        let FinishedTest { case, result, .. } = tested;
        if self.is_quiet && result.has_passed() && result.exemption.is_none() && !tested.is_flaky() {
            return Ok(());
        }
        if self.application != case.shown_application() {
            writeln!(out, "{}", one_line(case.shown_application()))?;
            case.shown_application().clone_into(&mut self.application);
        }
        let (word, color) = match &result.exemption {
            None if result.has_passed() => ("ok  ", Color::Green),
            None => ("FAIL", Color::Red),
            Some(Exemption::Skipped { .. }) => ("skip", Color::Yellow),
            Some(Exemption::KnownFailure { .. }) => ("xfail", Color::Yellow),
        };
        out.set_color(ColorSpec::new().set_fg(Some(color)))?;
        write!(out, "  {word}")?;
        out.reset()?;
        write!(out, "  {} ({:.3} s)", one_line(&case.shown_title()), seconds(result.duration))?;
        match tested.attempts() {
            1 => writeln!(out)?,
            attempts if tested.is_flaky() => writeln!(out, ", flaky: {} of {attempts} failed", tested.earlier.len())?,
            attempts => writeln!(out, ", at each of {attempts} attempts")?,
        }
        let flaky = tested.earlier.first().filter(|_| tested.is_flaky());
        for line in flaky.into_iter().flat_map(|failed| described(failed, paths)) {
            writeln!(out, "        {line}")?;
        }
        for line in described(result, paths) {
            writeln!(out, "        {line}")?;
        }
        if result.has_passed() { Ok(()) } else { circumstances(result, out) }
    }
}

/// Writes all results.
pub(super) fn write(results: &Results, is_quiet: bool, paths: &Paths, out: &mut dyn WriteColor) -> io::Result<()> {
    let mut listing = Listing { is_quiet, ..Listing::default() };
    results.tested.iter().try_for_each(|tested| listing.add(tested, paths, out))?;
    summary(results, paths, out)
}

/// Writes the failures once more, one per line, if several tests were executed, and the numbers of tests.
pub(super) fn summary(results: &Results, paths: &Paths, out: &mut dyn WriteColor) -> io::Result<()> {
    let failed = results.failed();
    if failed > 0 && results.tested.len() > 1 {
        writeln!(out, "failures:")?;
        let of_test = |test: &FinishedTest| Some(failure_line(test, test.result.failures.first()?, paths));
        results.tested.iter().filter_map(of_test).try_for_each(|line| writeln!(out, "  {line}"))?;
    }
    write!(out, "{} passed, {failed} failed", results.passed())?;
    for (count, what) in
        [(results.skipped(), "skipped"), (results.known_failures(), "with a known failure"), (results.flaky(), "flaky")]
    {
        if count > 0 {
            write!(out, ", {count} {what}")?;
        }
    }
    match results.early_end {
        Some(end) if !results.not_run.is_empty() => writeln!(out, ", {} {}", results.not_run.len(), end.reason()),
        _ => writeln!(out),
    }
}

/// Writes the slowest tests with their durations.
pub(super) fn slowest(results: &Results, count: usize, out: &mut dyn WriteColor) -> io::Result<()> {
    if count > 0 && !results.tested.is_empty() {
        writeln!(out, "slowest tests:")?;
    }
    let slowest = results.slowest(count);
    slowest.iter().try_for_each(|test| {
        writeln!(out, "  {:7.3} s  {}", test.wall.as_secs_f64(), one_line(&test.case.shown_name()))
    })
}

/// Location, name and first line of a failure.
fn failure_line(FinishedTest { case, result, .. }: &FinishedTest, failure: &Failure, paths: &Paths) -> String {
    let place = failure.places.iter().find(|place| !place.file.is_empty());
    let (file, line) = place.map_or((&case.file, case.line), |place| (&place.file, place.line));
    let message = failure.message.lines().next().unwrap_or_default();
    let more = match result.failures.len() {
        0 | 1 => String::new(),
        several => format!(" (and {} more)", several - 1),
    };
    format!(
        "{}:{line}: {}: {}{more}",
        paths.shown(file.as_str().into()),
        one_line(&case.shown_name()),
        one_line(message)
    )
}

/// Writes the screen, the printed lines and the last events of a failed test.
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

#[cfg(test)]
mod tests {
    use codespan_reporting::term::termcolor::NoColor;

    use super::super::tested::examples::flaky;
    use super::*;

    #[test]
    fn a_flaky_test_shows_its_first_failure_in_quiet_output_as_well() {
        let mut listing = Listing { is_quiet: true, ..Listing::default() };
        let mut out = NoColor::new(Vec::new());
        listing.add(&flaky(), &Paths::new(&[], "/".into()), &mut out).unwrap();
        let text = String::from_utf8(out.into_inner()).unwrap();
        assert_eq!(text, "pal\n  ok    testHost (0.000 s), flaky: 2 of 3 failed\n        no <answer>\n");
    }
}
