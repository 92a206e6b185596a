//! Expected state of the controller at the end of a test, or at an earlier time.

use std::fmt;

use serde::de::value::SeqAccessDeserializer;
use serde::de::{SeqAccess, Visitor};
use serde::{Deserialize, Deserializer};
use toml::Spanned;
use val3_lang::ports::Time;
use val3_machine::controller::Controller;
use val3_machine::script::Seconds;

use super::filled::NOTHING;
use super::fit::{ExpectationFault, Fit};
use super::places::ExpectedPlaces;
use super::values::ExpectedValues;
use super::{filled, places, screen, values};
use crate::failure::Failure;
use crate::source::ExpectationSource;

/// Common keys of `[expect]` and `[[expect.at]]`.
#[derive(Clone, Copy)]
pub(super) struct ExpectedState<'s> {
    /// Table that contains the keys.
    pub(super) table: &'static str,
    pub(super) screen: &'s [Spanned<String>],
    pub(super) io: &'s ExpectedValues,
    pub(super) data: &'s ExpectedValues,
    pub(super) seen: &'s ExpectedValues,
    pub(super) held: &'s ExpectedValues,
    pub(super) placed: &'s ExpectedPlaces,
}

impl ExpectedState<'_> {
    /// Whether nothing is expected.
    pub(super) fn is_empty(self) -> bool {
        let values = [self.io, self.data, self.seen, self.held];
        self.screen.is_empty() && values.iter().all(|values| values.is_empty()) && self.placed.is_empty()
    }

    /// Unknown names.
    pub(super) fn faults(self, fit: &Fit<'_>) -> Vec<ExpectationFault> {
        let values = [self.io, self.data, self.seen, self.held].into_iter().flat_map(|values| values.faults(fit));
        values.chain(self.placed.faults(fit)).collect()
    }

    /// Differences from the current state.
    pub(super) fn failures(self, controller: &Controller, source: &ExpectationSource) -> Vec<Failure> {
        let key = |key: &str| format!("{}.{key}", self.table);
        let screen = screen::failures(self.screen, &key("screen"), controller, source);
        let io = self.io.failures(&key("io"), controller, source);
        let data = self.data.failures(&key("data"), controller, source);
        let seen = self.seen.failures(&key("seen"), controller, source);
        let held = self.held.failures(&key("held"), controller, source);
        let placed = self.placed.failures(&key("placed"), controller, source);
        [screen, io, data, seen, held, placed].concat()
    }
}

/// An `[[expect.at]]`.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct TimedState {
    t: Spanned<Seconds>,
    #[serde(default, deserialize_with = "filled::page_texts")]
    screen: Vec<Spanned<String>>,
    #[serde(default, deserialize_with = "values::signals")]
    io: ExpectedValues,
    #[serde(default, deserialize_with = "values::variables")]
    data: ExpectedValues,
    #[serde(default, deserialize_with = "values::sensors")]
    seen: ExpectedValues,
    #[serde(default, deserialize_with = "values::parts")]
    held: ExpectedValues,
    #[serde(default, deserialize_with = "places::places")]
    placed: ExpectedPlaces,
}

/// Deserialises the states at times.
pub(super) fn timed<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec<TimedState>, D::Error> {
    deserializer.deserialize_any(TimedVisitor)
}

struct TimedVisitor;

impl<'de> Visitor<'de> for TimedVisitor {
    type Value = Vec<TimedState>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("tables `[[expect.at]]`, each with a time `t`; the places of parts are in `placed`")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, states: A) -> Result<Vec<TimedState>, A::Error> {
        filled::list(SeqAccessDeserializer::new(states))
    }
}

impl TimedState {
    fn time(&self) -> Time {
        self.t.get_ref().time()
    }

    fn state(&self) -> ExpectedState<'_> {
        let Self { screen, io, data, seen, held, placed, .. } = self;
        ExpectedState { table: "expect.at", screen, io, data, seen, held, placed }
    }

    /// Unknown names, a time after the end of the run, and a state without content.
    pub(super) fn faults(&self, fit: &Fit<'_>) -> Vec<ExpectationFault> {
        let late = fit.time(*self.t.get_ref(), &self.t.span());
        let empty = self.state().is_empty().then(|| (self.t.span(), NOTHING.to_owned()));
        late.into_iter().chain(empty).chain(self.state().faults(fit)).collect()
    }
}

/// Expected states with their times, and the failures so far.
pub(super) struct TimedStates {
    /// States that were not checked, sorted by time.
    open: Vec<TimedState>,
    failures: Vec<Failure>,
}

impl TimedStates {
    pub(super) fn new(states: &[TimedState]) -> Self {
        let mut open = states.to_vec();
        open.sort_by_key(TimedState::time);
        Self { open, failures: Vec::new() }
    }

    /// Time of the next state, which the run must not skip.
    pub(super) fn next_due(&self) -> Option<Time> {
        self.open.first().map(TimedState::time)
    }

    /// Checks the states that are due at the end of a cycle.
    pub(super) fn see(&mut self, controller: &Controller, source: &ExpectationSource) {
        let due = self.open.partition_point(|state| state.time() <= controller.now());
        for state in self.open.drain(..due) {
            self.failures.extend(state.state().failures(controller, source));
        }
    }

    /// All failures. States after the end of the run are compared with its last state.
    pub(super) fn failures(&self, controller: &Controller, source: &ExpectationSource) -> Vec<Failure> {
        let open = self.open.iter().flat_map(|state| state.state().failures(controller, source));
        self.failures.iter().cloned().chain(open).collect()
    }
}
