//! Run-time errors: expected errors must occur, and no others.

use std::ops::Range;

use serde::Deserialize;
use toml::Spanned;
use val3_lang::runtime_errors::MOTION_FAULT;
use val3_machine::event::{Event, EventKind};
use val3_machine::missing_instruction;

use super::fit::{ExpectationFault, Fit};
use crate::failure::{Failure, FailureLocation};
use crate::source::ExpectationSource;

/// A run-time error that a test expects, once or several times.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct ExpectedError {
    code: u16,
    task: Option<String>,
    program: Option<String>,
}

/// Run-time errors of a run.
pub(super) struct ExpectedErrors {
    expected: Vec<Spanned<ExpectedError>>,
    missing: Vec<Spanned<ExpectedError>>,
    unexpected: Vec<Failure>,
}

impl ExpectedError {
    fn is(&self, event: &Event) -> bool {
        let EventKind::Error { code, program, .. } = &event.kind else { return false };
        let is_task = self.task.is_none() || self.task == event.task;
        self.code == *code && is_task && self.program.as_ref().is_none_or(|expected| expected == program)
    }

    /// Fault for an unknown error number.
    pub(super) fn fault(&self, fit: &Fit<'_>, span: &Range<usize>) -> Option<ExpectationFault> {
        fit.error(self.code, span)
    }

    fn described(&self) -> String {
        let program = self.program.as_ref().map(|program| format!(" in the program `{program}`")).unwrap_or_default();
        let task = self.task.as_ref().map(|task| format!(" in the task `{task}`")).unwrap_or_default();
        format!("error {}{program}{task}", self.code)
    }
}

impl ExpectedErrors {
    pub(super) fn new(expected: &[Spanned<ExpectedError>]) -> Self {
        Self { expected: expected.to_vec(), missing: expected.to_vec(), unexpected: Vec::new() }
    }

    /// Whether the event is expected. Error 150 also covers a path that the arm cannot follow.
    pub(super) fn expects(&self, event: &Event) -> bool {
        let is_path = matches!(event.kind, EventKind::Fault { .. });
        let mut expected = self.expected.iter().map(Spanned::get_ref);
        expected.any(|expected| expected.is(event) || is_path && expected.code == MOTION_FAULT)
    }

    /// Processes the events of a cycle. `programs` returns the call stack of a task.
    pub(super) fn see(&mut self, events: &[Event], programs: &dyn Fn(&str) -> Vec<FailureLocation>) {
        for event in events {
            self.missing.retain(|expected| !expected.get_ref().is(event));
            if !self.expects(event) {
                self.unexpected.extend(failure(event, programs));
            }
        }
        // A restarted task may raise the same error several times.
        self.unexpected.dedup();
    }

    /// Failures of unexpected errors.
    pub(super) fn unexpected(&self) -> &[Failure] {
        &self.unexpected
    }

    /// Failures of expected errors that did not occur.
    pub(super) fn missing(&self, source: &ExpectationSource) -> impl Iterator<Item = Failure> {
        self.missing.iter().map(|expected| Failure {
            message: format!("{} was expected, and nothing has raised it", expected.get_ref().described()),
            places: vec![source.place("expect.errors", expected.span())],
        })
    }
}

/// Failure for a run-time error, a path that the arm cannot follow, or an instruction that the controller does not
/// support. Its places are the call stack of the event's task, which `programs` returns.
pub(crate) fn failure(event: &Event, programs: &dyn Fn(&str) -> Vec<FailureLocation>) -> Option<Failure> {
    let (message, place) = match &event.kind {
        EventKind::Error { code, message, program, line, file, .. } => (
            format!("error {code}: {message}"),
            FailureLocation { program: program.clone(), file: file.clone(), line: *line },
        ),
        EventKind::Fault { instruction, text, program, line, file, .. } => (
            format!("the arm cannot follow the path of this {instruction}: {text}"),
            FailureLocation { program: program.clone(), file: file.clone(), line: *line },
        ),
        EventKind::Lacking { instruction, program, line, file } => (
            missing_instruction(instruction),
            FailureLocation { program: program.clone(), file: file.clone(), line: *line },
        ),
        _ => return None,
    };
    Some(Failure { message, places: stack(place, event, programs) })
}

/// Call stack of the event's task, with `place` as innermost program; only `place` if the event happened elsewhere.
fn stack(
    place: FailureLocation,
    event: &Event,
    programs: &dyn Fn(&str) -> Vec<FailureLocation>,
) -> Vec<FailureLocation> {
    let mut places = event.task.as_deref().map(programs).unwrap_or_default();
    match places.first_mut() {
        Some(first) if first.file == place.file => {
            first.line = place.line;
            places
        }
        _ => vec![place],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn error(code: u16, task: &str, program: &str) -> Event {
        let (program, file) = (program.to_owned(), "a.pgx".to_owned());
        let (message, reason, help) = ("bad", None, "");
        let kind = EventKind::Error { code, message, reason, help, program, line: 3, file, is_line_missing: false };
        Event { t: 1.0, task: Some(task.to_owned()), at: None, kind }
    }

    fn expected(code: u16, task: Option<&str>, program: Option<&str>) -> Spanned<ExpectedError> {
        Spanned::new(0..1, ExpectedError { code, task: task.map(str::to_owned), program: program.map(str::to_owned) })
    }

    #[test]
    fn an_expected_error_matches_all_that_it_names() {
        for (expectation, matches) in [
            (expected(20, None, None), true),
            (expected(20, Some("t"), Some("p")), true),
            (expected(21, None, None), false),
            (expected(20, Some("u"), None), false),
            (expected(20, None, Some("q")), false),
        ] {
            let expectations = [expectation];
            let mut errors = ExpectedErrors::new(&expectations);
            errors.see(&[error(20, "t", "p")], &|_| Vec::new());
            assert_eq!(errors.missing(&ExpectationSource::default()).count(), usize::from(!matches));
            assert_eq!(errors.unexpected().len(), usize::from(!matches));
        }
    }

    #[test]
    fn an_error_that_is_repeated_is_one_failure() {
        let mut errors = ExpectedErrors::new(&[]);
        errors.see(&[error(20, "t", "p")], &|_| Vec::new());
        errors.see(&[error(20, "t", "p"), error(20, "t", "q")], &|_| Vec::new());
        assert_eq!(errors.unexpected().len(), 2);
        assert_eq!(errors.unexpected()[0].message, "error 20: bad");
    }
}
