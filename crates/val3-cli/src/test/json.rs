//! Results as one JSON object.

use std::io;

use codespan_reporting::term::termcolor::WriteColor;
use serde_json::{Value, json};
use val3_machine::event::seconds;
use val3_suite::{Failure, Place};

use super::tested::Tested;
use crate::paths::Paths;

/// Writes the object with all tests.
pub(super) fn write(tested: &[Tested], paths: &Paths, out: &mut dyn WriteColor) -> io::Result<()> {
    let tests: Vec<Value> = tested.iter().map(|test| described(test, paths)).collect();
    let failed = tested.iter().filter(|test| !test.result.has_passed()).count();
    let object = json!({ "version": 1, "passed": tested.len() - failed, "failed": failed, "tests": tests });
    writeln!(out, "{object:#}")
}

fn described(Tested { case, result, .. }: &Tested, paths: &Paths) -> Value {
    let failure = result.failures.split_first().map(|(first, others)| {
        let others: Vec<Value> =
            others.iter().map(|other| json!({ "message": other.message, "places": places(other, paths) })).collect();
        json!({ "message": first.message, "places": places(first, paths), "others": others })
    });
    json!({
        "application": case.application,
        "program": case.program,
        "file": paths.shown(case.file.as_str().into()),
        "line": case.line,
        "passed": result.has_passed(),
        "seconds": seconds(result.duration),
        "prints": result.prints,
        "failure": failure,
    })
}

fn places(failure: &Failure, paths: &Paths) -> Vec<Value> {
    let place = |place: &Place| json!({ "program": place.program, "file": paths.shown(place.file.as_str().into()), "line": place.line });
    failure.places.iter().map(place).collect()
}
