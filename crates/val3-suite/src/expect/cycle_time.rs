//! `[[expect.time]]`: maximum time between two occurrences, or for the entire test.

use std::ops::Range;

use serde::Deserialize;
use toml::Spanned;
use val3_lang::ports::nanoseconds;
use val3_machine::controller::Controller;
use val3_machine::event::seconds;
use val3_trace::Positive;

use super::edge::Edge;
use super::fit::{ExpectationFault, Fit};
use super::occurrence::{CycleState, Occurrence};
use crate::failure::Failure;
use crate::source::ExpectationSource;

/// Maximum time of a cycle:
///
/// ```toml
/// [[expect.time]]
/// below = 12.5                     # seconds of the controller's clock, at most
/// from = { move = "pick" }         # else from the start of the test
/// to = { data = { nBoxes = 2 } }   # else to its end
///
/// [[expect.time]]
/// below = 12.5
/// cycle = { move = "pick:12" }     # from each start of the move to the next one
/// ```
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct CycleTime {
    below: Positive,
    from: Option<Occurrence>,
    to: Option<Occurrence>,
    cycle: Option<Occurrence>,
}

impl CycleTime {
    /// Unknown names.
    pub(super) fn faults(&self, fit: &Fit<'_>, span: &Range<usize>) -> Vec<ExpectationFault> {
        let names = self.occurrences().flat_map(|event| event.faults(fit, span));
        names.chain(self.surplus().map(|fault| (span.clone(), fault))).collect()
    }

    /// Fault if there is a beginning or an end in addition to the event of a cycle.
    fn surplus(&self) -> Option<String> {
        let has_other = self.from.is_some() || self.to.is_some();
        (self.cycle.is_some() && has_other)
            .then(|| "`cycle` is both `from` and `to`: delete them or `cycle`".to_owned())
    }

    pub(super) fn occurrences(&self) -> impl Iterator<Item = &Occurrence> {
        self.from.iter().chain(&self.to).chain(&self.cycle)
    }
}

/// Measures the times between the starts of an occurrence and the next start of the end occurrence.
pub(super) struct Stopwatch {
    expected: Spanned<CycleTime>,
    from: Edge,
    to: Edge,
    /// Start of the current measurement, in seconds.
    begun: Option<f64>,
    /// Start and end of the longest measurement.
    longest: Option<[f64; 2]>,
}

impl Stopwatch {
    pub(super) fn new(expected: &Spanned<CycleTime>) -> Self {
        let CycleTime { from, to, cycle, .. } = expected.get_ref().clone();
        let (from, to) = (from.or_else(|| cycle.clone()), to.or(cycle));
        let begun = from.is_none().then_some(0.0);
        Self { expected: expected.clone(), from: Edge::new(from), to: Edge::new(to), begun, longest: None }
    }

    pub(super) fn see(&mut self, cycle: CycleState<'_>) {
        if let Some(end) = self.to.rises(cycle) {
            self.end(end);
        }
        if let Some(begin) = self.from.rises(cycle) {
            self.begun.get_or_insert(begin);
        }
    }

    /// Ends the current measurement.
    fn end(&mut self, end: f64) {
        let Some(begun) = self.begun.take() else { return };
        let longest = self.longest.filter(|[from, to]| to - from >= end - begun);
        self.longest = longest.or(Some([begun, end]));
    }

    pub(super) fn failure(&self, controller: &Controller, source: &ExpectationSource) -> Option<Failure> {
        let message = self.message(controller)?;
        Some(Failure { message, places: vec![source.place("expect.time", self.expected.span())] })
    }

    fn message(&self, controller: &Controller) -> Option<String> {
        let now = seconds(controller.now());
        let [from, to] = match (self.longest, self.begun, self.to.occurrence()) {
            (Some(longest), ..) => longest,
            (None, Some(begun), None) => [begun, now],
            (None, Some(begun), Some(to)) => return Some(format!("since {begun:.3} s {}", never(to, controller))),
            (None, None, _) => return self.from.occurrence().map(|from| never(from, controller)),
        };
        let (took, below) = (to - from, self.expected.get_ref().below.0);
        let is_slow = nanoseconds(took) > nanoseconds(below);
        is_slow
            .then(|| format!("the cycle takes {took:.3} s instead of at most {below} s, from {from:.3} s to {to:.3} s"))
    }
}

/// Message for a measurement that has never started or ended.
fn never(occurrence: &Occurrence, controller: &Controller) -> String {
    let instead = occurrence.instead(controller).map(|state| format!("\n{state}")).unwrap_or_default();
    format!("it did not happen that {occurrence}{instead}")
}
