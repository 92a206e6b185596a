//! Workflow commands of GitHub Actions: each failure becomes a line annotation in the pull request.

use std::io;

use codespan_reporting::term::termcolor::WriteColor;

use super::results::Results;
use super::tested::lines;
use crate::format::github::{data, property, write_limit};
use crate::paths::Paths;

/// Writes one command for each failure, at the line of the innermost program or of the expectation.
pub(super) fn write(results: &Results, paths: &Paths, out: &mut dyn WriteColor) -> io::Result<()> {
    let tested = &results.tested;
    let failures = tested.iter().flat_map(|test| test.result.failures.iter().map(|failure| (&test.case, failure)));
    for (case, failure) in failures {
        let place = failure.places.iter().find(|place| !place.file.is_empty());
        let (file, line) = place.map_or((&case.file, case.line), |place| (&place.file, place.line));
        let file = property(&paths.in_repository(file.as_str().into()));
        let title = property(&case.shown_name());
        writeln!(out, "::error file={file},line={line},title={title}::{}", data(&lines(failure, paths).join("\n")))?;
    }
    if let Some(end) = results.early_end.filter(|_| !results.not_run.is_empty()) {
        let count = results.not_run.len();
        writeln!(out, "::warning title=val3 test::{}", data(&format!("{count} tests were {}", end.reason())))?;
    }
    let count = tested.iter().map(|test| test.result.failures.len()).sum();
    write_limit(&[("error", count)], out)
}
