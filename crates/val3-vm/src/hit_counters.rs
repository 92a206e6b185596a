//! Hit counters of stop marks: hits at which tasks do not stop, counted within the turn.

use std::collections::BTreeMap;

/// Number of a hit counter.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct CounterId(pub u32);

/// Hit counters of stop marks, by number. A hit without a counter, or beyond its number, is a stop.
#[derive(Debug, Clone, Default)]
pub(crate) struct HitCounters(BTreeMap<CounterId, HitCounter>);

#[derive(Debug, Clone, Copy)]
struct HitCounter {
    /// Number of the next hits at which tasks do not stop.
    left: u64,
    /// Hits at which tasks have not stopped.
    passed: u64,
}

impl HitCounters {
    /// Starts counters with the numbers of hits at which tasks do not stop.
    pub(crate) fn new(passes: impl IntoIterator<Item = (CounterId, u64)>) -> Self {
        Self(passes.into_iter().map(|(id, left)| (id, HitCounter { left, passed: 0 })).collect())
    }

    /// Whether the next hit is only counted.
    pub(crate) fn has_pass(&self, id: CounterId) -> bool {
        self.0.get(&id).is_some_and(|counter| counter.left > 0)
    }

    /// Counts a hit at which the task does not stop.
    pub(crate) fn pass(&mut self, id: CounterId) {
        if let Some(counter) = self.0.get_mut(&id) {
            counter.left = counter.left.saturating_sub(1);
            counter.passed += 1;
        }
    }

    /// Returns the counted hits.
    pub(crate) fn passed(self) -> impl Iterator<Item = (CounterId, u64)> {
        self.0.into_iter().filter(|(_, counter)| counter.passed > 0).map(|(id, counter)| (id, counter.passed))
    }
}
