//! Stages of a test: `setup`, the test program and `teardown`.
//!
//! The caller advances the controller: [`execute`](crate::execute()) in virtual time, a debugger line by line.

use val3_debug::{frames, row_of_data};
use val3_lang::ports::{TaskNumber, Time};
use val3_lang::runtime_errors::MOTION_FAULT;
use val3_lang::test_names::{SETUP, TEARDOWN};
use val3_machine::controller::{Controller, NotStarted};
use val3_machine::event::{Event, EventKind};

use crate::assertion::failed_assertion;
use crate::case::TestCase;
use crate::exemption::Exemption;
use crate::expect::{CycleState, Observer, error_failure, written_page};
use crate::expected_code::ExpectedCode;
use crate::failure::{Failure, FailureLocation};
use crate::golden_text::GoldenText;
use crate::journal::Journal;
use crate::killed::{killed, task_name, task_number};
use crate::library::{EXPECTATION, FAILURE, KNOWN_FAILURE, SKIP, after};
use crate::result::TestResult;
use crate::scenario::Scenario;
use crate::unfinished::{Conditions, Unfinished, is_stopped, places, places_of};

/// State of a test whose caller advances the controller.
pub struct Stages {
    /// Test.
    pub case: TestCase,
    stage: Stage,
    lead: Option<TaskNumber>,
    /// Name of the program's task.
    lead_name: Option<String>,
    failures: Vec<Failure>,
    /// Run-time error that the test expects.
    expected: Option<ExpectedCode>,
    /// Reason why the test skips itself.
    skipped: Option<String>,
    /// Reason with which the test states a known failure.
    known_failure: Option<String>,
    /// Whether the program's result is decided, although its task may not have ended.
    is_decided: bool,
    /// Whether the expected error was raised, which ends all tasks.
    is_raised: bool,
    observer: Observer,
    journal: Journal,
    /// Values of the test's row at its start.
    row: Vec<(String, String)>,
    /// Texts to compare with recorded texts.
    golden_texts: Vec<GoldenText>,
    /// User page at the first failure.
    page: Option<String>,
    /// Start and events of a cycle that was partly executed.
    part: Option<(Time, Vec<Event>)>,
}

/// Program in execution.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Stage {
    Setup,
    Test,
    Teardown,
    Over,
}

/// Result of [`Stages::follow`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Transition {
    /// The program continues.
    None,
    /// The next program has started.
    Started,
    /// The test has ended.
    Over,
}

impl Stages {
    /// Starts the first program of a test on a controller that has not executed anything, and that follows the script
    /// of `scenario`. A test that cannot be executed ends immediately.
    #[must_use]
    pub fn start(controller: &mut Controller, case: TestCase, scenario: &Scenario) -> Self {
        let mut stages = Self {
            case,
            stage: Stage::Setup,
            lead: None,
            lead_name: None,
            failures: Vec::new(),
            expected: None,
            skipped: None,
            known_failure: scenario.known_failure(),
            is_decided: false,
            is_raised: false,
            observer: scenario.observer(),
            journal: Journal::default(),
            row: Vec::new(),
            golden_texts: Vec::new(),
            page: None,
            part: None,
        };
        if let Some(refusal) = stages.case.refusal.clone() {
            let place =
                FailureLocation { program: stages.case.name(), file: stages.case.file.clone(), line: stages.case.line };
            stages.fail(failure(refusal, vec![place]));
            stages.stage = Stage::Over;
        } else if !stages.enter(Stage::Setup, controller) {
            stages.leave(controller);
        }
        stages
    }

    /// Whether all programs have been executed.
    pub(crate) fn is_over(&self) -> bool {
        self.stage == Stage::Over
    }

    /// Time of the next cycle that must not be skipped even if nothing happens.
    #[must_use]
    pub fn next_due(&self) -> Option<Time> {
        self.observer.next_due()
    }

    /// Adds events from a cycle, or a part of a cycle, that began at `start`. They are processed at the end of the
    /// cycle.
    pub fn see_part(&mut self, start: Time, events: &[Event], controller: &Controller) {
        // A debugger may have stepped back to a time before the cycle.
        let known = self.part.take().filter(|(begun, _)| *begun <= start);
        let (start, mut seen) = known.unwrap_or((start, Vec::new()));
        seen.extend_from_slice(events);
        if controller.is_within_cycle() {
            self.part = Some((start, seen));
        } else {
            self.see(CycleState { start, events: &seen, controller });
        }
    }

