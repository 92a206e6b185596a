//! `[expect]`: what a test expects of the controller.
//!
//! ```toml
//! [expect]
//! screen = ["Palletiser", "2 boxes"]               # the page that is shown at the end contains these texts
//! print = ["done"]                                 # a line that `?` has printed contains it; `log`, `popup` likewise
//! errors = [{ code = 20, task = "production" }]    # run-time errors; any other is a failure
//!
//! [[expect.at]]                                    # the state at a time
//! t = 5
//! screen = ["1 box"]
//! ```
//!
//! Each family of expectations is a file. It has the keys of the file as plain data, and where it looks at the run, a type
//! that sees each cycle and gives its failures at the end.

mod errors;
mod output;
mod screen;
mod state;

use serde::Deserialize;
use toml::Spanned;
use val3_lang::ports::Time;
use val3_machine::controller::Controller;
use val3_machine::event::Event;

use crate::result::Failure;
use crate::scenario::Scenario;
pub(crate) use errors::failure as error_failure;
use errors::{Errors, ExpectedError};
use output::{Output, OutputKind};
use state::{TimedState, TimedStates};

/// The keys of `[expect]`.
#[derive(Debug, Clone, Default, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub(crate) struct Expectations {
    screen: Vec<Spanned<String>>,
    print: Vec<Spanned<String>>,
    log: Vec<Spanned<String>>,
    popup: Vec<Spanned<String>>,
    errors: Vec<Spanned<ExpectedError>>,
    at: Vec<TimedState>,
}

/// The end of a cycle, as expectations see it.
#[derive(Clone, Copy)]
pub(crate) struct Cycle<'c> {
    /// The events of the cycle.
    pub(crate) events: &'c [Event],
    /// The controller at its end.
    pub(crate) controller: &'c Controller,
}

/// The expectations of a test while it is executed.
pub(crate) struct Observer<'s> {
    scenario: &'s Scenario,
    outputs: Vec<Output<'s>>,
    errors: Errors<'s>,
    states: TimedStates<'s>,
}

impl<'s> Observer<'s> {
    pub(crate) fn new(scenario: &'s Scenario) -> Self {
        let Expectations { print, log, popup, errors, at, .. } = &scenario.expectations;
        let outputs = [(OutputKind::Print, print), (OutputKind::Log, log), (OutputKind::Popup, popup)];
        Self {
            scenario,
            outputs: outputs.into_iter().map(|(kind, texts)| Output::new(kind, texts)).collect(),
            errors: Errors::new(errors),
            states: TimedStates::new(at),
        }
    }

    /// Looks at a cycle that is over.
    pub(crate) fn see(&mut self, cycle: Cycle<'_>) {
        self.outputs.iter_mut().for_each(|output| output.see(cycle.events));
        self.errors.see(cycle.events);
        self.states.see(cycle.controller, &self.scenario.source);
    }

    /// The time of the next cycle that has to be seen even if nothing happens.
    pub(crate) fn next_due(&self) -> Option<Time> {
        self.states.next_due()
    }

    /// Whether the run-time error of an event is one of those that are expected.
    pub(crate) fn expects(&self, event: &Event) -> bool {
        self.errors.expects(event)
    }

    /// The expectations that are not met, at the end of the test.
    pub(crate) fn failures(&self, controller: &Controller) -> Vec<Failure> {
        let source = &self.scenario.source;
        let mut failures = self.errors.failures(source);
        failures.extend(self.outputs.iter().flat_map(|output| output.failures(source)));
        failures.extend(self.states.failures(controller, source));
        failures.extend(screen::failures(&self.scenario.expectations.screen, "expect.screen", controller, source));
        failures
    }
}
