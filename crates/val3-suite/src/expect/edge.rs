//! Start of an occurrence.

use super::occurrence::{CycleState, Occurrence};

/// Detects when an occurrence starts.
#[derive(Debug)]
pub(super) struct Edge {
    occurrence: Option<Occurrence>,
    /// Whether the occurrence held in the previous cycle.
    held: bool,
}

impl Edge {
    /// Creates a detector; without an occurrence, nothing starts.
    pub(super) const fn new(occurrence: Option<Occurrence>) -> Self {
        Self { occurrence, held: false }
    }

    /// The occurrence.
    pub(super) const fn occurrence(&self) -> Option<&Occurrence> {
        self.occurrence.as_ref()
    }

    /// Time at which the occurrence starts in a cycle, in seconds.
    pub(super) fn rises(&mut self, cycle: CycleState<'_>) -> Option<f64> {
        let moment = self.occurrence.as_ref().and_then(|occurrence| occurrence.find(cycle, 0));
        let held = std::mem::replace(&mut self.held, moment.is_some());
        moment.filter(|_| !held).map(|moment| moment.time)
    }
}
