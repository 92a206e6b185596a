//! A run-time error that a test expects with the program `expectError` of `val3assert`.

use val3_lang::ports::TaskNumber;
use val3_lang::runtime_errors;
use val3_machine::controller::Controller;

use crate::case::TestCase;
use crate::failure::{Failure, FailureLocation};
use crate::unfinished::{is_in_library, places};

/// An expected run-time error, and the line that expects it.
pub(crate) struct ExpectedCode {
    /// Error number.
    pub(crate) code: u16,
    /// Call stack of the task, innermost program first.
    places: Vec<FailureLocation>,
}

impl ExpectedCode {
    /// Creates the current expectation of a task. If the program of the library has already returned, its line is
    /// unknown, and the place is the test.
    pub(crate) fn new(code: u16, case: &TestCase, task: Option<TaskNumber>, controller: &Controller) -> Self {
        let expecting = task.filter(|task| is_in_library(controller, *task));
        let test = || vec![FailureLocation { program: case.program_name(), file: case.file.clone(), line: case.line }];
        Self { code, places: expecting.map_or_else(test, |task| places(controller, task)) }
    }

    /// Adds the expected error to the failure for a different error.
    pub(crate) fn instead(&self, mut failure: Failure) -> Failure {
        failure.message += &format!("\n  instead of {}, which `expectError` expects", self.described());
        let here = self
            .places
            .first()
            .map(|place| FailureLocation { program: format!("expectError({})", self.code), ..place.clone() });
        failure.places.extend(here);
        failure
    }

    /// Failure if the error was not raised.
    pub(crate) fn missing(self) -> Failure {
        let message = format!("{} was expected, and nothing has raised it", self.described());
        Failure { message, places: self.places }
    }

    fn described(&self) -> String {
        let meaning = runtime_errors::find(self.code).map(|error| format!(" ({})", error.short)).unwrap_or_default();
        format!("error {}{meaning}", self.code)
    }
}
