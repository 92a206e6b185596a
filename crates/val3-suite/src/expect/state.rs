//! The state of the controller at the end of a test, or at a time before.

use serde::Deserialize;
use toml::Spanned;
use val3_lang::ports::Time;
use val3_machine::controller::Controller;
use val3_machine::script::Seconds;

use super::screen;
use crate::result::Failure;
use crate::source::Source;

/// The state that `[[expect.at]]` expects at a time.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct TimedState {
    t: Seconds,
    #[serde(default)]
    screen: Vec<Spanned<String>>,
}

/// The states that are expected at times, as far as they were judged.
pub(super) struct TimedStates<'s> {
    /// Those that were not judged, in the order of their times.
    open: Vec<&'s TimedState>,
    failures: Vec<Failure>,
}

impl TimedState {
    fn failures(&self, controller: &Controller, source: &Source) -> Vec<Failure> {
        screen::failures(&self.screen, "expect.at.screen", controller, source)
    }
}

impl<'s> TimedStates<'s> {
    pub(super) fn new(states: &'s [TimedState]) -> Self {
        let mut open: Vec<&TimedState> = states.iter().collect();
        open.sort_by_key(|state| state.t.time());
        Self { open, failures: Vec::new() }
    }

    /// The time of the next state. The run may not skip it.
    pub(super) fn next_due(&self) -> Option<Time> {
        self.open.first().map(|state| state.t.time())
    }

    /// Judges the states whose times have come at the end of a cycle.
    pub(super) fn see(&mut self, controller: &Controller, source: &Source) {
        let due = self.open.partition_point(|state| state.t.time() <= controller.now());
        for state in self.open.drain(..due) {
            self.failures.extend(state.failures(controller, source));
        }
    }

    /// All failures. After the end of the run, its last state does not change any more.
    pub(super) fn failures(&self, controller: &Controller, source: &Source) -> Vec<Failure> {
        let open = self.open.iter().flat_map(|state| state.failures(controller, source));
        self.failures.iter().cloned().chain(open).collect()
    }
}
