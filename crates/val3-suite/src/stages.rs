//! The programs of a test one after the other, on a controller that the caller advances: a debugger stops between its lines.

use val3_lang::ports::TaskNumber;
use val3_lang::test_names::{SETUP, TEARDOWN};
use val3_machine::controller::{Controller, NotStarted};
use val3_machine::event::{Event, EventKind};

use crate::case::TestCase;
use crate::execute::{after, failure, refusal};
use crate::expect::error_failure;
use crate::journal::Journal;
use crate::library::{EXPECTATION, FAILURE};
use crate::result::{Failure, TestResult};
use crate::unfinished::places;

/// A test whose caller advances the controller.
#[derive(Debug)]
pub struct Stages {
    /// The test.
    pub case: TestCase,
    stage: Stage,
    lead: Option<TaskNumber>,
    failure: Option<Failure>,
    /// The run-time error that the test expects.
    expected: Option<u16>,
    /// The program is over, although its task may not have ended.
    is_decided: bool,
    journal: Journal,
}

/// The program that is executed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd)]
enum Stage {
    Setup,
    Test,
    Teardown,
    Over,
}

/// What has changed with [`Stages::follow`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Transition {
    /// Nothing: the program is executed further.
    None,
    /// The next program has been started.
    Started,
    /// The test is over.
    Over,
}

impl Stages {
    /// Starts the first program of a test on a controller on which nothing has been executed yet.
    ///
    /// # Errors
    /// The test cannot be started, with the reason.
    pub fn start(controller: &mut Controller, case: TestCase) -> Result<Self, String> {
        if let Some(refusal) = case.refusal {
            return Err(refusal);
        }
        controller.outlive_tasks();
        let mut stages = Self {
            case,
            stage: Stage::Setup,
            lead: None,
            failure: None,
            expected: None,
            is_decided: false,
            journal: Journal::default(),
        };
        if !stages.enter(Stage::Setup, controller) {
            stages.enter(Stage::Test, controller);
        }
        match stages.failure {
            Some(failure) => Err(failure.message),
            None => Ok(stages),
        }
    }

    /// Takes the events of the last cycle or a part of it.
    pub fn see(&mut self, events: &[Event], controller: &Controller) {
        for event in events {
            self.journal.see(event);
            match &event.kind {
                EventKind::Log { text, .. } => self.see_message(text, controller),
                EventKind::Error { code, .. } if self.expected == Some(*code) => {
                    self.expected = None;
                    self.is_decided = true;
                }
                _ => error_failure(event).into_iter().for_each(|failure| self.fail(failure)),
            }
        }
    }

    fn see_message(&mut self, text: &str, controller: &Controller) {
        if let Some(message) = after(text, FAILURE) {
            let places = self.lead.map(|lead| places(controller, lead)).unwrap_or_default();
            self.fail(failure(message, places));
        } else if let Some(code) = after(text, EXPECTATION) {
            self.expected = code.parse().ok();
        }
    }

    /// The first failure counts, and ends its program.
    fn fail(&mut self, failure: Failure) {
        self.failure.get_or_insert(failure);
        self.is_decided = true;
    }

    /// Starts the next program if the present one is over.
    pub fn follow(&mut self, controller: &mut Controller) -> Transition {
        let is_alive = self.lead.is_some_and(|lead| controller.vm.tasks().iter().any(|task| task.id == lead));
        if is_alive && !self.is_decided {
            return Transition::None;
        }
        if self.stage == Stage::Setup && self.failure.is_none() && self.enter(Stage::Test, controller) {
            return Transition::Started;
        }
        if let Some(code) = self.expected.take() {
            self.fail(failure(format!("error {code} was expected, and nothing has raised it"), Vec::new()));
        }
        controller.kill_tasks();
        if self.stage < Stage::Teardown && self.enter(Stage::Teardown, controller) {
            return Transition::Started;
        }
        self.stage = Stage::Over;
        Transition::Over
    }

    /// Starts the program of a stage. Returns whether there is one.
    fn enter(&mut self, stage: Stage, controller: &mut Controller) -> bool {
        let row = self.case.row.map(f64::from);
        let (program, numbers) = match stage {
            Stage::Setup => (SETUP, &[][..]),
            Stage::Test => (self.case.program.as_str(), row.as_slice()),
            Stage::Teardown | Stage::Over => (TEARDOWN, &[][..]),
        };
        match controller.start_with(program, numbers) {
            Ok(lead) => {
                (self.stage, self.lead, self.is_decided) = (stage, Some(lead), false);
                true
            }
            Err(NotStarted::NoProgram | NotStarted::HasParameters) if stage != Stage::Test => false,
            Err(reason) => {
                let failure = failure(refusal(program, reason), Vec::new());
                self.fail(failure);
                false
            }
        }
    }

    /// The result of a run that has ended. One that no task can continue has not ended by itself.
    #[must_use]
    pub fn result(self, controller: &Controller) -> TestResult {
        let places = self.lead.map(|lead| places(controller, lead)).unwrap_or_default();
        let unfinished = || failure("it has not ended".to_owned(), places);
        let failure = self.failure.or_else(|| (self.stage != Stage::Over).then(unfinished));
        let (prints, events) = self.journal.into_parts();
        let failures = failure.into_iter().collect();
        TestResult { failures, duration: controller.now(), prints, events, motion: None }
    }
}
