//! A test with its result.

use std::iter;

use val3_suite::{Failure, TestCase, TestResult};

use crate::paths::Paths;

/// A test with its result.
pub(super) struct Tested {
    pub(super) case: TestCase,
    pub(super) result: TestResult,
}

/// The lines that describe a failure: the message, and the programs that led there.
pub(super) fn described(failure: &Failure, paths: &Paths) -> Vec<String> {
    let places = failure.places.iter().map(|place| match place.file.as_str() {
        "" => format!("at {}:{}", place.program, place.line),
        file => format!("at {} ({}:{})", place.program, paths.shown(file.into()), place.line),
    });
    iter::once(failure.message.clone()).chain(places).collect()
}
