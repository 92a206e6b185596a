//! Occurrences within a time limit.

use std::ops::Range;

use serde::Deserialize;
use toml::Spanned;
use val3_machine::controller::Controller;
use val3_machine::event::seconds;
use val3_machine::script::Seconds;

use super::fit::{ExpectationFault, Fit};
use super::occurrence::{CycleState, Occurrence, OccurrenceTime};
use crate::failure::Failure;
use crate::source::ExpectationSource;

/// An `[[expect.within]]`: `event` happens at most `seconds` after `after`, or after the start.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Within {
    event: Occurrence,
    seconds: Seconds,
    after: Option<Occurrence>,
}

impl Within {
    /// Unknown names.
    pub(super) fn faults(&self, fit: &Fit<'_>, span: &Range<usize>) -> Vec<ExpectationFault> {
        self.occurrences().flat_map(|event| event.faults(fit, span)).collect()
    }

    pub(super) fn occurrences(&self) -> impl Iterator<Item = &Occurrence> {
        std::iter::once(&self.event).chain(&self.after)
    }

    /// Describes the time limit for messages.
    fn allowed(&self) -> String {
        let after = self.after.as_ref().map_or_else(|| "the start".to_owned(), |after| format!("\"{after}\""));
        format!("within {} s of {after}", self.seconds.seconds())
    }
}

/// The expectation during the execution.
pub(super) struct Deadline {
    within: Spanned<Within>,
    /// Start of the time limit, in seconds.
    begun: Option<f64>,
    happened: Option<f64>,
}

impl Deadline {
    pub(super) fn new(within: &Spanned<Within>) -> Self {
        let begun = within.get_ref().after.is_none().then_some(0.0);
        Self { within: within.clone(), begun, happened: None }
    }

    pub(super) fn see(&mut self, cycle: CycleState<'_>) {
        let mut seen = 0;
        let Within { event, after, .. } = self.within.get_ref();
        if let (None, Some(after)) = (self.begun, after) {
            let Some(OccurrenceTime { time, events }) = after.find(cycle, 0) else { return };
            (self.begun, seen) = (Some(time), events);
        }
        if self.happened.is_none() {
            self.happened = event.find(cycle, seen).map(|moment| moment.time);
        }
    }

    pub(super) fn failure(&self, controller: &Controller, source: &ExpectationSource) -> Option<Failure> {
        let Within { event, after, seconds: allowed } = self.within.get_ref();
        let expected = self.within.get_ref().allowed();
        let now = seconds(controller.now());
        let message = match (self.begun, self.happened) {
            (Some(begun), Some(happened)) if happened <= begun + allowed.seconds() => return None,
            (Some(begun), Some(happened)) => {
                format!(
                    "{event} only at {happened:.3} s, {:.3} s late; expected {expected}",
                    happened - begun - allowed.seconds()
                )
            }
            (Some(_), None) => {
                let instead = event.instead(controller).map(|state| format!("\n{state}")).unwrap_or_default();
                format!("until the end at {now} s it did not happen that {event}; expected {expected}{instead}")
            }
            (None, _) => {
                let after = after.as_ref().map(ToString::to_string).unwrap_or_default();
                format!("until the end at {now} s it did not happen that {after}, after which {event} was expected")
            }
        };
        Some(Failure { message, places: vec![source.place("expect.within", self.within.span())] })
    }
}