    /// Processes a finished cycle.
    pub(crate) fn see(&mut self, cycle: CycleState<'_>) {
        // Expectations are checked before `teardown`.
        if matches!(self.stage, Stage::Setup | Stage::Test) {
            self.observer.see(cycle);
        }
        for event in cycle.events {
            if self.is_decided {
                break;
            }
            self.journal.see(event);
            self.see_event(event, cycle.controller);
        }
    }

    fn see_event(&mut self, event: &Event, controller: &Controller) {
        match &event.kind {
            EventKind::Log { text, .. } if let Some(message) = after(text, FAILURE) => {
                self.fail(failed_assertion(message, self.task_of(event, controller), controller));
            }
            EventKind::Log { text, .. } if let Some(reason) = after(text, SKIP) => {
                self.skipped = Some(reason);
                self.is_decided = true;
            }
            EventKind::Log { text, .. } if let Some(reason) = after(text, KNOWN_FAILURE) => {
                self.known_failure = Some(reason);
            }
            EventKind::Log { text, .. } if let Some(code) = after(text, EXPECTATION) => {
                let task = self.task_of(event, controller);
                match code.parse() {
                    Ok(code) => self.expected = Some(ExpectedCode::new(code, &self.case, task, controller)),
                    Err(_) => {
                        let message = format!("`expectError` needs the number of a run-time error, not {code}");
                        self.fail(failed_assertion(message, task, controller));
                    }
                }
            }
            EventKind::Error { code, .. } if self.expects(*code) => {
                self.expected = None;
                (self.is_decided, self.is_raised) = (true, true);
            }
            // The error event follows.
            EventKind::Fault { .. } if self.expects(MOTION_FAULT) || self.observer.expects(event) => {}
            EventKind::Error { .. } if self.observer.expects(event) => {
                self.is_decided = self.lead.is_some_and(|lead| is_stopped(controller, lead));
            }
            _ => {
                let killed = self.lead_name.as_deref().and_then(|name| killed(event, name, controller));
                let raised = killed.or_else(|| self.raised(event, controller));
                raised.into_iter().for_each(|failure| self.fail(failure));
            }
        }
    }

    /// Whether the test expects this run-time error by `expectError`.
    fn expects(&self, code: u16) -> bool {
        self.expected.as_ref().is_some_and(|expected| expected.code == code)
    }

    /// Failure of a run-time error that may differ from the expected error.
    fn raised(&self, event: &Event, controller: &Controller) -> Option<Failure> {
        let failure = error_failure(event, &|task| places_of(controller, task))?;
        Some(match &self.expected {
            Some(expected) => expected.instead(failure),
            None => failure,
        })
    }

    /// An event's task, otherwise the program's task.
    fn task_of(&self, event: &Event, controller: &Controller) -> Option<TaskNumber> {
        event.task.as_deref().and_then(|name| task_number(controller, name)).or(self.lead)
    }

    /// Ends a program that does not end by itself.
    pub(crate) fn give_up(&mut self, controller: &mut Controller, unfinished: Unfinished, conditions: Conditions<'_>) {
        let failure = self.lead.map(|lead| unfinished.failure(controller, lead, conditions));
        failure.into_iter().for_each(|failure| self.fail(failure));
    }

    /// Records the first failure, which ends the program.
    fn fail(&mut self, failure: Failure) {
        if self.failures.is_empty() {
            self.failures.push(failure);
        }
        self.is_decided = true;
    }

    fn places(&self, controller: &Controller) -> Vec<FailureLocation> {
        self.lead.map(|lead| places(controller, lead)).unwrap_or_default()
    }

    /// Starts the next program if the current program has ended.
    pub fn follow(&mut self, controller: &mut Controller) -> Transition {
        let is_alive = self.lead.is_some_and(|lead| controller.vm.tasks().iter().any(|task| task.id == lead));
        if is_alive && !self.is_decided { Transition::None } else { self.leave(controller) }
    }

