//! Occurrences in an order.

use serde::Deserialize;
use toml::Spanned;
use val3_machine::controller::Controller;
use val3_machine::event::shown_seconds;

use super::filled;
use super::fit::{ExpectationFault, Fit};
use super::occurrence::{CycleState, Occurrence};
use crate::failure::Failure;
use crate::source::ExpectationSource;

/// An `[[expect.order]]`: each event happens after the preceding event.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct EventOrder {
    #[serde(deserialize_with = "filled::list")]
    events: Vec<Spanned<Occurrence>>,
}

impl EventOrder {
    /// Unknown names.
    pub(super) fn faults(&self, fit: &Fit<'_>) -> Vec<ExpectationFault> {
        self.events.iter().flat_map(|event| event.get_ref().faults(fit, &event.span())).collect()
    }

    pub(super) fn occurrences(&self) -> impl Iterator<Item = &Occurrence> {
        self.events.iter().map(Spanned::get_ref)
    }
}

/// Progress in an order.
pub(super) struct OrderState {
    events: Vec<Spanned<Occurrence>>,
    /// Times of the events that have happened in order.
    times: Vec<f64>,
    /// For each event, the time at which it last happened before its turn.
    early: Vec<Option<f64>>,
}

impl OrderState {
    pub(super) fn new(order: &EventOrder) -> Self {
        Self { events: order.events.clone(), times: Vec::new(), early: vec![None; order.events.len()] }
    }

    pub(super) fn see(&mut self, cycle: CycleState<'_>) {
        let mut seen = 0;
        while let Some(next) = self.events.get(self.times.len()) {
            let Some(moment) = next.get_ref().find(cycle, seen) else { break };
            self.times.push(moment.time);
            seen = moment.events;
        }
        let later = self.events.iter().zip(&mut self.early).skip(self.times.len());
        for (event, early) in later {
            *early = event.get_ref().find(cycle, 0).map(|moment| moment.time).or(*early);
        }
    }

    pub(super) fn failure(&self, controller: &Controller, source: &ExpectationSource) -> Option<Failure> {
        let missing = self.events.get(self.times.len())?;
        let happened = self.events.iter().zip(&self.times);
        let happened = happened.map(|(event, time)| format!("\n{time:>9.3} s  {}", event.get_ref()));
        let open = self.events.iter().zip(&self.early).skip(self.times.len()).map(|(event, early)| {
            let early = early.map(|time| format!(" (before its turn at {time:.3} s)")).unwrap_or_default();
            format!("\n    missing  {}{early}", event.get_ref())
        });
        let listed: String = happened.chain(open).collect();
        let message = format!("not in this order until the end at {} s:{listed}", shown_seconds(controller.now()));
        Some(Failure { message, places: vec![source.place("expect.order", missing.span())] })
    }
}
