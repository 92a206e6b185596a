//! Results as one JSON object, and the list of tests without results.

use std::io;

use codespan_reporting::term::termcolor::WriteColor;
use serde_json::{Value, json};
use val3_machine::event::seconds;
use val3_suite::{Exemption, Failure, FailureLocation, RepeatedEvent, TestCase};

use super::discovery::Listed;
use super::results::{EarlyEnd, Results};
use super::source_line::source_line;
use super::tested::FinishedTest;
use crate::paths::Paths;

/// Writes the object with all tests.
pub(super) fn write(results: &Results, paths: &Paths, out: &mut dyn WriteColor) -> io::Result<()> {
    let tests: Vec<Value> = results.tested.iter().map(|test| described(test, paths)).collect();
    let mut object = summary(results, paths);
    if let Some(object) = object.as_object_mut() {
        object.insert("tests".to_owned(), tests.into());
    }
    writeln!(out, "{object:#}")
}

/// Numbers of tests, and the tests that were not executed.
pub(super) fn summary(results: &Results, paths: &Paths) -> Value {
    json!({
        "version": 1,
        "passed": results.passed(),
        "failed": results.failed(),
        "skipped": results.skipped(),
        "knownFailures": results.known_failures(),
        "wallSeconds": results.wall.as_secs_f64(),
        "interrupted": matches!(results.early_end, Some(EarlyEnd::Signal(_))),
        "notRun": results.not_run.iter().map(|case| named(case, paths)).collect::<Vec<_>>(),
    })
}

/// Writes the object with the applications that have tests, and the reason if an application cannot be tested.
pub(super) fn list(listed: &[Listed], paths: &Paths, out: &mut dyn WriteColor) -> io::Result<()> {
    let applications: Vec<Value> = listed.iter().map(|listed| application(listed, paths)).collect();
    writeln!(out, "{:#}", json!({ "version": 1, "applications": applications }))
}

fn application(listed: &Listed, paths: &Paths) -> Value {
    let folder = listed.manifest.parent().unwrap_or(&listed.manifest);
    let tests = listed.cases.as_ref().map(|cases| cases.iter().map(|case| named(case, paths)).collect::<Vec<_>>());
    json!({
        "name": listed.manifest.file_stem(),
        "file": paths.to_open(&listed.manifest),
        "folder": paths.to_open(folder),
        "tests": tests.as_ref().ok(),
        "error": tests.as_ref().err(),
    })
}

/// A test without its result.
pub(super) fn named(case: &TestCase, paths: &Paths) -> Value {
    json!({
        "id": case.shown_name(),
        "name": case.name(),
        "application": case.application,
        "program": case.program,
        "row": case.row,
        "file": paths.to_open(case.file.as_str().into()),
        "line": case.line,
    })
}

/// A test with its result.
pub(super) fn described(FinishedTest { case, result, wall, earlier, .. }: &FinishedTest, paths: &Paths) -> Value {
    let failure = result.failures.split_first().map(|(first, others)| {
        let others: Vec<Value> =
            others.iter().map(|other| json!({ "message": other.message, "places": places(other, paths) })).collect();
        json!({ "message": first.message, "places": places(first, paths), "others": others })
    });
    let events: Vec<Value> = result.events.iter().map(|event| repeated(event, paths)).collect();
    let row: Vec<Value> =
        result.row.iter().map(|(column, value)| json!({ "column": column, "value": value })).collect();
    json!({
        "id": case.shown_name(),
        "name": case.name(),
        "application": case.application,
        "program": case.program,
        "file": paths.to_open(case.file.as_str().into()),
        "row": case.row,
        "line": case.line,
        "passed": result.has_passed(),
        "seconds": seconds(result.duration),
        "wallSeconds": wall.as_secs_f64(),
        "timesNote": result.times_note,
        "prints": result.prints,
        "screen": result.page,
        "events": events,
        "rowValues": row,
        "failure": failure,
        "attempts": earlier.len() + 1,
        "exemption": result.exemption.as_ref().map(|exemption| exempt(exemption, paths)),
    })
}

/// Reason why a test has neither passed nor failed.
fn exempt(exemption: &Exemption, paths: &Paths) -> Value {
    match exemption {
        Exemption::Skipped { reason } => json!({ "kind": "skipped", "reason": reason }),
        Exemption::KnownFailure { reason, failures } => {
            let failures: Vec<Value> = failures
                .iter()
                .map(|failure| json!({ "message": failure.message, "places": places(failure, paths) }))
                .collect();
            json!({ "kind": "knownFailure", "reason": reason, "failures": failures })
        }
    }
}

/// An event as in the event record, with a displayed file path. A repeated event has its count and the time of its
/// first occurrence.
fn repeated(RepeatedEvent { event, count, since }: &RepeatedEvent, paths: &Paths) -> Value {
    let mut object = json!(event);
    if let Some(file) = object.get_mut("file")
        && let Some(path) = file.as_str()
    {
        *file = json!(paths.to_open(path.into()));
    }
    if let (Some(object), true) = (object.as_object_mut(), *count > 1) {
        object.insert("count".to_owned(), json!(count));
        object.insert("since".to_owned(), json!(since));
    }
    object
}

fn places(failure: &Failure, paths: &Paths) -> Vec<Value> {
    failure.places.iter().map(|place| location(place, paths)).collect()
}

fn location(location: &FailureLocation, paths: &Paths) -> Value {
    json!({
        "program": location.program,
        "file": paths.to_open(location.file.as_str().into()),
        "line": location.line,
        "source": source_line(location),
    })
}