    /// Ends the current program, and starts the next one that exists. Tasks of `setup` continue during the test.
    /// `teardown` is executed regardless of the result.
    fn leave(&mut self, controller: &mut Controller) -> Transition {
        loop {
            let next = match self.stage {
                Stage::Setup if self.failures.is_empty() && self.skipped.is_none() => Stage::Test,
                Stage::Setup | Stage::Test => Stage::Teardown,
                Stage::Teardown | Stage::Over => Stage::Over,
            };
            if self.stage == Stage::Test {
                self.judge(controller);
            }
            self.page = self.page.take().or_else(|| written_page(controller, &self.failures));
            if next != Stage::Test || self.is_raised {
                controller.kill_tasks();
            }
            if next == Stage::Over {
                self.stage = Stage::Over;
                return Transition::Over;
            }
            if self.enter(next, controller) {
                return Transition::Started;
            }
        }
    }

    /// Checks the expectations at the end of the test.
    fn judge(&mut self, controller: &Controller) {
        if self.skipped.is_some() {
            return;
        }
        if let Some(expected) = self.expected.take() {
            self.fail(expected.missing());
        }
        self.failures.extend(self.observer.failures(controller));
        self.golden_texts = self.observer.golden_texts(controller);
    }

    /// Starts the program of a stage. Returns whether the application has this program, because `setup` and `teardown`
    /// are optional.
    fn enter(&mut self, stage: Stage, controller: &mut Controller) -> bool {
        let row = self.case.row.map(f64::from);
        let (program, numbers) = match stage {
            Stage::Setup => (SETUP, &[][..]),
            Stage::Test => (self.case.program.as_str(), row.as_slice()),
            Stage::Teardown | Stage::Over => (TEARDOWN, &[][..]),
        };
        let started = controller.start_with(program, numbers);
        (self.stage, self.lead) = (stage, started.as_ref().ok().copied());
        self.lead_name = self.lead.and_then(|lead| task_name(controller, lead));
        (self.is_decided, self.is_raised) = (false, false);
        if let (Stage::Test, Some(lead)) = (stage, self.lead) {
            self.row = row_values(controller, &self.case, lead);
        }
        let is_optional = stage != Stage::Test;
        match started {
            Ok(_) => {}
            Err(NotStarted::NoProgram) if is_optional => {}
            Err(reason) => self.fail(failure(refusal(program, reason), Vec::new())),
        }
        self.lead.is_some()
    }

    /// Result of a run that has ended. If no task can continue, the run has not ended by itself.
    #[must_use]
    pub fn result(mut self, controller: &Controller) -> TestResult {
        if let Some((start, events)) = self.part.take() {
            self.see(CycleState { start, events: &events, controller });
        }
        if !self.is_over() {
            let places = self.places(controller);
            self.fail(failure("it has not ended".to_owned(), places));
        }
        let (prints, events) = self.journal.into_parts();
        let times_note = self.observer.times_note(controller);
        let Self { failures, row, page, golden_texts, observer, skipped, known_failure, .. } = self;
        let motion = observer.into_motion().filter(|_| skipped.is_none());
        let exemption = skipped.filter(|_| failures.is_empty()).map(|reason| Exemption::Skipped { reason });
        let duration = controller.now();
        TestResult {
            failures,
            exemption,
            known_failure,
            duration,
            prints,
            events,
            row,
            page,
            times_note,
            golden_texts,
            picture: None,
            motion,
        }
    }
}

/// Values in the row of a test that has just started.
fn row_values(controller: &Controller, case: &TestCase, lead: TaskNumber) -> Vec<(String, String)> {
    let frames = frames(&controller.vm, lead);
    let (Some(row), Some(frame)) = (case.row, frames.first()) else { return Vec::new() };
    let value = |name: &String| Some((name.clone(), row_of_data(controller, frame.instance, name, row)?));
    case.columns.iter().filter_map(value).collect()
}

fn failure(message: String, places: Vec<FailureLocation>) -> Failure {
    Failure { message, places }
}

pub(crate) fn refusal(program: &str, reason: NotStarted) -> String {
    match reason {
        NotStarted::NoProgram => format!("there is no program `{program}`"),
        NotStarted::HasParameters => format!("`{program}` has parameters, so it cannot be called"),
        NotStarted::Fault(fault) => format!("`{program}` cannot be started: error {}", fault.0),
    }
}
