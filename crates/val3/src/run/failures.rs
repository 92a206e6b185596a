//! Tracks unhandled run-time errors, and paths that the arm cannot follow.

use val3_debug::causes;
use val3_lang::fault::Fault;
use val3_lang::runtime_errors::MOTION_FAULT;
use val3_machine::controller::Controller;
use val3_machine::event::{Event, EventKind};

/// Time in seconds on the controller's clock after which an error counts as unhandled while the run continues.
const NOTE_DELAY: f64 = 1.0;

/// A run-time error that has stopped a task.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Failure {
    pub(super) task: String,
    pub(super) code: u16,
    pub(super) file: String,
    pub(super) line: u32,
    /// Reason why a move was rejected, or the data that caused the error.
    pub(super) reason: Option<String>,
    /// Whether the error concerns a serial line or socket that the cell does not configure.
    pub(super) is_line_missing: bool,
    /// Time of the error, in seconds.
    at: f64,
    is_shown: bool,
}

/// A recorded path that the arm cannot follow.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct ImpossiblePath {
    /// Instruction that has recorded the move.
    pub(super) instruction: &'static str,
    pub(super) file: String,
    pub(super) line: u32,
    /// Reason why the arm cannot follow the path.
    pub(super) reason: String,
    is_shown: bool,
}

/// Unhandled errors, in the order in which they occurred.
#[derive(Debug, Default)]
pub(super) struct Failures {
    unhandled: Vec<Failure>,
    /// Path before which the arm has stopped, until `resetMotion` discards it.
    path: Option<ImpossiblePath>,
}

impl Failures {
    /// Tracks the errors in events. An error counts as handled when another task resumes or kills the failed task.
    pub(super) fn follow(&mut self, event: &Event) {
        match &event.kind {
            EventKind::Fault { instruction, text, file, line, .. } => {
                let (file, reason) = (file.clone(), text.clone());
                self.path = Some(ImpossiblePath { instruction, file, line: *line, reason, is_shown: false });
            }
            EventKind::Move { phase: "reset", .. } => self.path = None,
            EventKind::Error { code, reason, line, file, is_line_missing, .. } => {
                let is_line_missing = *is_line_missing;
                let (task, file, reason) = (event.task.clone().unwrap_or_default(), file.clone(), reason.clone());
                let (code, line, at) = (*code, *line, event.t);
                self.unhandled.push(Failure { task, code, file, line, reason, is_line_missing, at, is_shown: false });
            }
            EventKind::Task { state: "resumed" | "killed", name, .. } if event.task.is_some() => {
                // Libraries may have tasks with the same name.
                let handled = self.unhandled.iter().position(|failure| failure.task == *name);
                handled.map(|at| self.unhandled.remove(at));
            }
            _ => {}
        }
    }

    /// Adds the causes to errors of tasks that still exist.
    pub(super) fn find_causes(&mut self, controller: &mut Controller) {
        for failure in self.unhandled.iter_mut().filter(|failure| failure.reason.is_none()) {
            let task = controller.vm.tasks().iter().find(|task| task.name == failure.task).map(|task| task.id);
            let causes = task.map_or_else(Vec::new, |task| causes(controller, task, Fault(failure.code)));
            failure.reason = (!causes.is_empty()).then(|| causes.join("; "));
        }
    }

    /// Returns the unhandled error with which a task has stopped at a time in seconds.
    pub(super) fn unhandled(&self, task: &str, at: f64) -> Option<&Failure> {
        self.unhandled.iter().find(|failure| failure.task == task && failure.at == at)
    }

    /// Returns the path that the arm cannot follow.
    pub(super) fn path(&self) -> Option<&ImpossiblePath> {
        self.path.as_ref()
    }

    /// Whether every error was handled, and the arm can follow its path.
    pub(super) fn is_empty(&self) -> bool {
        self.unhandled.is_empty() && self.path.is_none()
    }

    /// Returns the path that the arm cannot follow, unless it was already shown or is the cause of an unhandled error
    /// 150.
    pub(super) fn take_path(&mut self) -> Option<ImpossiblePath> {
        let is_known = self.unhandled.iter().any(|failure| failure.code == MOTION_FAULT);
        let path = self.path.as_mut().filter(|path| !is_known && !path.is_shown)?;
        path.is_shown = true;
        Some(path.clone())
    }

    /// Returns the unhandled errors that were not yet shown: the errors that occurred at least `NOTE_DELAY` before `now`,
    /// or all errors if the run has ended.
    pub(super) fn take_unhandled(&mut self, now: Option<f64>) -> Vec<Failure> {
        let is_old = |failure: &Failure| now.is_none_or(|now| now >= failure.at + NOTE_DELAY);
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
    use val3_machine::blend_ends::BlendEnds;

    use super::*;

    fn error(task: &str, at: f64) -> Event {
        numbered(10, task, at)
    }

    fn numbered(code: u16, task: &str, at: f64) -> Event {
        let (program, file, reason) = (String::new(), String::new(), None);
        let (message, help) = ("", "");
        let kind = EventKind::Error { code, message, reason, help, program, line: 1, file, is_line_missing: false };
        Event { t: at, task: Some(task.to_owned()), at: None, kind }
    }

    fn killed(name: &str, by: Option<&str>) -> Event {
        let (name, program) = (name.to_owned(), String::new());
        let kind = EventKind::Task { state: "killed", name, program, line: 1, code: None, file: String::new() };
        Event { t: 0.0, task: by.map(str::to_owned), at: None, kind }
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
    fn a_path_is_a_failure_until_it_is_discarded() {
        let (program, file, text) = (String::new(), String::new(), String::new());
        let kind = EventKind::Fault { id: 0.0, instruction: "movel", text, program, line: 1, file };
        let fault = Event { t: 1.0, task: None, at: None, kind };
        let mut failures = Failures::default();
        failures.follow(&fault);
        assert!(!failures.is_empty());
        assert!(failures.take_path().is_some() && failures.take_path().is_none(), "it is shown once");
        let kind = EventKind::Move {
            id: 0.0,
            phase: "reset",
            instruction: "resetMotion",
            program: String::new(),
            line: 1,
            blend: BlendEnds::default(),
            target: None,
        };
        failures.follow(&Event { t: 2.0, task: None, at: None, kind });
        assert!(failures.is_empty());
        failures.follow(&numbered(MOTION_FAULT, "work", 3.0));
        failures.follow(&fault);
        assert_eq!(failures.take_path(), None, "error 150 has the reason");
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
