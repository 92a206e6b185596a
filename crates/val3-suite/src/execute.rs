//! The execution of a test: `setup`, the test and `teardown`, one after the other on one controller in virtual time.

use val3_lang::ports::{TaskNumber, Time};
use val3_lang::test_names::{SETUP, TEARDOWN};
use val3_machine::controller::{Controller, NotStarted, Outcome};
use val3_machine::event::{Event, EventKind};
use val3_session::Pace;

use crate::application;
use crate::case::{TestCase, TestKind};
use crate::expect::{Cycle, Observer, error_failure};
use crate::journal::Journal;
use crate::library::{EXPECTATION, FAILURE};
use crate::result::{Failure, Place, TestResult};
use crate::scenario::Scenario;
use crate::unfinished::{is_stopped, places, unfinished};

/// The settings of tests.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct TestSettings {
    /// The time that a program of a test may take, on the controller's clock in nanoseconds.
    pub limit: Time,
}

/// Executes a test on a controller on which nothing has been executed yet, and which follows the script of `scenario`.
#[must_use]
pub fn execute(
    controller: &mut Controller,
    case: &TestCase,
    scenario: &Scenario,
    settings: TestSettings,
) -> TestResult {
    match case.kind {
        TestKind::Program => execute_program(controller, case, scenario, settings),
        TestKind::Scenario => application::execute(controller, scenario, settings),
    }
}

fn execute_program(
    controller: &mut Controller,
    case: &TestCase,
    scenario: &Scenario,
    settings: TestSettings,
) -> TestResult {
    if let Some(refusal) = &case.refusal {
        let message = refusal.clone();
        let place = Place { program: case.name(), file: case.file.clone(), line: case.line };
        return TestResult { failures: vec![Failure { message, places: vec![place] }], ..TestResult::default() };
    }
    let observer = scenario.observer();
    let mut execution = Execution { controller, settings, observer, expected: None, journal: Journal::default() };
    let mut failures: Vec<Failure> = execution.optional(SETUP).into_iter().collect();
    if failures.is_empty() {
        failures.extend(execution.test(case));
        failures.extend(execution.observer.failures(execution.controller));
    }
    execution.controller.kill_tasks();
    // It is executed whatever the result is.
    let teardown = execution.optional(TEARDOWN);
    if failures.is_empty() {
        failures.extend(teardown);
    }
    let Execution { controller, observer, journal, .. } = execution;
    let motion = observer.into_motion();
    let (prints, events) = journal.into_parts();
    TestResult { failures, duration: controller.now(), prints, events, motion }
}

/// A test that is executed.
struct Execution<'c> {
    controller: &'c mut Controller,
    settings: TestSettings,
    observer: Observer<'c>,
    /// The run-time error that the test expects.
    expected: Option<u16>,
    journal: Journal,
}

/// The reason why a program of a test is over.
enum End {
    Done,
    Failed(Failure),
}

impl Execution<'_> {
    fn test(&mut self, case: &TestCase) -> Option<Failure> {
        let row = case.row.map(f64::from);
        let found = match self.program(&case.program, row.as_slice()) {
            Ok(end) => failure_of(end),
            Err(refused) => Some(failure(refused, Vec::new())),
        };
        let unraised = |code| failure(format!("error {code} was expected, and nothing has raised it"), Vec::new());
        found.or_else(|| self.expected.map(unraised))
    }

    /// Executes a program that the application need not have.
    fn optional(&mut self, program: &str) -> Option<Failure> {
        match self.program(program, &[]) {
            Ok(end) => failure_of(end),
            Err(_) => None,
        }
    }

    /// Executes a program, with numbers as the values of its parameters, to its end.
    ///
    /// # Errors
    /// It cannot be started.
    fn program(&mut self, program: &str, numbers: &[f64]) -> Result<End, String> {
        let lead = self.controller.start_with(program, numbers).map_err(|reason| refusal(program, reason))?;
        let end = self.controller.now().saturating_add(self.settings.limit);
        self.controller.set_limit(Some(end));
        loop {
            let start = self.controller.now();
            let outcome = self.controller.step_tasks();
            let events = self.controller.devices.take_events();
            self.observer.see(Cycle { start, events: &events, controller: self.controller });
            for event in events {
                if let Some(end) = self.see(&event, lead) {
                    return Ok(end);
                }
            }
            if !self.is_alive(lead) {
                return Ok(End::Done);
            }
            let next = self.observer.next_due().into_iter().chain([end]).min();
            let pace = Pace { until: next, ..Pace::default() };
            let waits = match outcome {
                Outcome::Waiting(wake) => pace.wait(self.controller, wake).is_some(),
                Outcome::Stuck => pace.wait_for_operator(self.controller).is_some(),
                _ => true,
            };
            if !waits || self.controller.now() >= end {
                return Ok(End::Failed(unfinished(self.controller, lead, self.settings.limit, waits)));
            }
        }
    }

    fn is_alive(&self, task: TaskNumber) -> bool {
        self.controller.vm.tasks().iter().any(|known| known.id == task)
    }

    /// Takes an event of the test. Returns the end that it means.
    fn see(&mut self, event: &Event, lead: TaskNumber) -> Option<End> {
        self.journal.see(event);
        match &event.kind {
            EventKind::Log { text, .. } if let Some(message) = after(text, FAILURE) => {
                Some(End::Failed(failure(message, places(self.controller, lead))))
            }
            EventKind::Log { text, .. } if let Some(code) = after(text, EXPECTATION) => {
                self.expected = code.parse().ok();
                None
            }
            EventKind::Error { code, .. } if self.expected == Some(*code) => {
                self.expected = None;
                self.controller.kill_tasks();
                Some(End::Done)
            }
            EventKind::Error { .. } if self.observer.expects(event) => {
                is_stopped(self.controller, lead).then_some(End::Done)
            }
            _ => error_failure(event).map(End::Failed),
        }
    }
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
