//! Results as JSON objects, one a line, while the tests are executed.

use std::io;

use codespan_reporting::term::termcolor::WriteColor;
use serde_json::json;

use super::json::{described, named};
use super::tested::Tested;
use super::workers::Progress;
use crate::paths::Paths;

/// Writes the line of a test that has started or finished.
pub(super) fn write(progress: &Progress<'_>, paths: &Paths, out: &mut dyn WriteColor) -> io::Result<()> {
    let (kind, test) = match progress {
        Progress::Started(case) => ("started", named(case, paths)),
        Progress::Finished(tested) => ("finished", described(tested, paths)),
    };
    writeln!(out, "{}", json!({ "kind": kind, "test": test }))
}

/// Writes the lines of tests that are over.
pub(super) fn document(tested: &[Tested], paths: &Paths, out: &mut dyn WriteColor) -> io::Result<()> {
    tested.iter().try_for_each(|test| write(&Progress::Finished(test), paths, out))?;
    summary(tested, out)
}

/// Writes the last line.
pub(super) fn summary(tested: &[Tested], out: &mut dyn WriteColor) -> io::Result<()> {
    let failed = tested.iter().filter(|test| !test.result.has_passed()).count();
    let object = json!({ "kind": "summary", "version": 1, "passed": tested.len() - failed, "failed": failed });
    writeln!(out, "{object}")
}
