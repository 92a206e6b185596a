//! Results as one JSON object per line, written during the execution.

use std::io;

use codespan_reporting::term::termcolor::WriteColor;
use serde_json::json;

use super::json::{self, described, named};
use super::results::Results;
use super::workers::TestEvent;
use crate::paths::Paths;

/// Writes the line for a test that has started or finished.
pub(super) fn write(progress: &TestEvent<'_>, paths: &Paths, out: &mut dyn WriteColor) -> io::Result<()> {
    let (kind, test) = match progress {
        TestEvent::Started(case) => ("started", named(case, paths)),
        TestEvent::Finished(tested) => ("finished", described(tested, paths)),
        TestEvent::Next(_) => return Ok(()),
    };
    writeln!(out, "{}", json!({ "kind": kind, "test": test }))
}

/// Writes the lines of finished tests.
pub(super) fn document(results: &Results, paths: &Paths, out: &mut dyn WriteColor) -> io::Result<()> {
    results.tested.iter().try_for_each(|test| write(&TestEvent::Finished(test), paths, out))?;
    summary(results, paths, out)
}

/// Writes the last line.
pub(super) fn summary(results: &Results, paths: &Paths, out: &mut dyn WriteColor) -> io::Result<()> {
    let mut object = json::summary(results, paths);
    if let Some(object) = object.as_object_mut() {
        object.insert("kind".to_owned(), json!("summary"));
    }
    writeln!(out, "{object}")
}
