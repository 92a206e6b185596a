//! The execution of a scenario: a whole application from its program `start` on, as `val3 run` executes it, in virtual time.

use toml::Spanned;
use val3_lang::ports::{TaskNumber, Time};
use val3_machine::controller::{Controller, Outcome};

use crate::execute::{TestSettings, wait};
use crate::expect::{Cycle, Observer};
use crate::journal::Journal;
use crate::killed::{killed, task_name};
use crate::result::{Failure, TestResult};
use crate::scenario::{START, Scenario};
use crate::stages::refusal;
use crate::unfinished::unfinished;

/// Runs the application of a scenario, and judges what is expected of it.
pub(crate) fn execute(controller: &mut Controller, scenario: &Scenario, settings: TestSettings) -> TestResult {
    let program = scenario.run.program.as_ref();
    let name = program.map_or(START, |program| program.get_ref().as_str());
    match controller.start(name) {
        Ok(task) => run(controller, task, scenario, settings),
        Err(reason) => {
            let place = scenario.source.place("program", program.map(Spanned::span).unwrap_or_default());
            let failure = Failure { message: refusal(name, reason), places: vec![place] };
            TestResult { failures: vec![failure], ..TestResult::default() }
        }
    }
}

fn run(controller: &mut Controller, task: TaskNumber, scenario: &Scenario, settings: TestSettings) -> TestResult {
    let until = scenario.run.until.as_ref().map(|until| until.get_ref().time());
    let name = task_name(controller, task).unwrap_or_default();
    let mut run = Run { controller, name, observer: scenario.observer(), journal: Journal::default(), killed: None };
    let outcome = run.cycles(until.unwrap_or(settings.limit));
    let Run { controller, observer, journal, killed, .. } = run;
    // An application may end itself so. Then its expectations decide.
    let killed = killed.filter(|_| scenario.expectations.is_empty());
    let has_ended = matches!(outcome, Outcome::Finished | Outcome::Stopped | Outcome::Lacking);
    let endless = (until.is_none() && !has_ended)
        .then(|| unfinished(controller, task, settings.limit, outcome == Outcome::Limit));
    let errors = observer.unexpected_errors().iter().cloned();
    let failures = killed.into_iter().chain(endless).chain(errors).chain(observer.failures(controller)).collect();
    let times_note = observer.times_note(controller);
    let motion = observer.into_motion();
    let (prints, events) = journal.into_parts();
    TestResult { failures, duration: controller.now(), prints, events, times_note, motion }
}

/// A run of an application.
struct Run<'c> {
    controller: &'c mut Controller,
    /// The name of its first task.
    name: String,
    observer: Observer,
    journal: Journal,
    /// The failure of its first task, if a program has killed it.
    killed: Option<Failure>,
}

impl Run<'_> {
    /// Executes cycles until the application ends, nothing can happen any more, or the clock has reached `end`. Returns
    /// the reason: [`Outcome::Stuck`] or [`Outcome::Limit`] if the application could not or did not end.
    fn cycles(&mut self, end: Time) -> Outcome {
        self.controller.set_limit(Some(end));
        loop {
            let start = self.controller.now();
            let outcome = self.controller.step();
            let is_over = outcome == Outcome::Limit || self.controller.now() >= end;
            if is_over {
                self.controller.break_off();
            }
            self.see(start);
            match outcome {
                Outcome::Finished | Outcome::Stopped | Outcome::Lacking => return outcome,
                _ if is_over => return Outcome::Limit,
                _ => {}
            }
            if !wait(self.controller, outcome, self.observer.next_due(), end) {
                return Outcome::Stuck;
            }
        }
    }

    fn see(&mut self, start: Time) {
        let events = self.controller.devices.take_events();
        self.observer.see(Cycle { start, events: &events, controller: self.controller });
        for event in &events {
            self.journal.see(event);
            self.killed = self.killed.take().or_else(|| killed(event, &self.name, self.controller));
        }
    }
}
