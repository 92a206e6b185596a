//! Executes scenarios: a complete application from its program `start`, as `val3 run` does, in virtual time.

use toml::Spanned;
use val3_lang::ports::{TaskNumber, Time};
use val3_machine::controller::{Controller, RunStatus};

use crate::execute::{Supervision, wait};
use crate::expect::{CycleState, Observer, written_page};
use crate::failure::Failure;
use crate::journal::Journal;
use crate::killed::{killed, task_name};
use crate::result::TestResult;
use crate::scenario::{START, Scenario};
use crate::stages::refusal;
use crate::unfinished::Unfinished;

/// Runs the application of a scenario and checks its expectations. `None` if the caller has ended the run.
pub(crate) fn execute(
    controller: &mut Controller,
    scenario: &Scenario,
    supervision: &mut Supervision<'_>,
) -> Option<TestResult> {
    let program = scenario.run.program.as_ref();
    let name = program.map_or(START, |program| program.get_ref().as_str());
    match controller.start(name) {
        Ok(task) => run(controller, task, scenario, supervision),
        Err(reason) => {
            let place = scenario.source.place("program", program.map(Spanned::span).unwrap_or_default());
            let failure = Failure { message: refusal(name, reason), places: vec![place] };
            Some(TestResult { failures: vec![failure], ..TestResult::default() })
        }
    }
}

fn run(
    controller: &mut Controller,
    task: TaskNumber,
    scenario: &Scenario,
    supervision: &mut Supervision<'_>,
) -> Option<TestResult> {
    let limit = supervision.settings.limit;
    let until = scenario.run.until.as_ref().map(|until| until.get_ref().time());
    let name = task_name(controller, task).unwrap_or_default();
    let mut run =
        ApplicationRun { controller, name, observer: scenario.observer(), journal: Journal::default(), killed: None };
    let status = run.cycles(until.unwrap_or(limit), supervision.may_go_on)?;
    let ApplicationRun { controller, observer, journal, killed, .. } = run;
    // An application may end itself in this way; then its expectations determine the result.
    let killed = killed.filter(|_| scenario.expectations.is_empty());
    let has_ended = matches!(status, RunStatus::Finished | RunStatus::Stopped | RunStatus::Unsupported);
    let endless = (until.is_none() && !has_ended)
        .then_some(Unfinished { limit, has_time: status == RunStatus::Limit })
        .map(|unfinished| unfinished.failure(controller, task, supervision.conditions));
    let errors = observer.unexpected_errors().iter().cloned();
    let failures: Vec<Failure> =
        killed.into_iter().chain(endless).chain(errors).chain(observer.failures(controller)).collect();
    let golden_texts = observer.golden_texts(controller);
    let times_note = observer.times_note(controller);
    let motion = observer.into_motion();
    let (prints, events) = journal.into_parts();
    let page = written_page(controller, &failures);
    let duration = controller.now();
    let known_failure = scenario.known_failure();
    Some(TestResult {
        failures,
        known_failure,
        duration,
        prints,
        events,
        page,
        times_note,
        golden_texts,
        motion,
        ..TestResult::default()
    })
}

/// An application run.
struct ApplicationRun<'c> {
    controller: &'c mut Controller,
    /// First task's name.
    name: String,
    observer: Observer,
    journal: Journal,
    /// Failure, if a program has killed the first task.
    killed: Option<Failure>,
}

impl ApplicationRun<'_> {
    /// Executes cycles until the application ends, nothing can happen any more, or the clock has reached `end`. Returns
    /// the reason: [`RunStatus::Stuck`] or [`RunStatus::Limit`] if the application could not or did not end; `None` if the
    /// caller has ended the run.
    fn cycles(&mut self, end: Time, may_go_on: &dyn Fn() -> bool) -> Option<RunStatus> {
        self.controller.set_limit(Some(end));
        loop {
            let start = self.controller.now();
            let status = self.controller.step();
            let is_over = status == RunStatus::Limit || self.controller.now() >= end;
            if is_over {
                self.controller.break_off();
            }
            self.see(start);
            match status {
                RunStatus::Finished | RunStatus::Stopped | RunStatus::Unsupported => return Some(status),
                _ if is_over => return Some(RunStatus::Limit),
                _ => {}
            }
            if !may_go_on() {
                return None;
            }
            if !wait(self.controller, status, self.observer.next_due(), end) {
                return Some(RunStatus::Stuck);
            }
        }
    }

    fn see(&mut self, start: Time) {
        let events = self.controller.devices.take_events();
        self.observer.see(CycleState { start, events: &events, controller: self.controller });
        for event in &events {
            self.journal.see(event);
            self.killed = self.killed.take().or_else(|| killed(event, &self.name, self.controller));
        }
    }
}
