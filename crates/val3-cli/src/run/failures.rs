//! Tasks that a run-time error has stopped, until another task handles the error.

use val3_machine::event::{Event, EventKind};

/// Seconds of the controller's clock after which an error counts as unhandled while the run continues.
const PATIENCE: f64 = 1.0;

/// A run-time error that has stopped a task.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Failure {
    pub(super) task: String,
    pub(super) code: u16,
    pub(super) file: String,
    pub(super) line: u32,
    /// Why a move was refused.
    pub(super) reason: Option<String>,
    /// The time of the error, in seconds.
    at: f64,
    is_shown: bool,
}

/// The unhandled errors, in the order in which they occurred.
#[derive(Debug, Default)]
pub(super) struct Failures {
    unhandled: Vec<Failure>,
    /// The last line of the event log.
    logged: String,
    /// The line of the event log about the move that was refused last.
    refused: Option<String>,
}

impl Failures {
    /// Keeps an error. It counts as handled when another task resumes the failed one, or kills it.
    pub(super) fn follow(&mut self, event: &Event) {
        match &event.kind {
            EventKind::Log { text, .. } => self.logged.clone_from(text),
            // The error of the task follows.
            EventKind::Move { phase: "error", .. } => self.refused = Some(self.logged.clone()),
            EventKind::Error { code, line, file, .. } => {
                let (task, file, reason) = (event.task.clone().unwrap_or_default(), file.clone(), self.refused.take());
                let (code, line, at) = (*code, *line, event.t);
                self.unhandled.push(Failure { task, code, file, line, reason, at, is_shown: false });
            }
            EventKind::Task { state: "resumed" | "killed", name, .. } if event.task.is_some() => {
                // Libraries may have tasks of the same name.
                let handled = self.unhandled.iter().position(|failure| failure.task == *name);
                handled.map(|at| self.unhandled.remove(at));
            }
            _ => {}
        }
    }

    /// Whether every error was handled.
    pub(super) fn is_empty(&self) -> bool {
        self.unhandled.is_empty()
    }

    /// The unhandled errors that were not shown yet: those older than a moment at time `now`, or all of them when the
    /// run has ended.
    pub(super) fn take_unhandled(&mut self, now: Option<f64>) -> Vec<Failure> {
        let is_old = |failure: &Failure| now.is_none_or(|now| now >= failure.at + PATIENCE);
        let due = self.unhandled.iter_mut().filter(|failure| !failure.is_shown && is_old(failure));
        due.map(|failure| {
            failure.is_shown = true;
            failure.clone()
        })
        .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn error(task: &str, at: f64) -> Event {
        let (program, file) = (String::new(), String::new());
        Event {
            t: at,
            task: Some(task.to_owned()),
            kind: EventKind::Error { code: 10, message: "", program, line: 1, file },
        }
    }

    fn killed(name: &str, by: Option<&str>) -> Event {
        let (name, program) = (name.to_owned(), String::new());
        let kind = EventKind::Task { state: "killed", name, program, line: 1, code: None };
        Event { t: 0.0, task: by.map(str::to_owned), kind }
    }

    #[test]
    fn only_another_task_handles_an_error() {
        let mut failures = Failures::default();
        failures.follow(&error("work", 0.0));
        failures.follow(&killed("work", None));
        assert!(!failures.is_empty(), "the end of the application does not handle it");
        failures.follow(&killed("work", Some("main")));
        assert!(failures.is_empty());
    }

    #[test]
    fn an_error_is_shown_once() {
        let mut failures = Failures::default();
        failures.follow(&error("work", 2.0));
        assert!(failures.take_unhandled(Some(2.5)).is_empty(), "another task may still handle it");
        assert_eq!(failures.take_unhandled(Some(3.0)).len(), 1);
        assert!(failures.take_unhandled(None).is_empty());
        assert!(!failures.is_empty());
    }
}
