//! The execution of a test: `setup`, the test and `teardown`, one after the other on one controller in virtual time.

use val3_debug::frames;
use val3_lang::ports::{TaskNumber, Time};
use val3_machine::controller::{Controller, NotStarted, Outcome};
use val3_machine::event::{Event, EventKind, seconds};
use val3_session::Pace;

use crate::case::TestCase;
use crate::library::{EXPECTATION, FAILURE, NAME};
use crate::result::{Failure, Place, TestResult};

/// The lines of output that a result keeps.
const PRINTS: usize = 100;

/// The programs that are executed before and after each test, where the application has them.
pub(crate) const SETUP: &str = "setup";
pub(crate) const TEARDOWN: &str = "teardown";

/// The settings of tests.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct TestSettings {
    /// The time that a program of a test may take, on the controller's clock in nanoseconds.
    pub limit: Time,
}

/// Executes a test on a controller on which nothing has been executed yet.
#[must_use]
pub fn execute(controller: &mut Controller, case: &TestCase, settings: TestSettings) -> TestResult {
    if case.has_parameters {
        let message = format!("`{}` has parameters: a test is started without values", case.program);
        let place = Place { program: case.name(), file: case.file.clone(), line: case.line };
        return TestResult { failure: Some(Failure { message, places: vec![place] }), ..TestResult::default() };
    }
    let mut execution = Execution { controller, settings, expected: None, prints: Vec::new() };
    let failure = execution.optional(SETUP).or_else(|| execution.test(&case.program));
    execution.controller.kill_tasks();
    // It is executed whatever the result is.
    let failure = failure.or(execution.optional(TEARDOWN));
    TestResult { failure, duration: execution.controller.now(), prints: execution.prints }
}

/// A test that is executed.
struct Execution<'c> {
    controller: &'c mut Controller,
    settings: TestSettings,
    /// The run-time error that the test expects.
    expected: Option<u16>,
    prints: Vec<String>,
}

/// The reason why a program of a test is over.
enum End {
    Done,
    Failed(Failure),
}

impl Execution<'_> {
    fn test(&mut self, program: &str) -> Option<Failure> {
        let found = match self.program(program) {
            Ok(end) => failure_of(end),
            Err(refused) => Some(failure(refused, Vec::new())),
        };
        let unraised = |code| failure(format!("error {code} was expected, and nothing has raised it"), Vec::new());
        found.or_else(|| self.expected.map(unraised))
    }

    /// Executes a program that the application need not have.
    fn optional(&mut self, program: &str) -> Option<Failure> {
        match self.program(program) {
            Ok(end) => failure_of(end),
            Err(_) => None,
        }
    }

    /// Executes a program to its end.
    ///
    /// # Errors
    /// It cannot be started.
    fn program(&mut self, program: &str) -> Result<End, String> {
        let lead = self.controller.start(program).map_err(|reason| refusal(program, reason))?;
        let end = self.controller.now().saturating_add(self.settings.limit);
        let pace = Pace { until: Some(end), ..Pace::default() };
        self.controller.set_limit(pace.until);
        loop {
            let outcome = self.controller.step_tasks();
            for event in self.controller.devices.take_events() {
                if let Some(end) = self.see(event, lead) {
                    return Ok(end);
                }
            }
            if !self.is_alive(lead) {
                return Ok(End::Done);
            }
            let waits = match outcome {
                Outcome::Waiting(wake) => pace.wait(self.controller, wake).is_some(),
                Outcome::Stuck => pace.wait_for_operator(self.controller).is_some(),
                _ => true,
            };
            if !waits || self.controller.now() >= end {
                return Ok(End::Failed(self.unfinished(lead, waits)));
            }
        }
    }

    fn is_alive(&self, task: TaskNumber) -> bool {
        self.controller.vm.tasks().iter().any(|known| known.id == task)
    }

    /// Takes an event of the test. Returns the end that it means.
    fn see(&mut self, event: Event, lead: TaskNumber) -> Option<End> {
        match event.kind {
            EventKind::Print { text } => {
                if self.prints.len() == PRINTS {
                    self.prints.remove(0);
                }
                self.prints.push(text);
                None
            }
            EventKind::Log { ref text, .. } if let Some(message) = after(text, FAILURE) => {
                Some(End::Failed(failure(message, places(self.controller, lead))))
            }
            EventKind::Log { ref text, .. } if let Some(code) = after(text, EXPECTATION) => {
                self.expected = code.parse().ok();
                None
            }
            EventKind::Error { code, .. } if self.expected == Some(code) => {
                self.expected = None;
                self.controller.kill_tasks();
                Some(End::Done)
            }
            EventKind::Error { code, message, program, line, file } => {
                let place = Place { program, file, line };
                Some(End::Failed(failure(format!("error {code}: {message}"), vec![place])))
            }
            EventKind::Lacking { instruction, program, line, .. } => {
                let place = Place { program, file: String::new(), line };
                let message = format!("this controller does not have `{instruction}`");
                Some(End::Failed(failure(message, vec![place])))
            }
            _ => None,
        }
    }

    /// The failure of a test that does not end.
    fn unfinished(&self, lead: TaskNumber, has_time: bool) -> Failure {
        let position = self.controller.vm.tasks().iter().zip(self.controller.task_positions());
        let activity = position.into_iter().find(|(task, _)| task.id == lead).map(|(_, position)| position.activity);
        let activity = activity.map_or_else(String::new, |activity| activity.to_string());
        let message = if has_time {
            format!("not ended after {} s: it {activity}", seconds(self.settings.limit))
        } else {
            format!("it never ends: it {activity}, and nothing can happen any more")
        };
        failure(message, places(self.controller, lead))
    }
}

/// The programs that a task is in, without those of the library.
pub(crate) fn places(controller: &Controller, task: TaskNumber) -> Vec<Place> {
    let frames = frames(&controller.vm, task).into_iter().filter(|frame| frame.application != NAME);
    let place = |frame: val3_debug::TaskFrame| Place {
        program: format!("{}:{}", frame.application, frame.program),
        file: frame.file,
        line: frame.row,
    };
    frames.map(place).collect()
}

/// What a message of the library says after its beginning. Date, time and the mark `USR` precede it.
pub(crate) fn after(text: &str, beginning: &str) -> Option<String> {
    text.split_once(beginning).map(|(_, message)| message.trim().to_owned())
}

pub(crate) fn failure(message: String, places: Vec<Place>) -> Failure {
    Failure { message, places }
}

fn failure_of(end: End) -> Option<Failure> {
    match end {
        End::Done => None,
        End::Failed(failure) => Some(failure),
    }
}

pub(crate) fn refusal(program: &str, reason: NotStarted) -> String {
    match reason {
        NotStarted::NoProgram => format!("there is no program `{program}`"),
        NotStarted::HasParameters => format!("`{program}` has parameters"),
        NotStarted::Fault(fault) => format!("`{program}` cannot be started: error {}", fault.0),
    }
}
