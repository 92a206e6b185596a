//! A test with its result.

use val3_suite::{Failure, Place, TestCase, TestResult};

use super::golden::RecordedFile;
use crate::paths::Paths;

/// A test with its result.
pub(super) struct Tested {
    pub(super) case: TestCase,
    pub(super) result: TestResult,
    /// The recorded motion that `--update` has written.
    pub(super) recorded: Option<RecordedFile>,
    /// It could be executed.
    pub(super) is_executed: bool,
}

/// The lines that describe failures: of each the message, and the programs that led there.
pub(super) fn described(failures: &[Failure], paths: &Paths) -> Vec<String> {
    let place = |place: &Place| match place.file.as_str() {
        "" => format!("at {}:{}", place.program, place.line),
        file => format!("at {} ({}:{})", place.program, paths.shown(file.into()), place.line),
    };
    let lines = |failure: &Failure| -> Vec<String> {
        failure.message.lines().map(str::to_owned).chain(failure.places.iter().map(place)).collect()
    };
    failures.iter().flat_map(lines).collect()
}
