//! An earlier run's report, written by `--output json=FILE`.

use std::collections::BTreeMap;
use std::fmt::Display;

use camino::Utf8Path;
use serde::Deserialize;
use val3_files::FileClass;
use val3_session::json_fault;

use crate::user_error::UserError;

/// JSON object of the report.
#[derive(Debug, Deserialize)]
struct PreviousReport {
    version: u32,
    tests: Vec<PreviousTest>,
}

#[derive(Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
struct PreviousTest {
    id: String,
    passed: bool,
    wall_seconds: f64,
}

/// An earlier run's results, by test name.
#[derive(Debug, Default)]
pub(super) struct Previous {
    results: BTreeMap<String, PreviousResult>,
}

#[derive(Debug)]
struct PreviousResult {
    has_failed: bool,
    seconds: f64,
}

fn unusable(path: &Utf8Path, reason: &dyn Display) -> UserError {
    UserError::new(format!("`{path}` is no report of tests: {reason}"))
        .with_help("write one by `val3 test --output json=FILE`")
}

impl Previous {
    /// Reads a report. A test that occurs several times has failed if it has failed once.
    ///
    /// # Errors
    /// The file cannot be read, or is no report.
    pub(super) fn read(path: &Utf8Path) -> Result<Self, UserError> {
        let text = val3_files::read_text(path, FileClass::Record).map_err(|error| unusable(path, &error))?;
        let report: PreviousReport =
            serde_json::from_str(&text).map_err(|error| unusable(path, &json_fault(&error, error.line())))?;
        if report.version != 1 {
            return Err(unusable(path, &format!("its version is {}, not 1", report.version)));
        }
        let mut results: BTreeMap<String, PreviousResult> = BTreeMap::new();
        for PreviousTest { id, passed, wall_seconds } in report.tests {
            let known = results.entry(id).or_insert(PreviousResult { has_failed: false, seconds: 0.0 });
            known.has_failed |= !passed;
            known.seconds = known.seconds.max(wall_seconds);
        }
        Ok(Self { results })
    }

    /// Whether the test has failed.
    pub(super) fn has_failed(&self, id: &str) -> bool {
        self.results.get(id).is_some_and(|result| result.has_failed)
    }

    /// Duration of a test in seconds; for a new test, the mean duration of all tests.
    pub(super) fn seconds(&self, id: &str) -> f64 {
        let sum: f64 = self.results.values().map(|result| result.seconds).sum();
        let mean = || sum / (self.results.len() as f64).max(1.0);
        self.results.get(id).map_or_else(mean, |result| result.seconds)
    }
}
