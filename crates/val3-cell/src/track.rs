//! Smallest distance of a pair in each step. Far pairs are not measured.

use crate::measure::{Measured, Reading};
use crate::pairs::Pair;
use crate::step::Step;

/// Exactness of a smallest distance, in mm.
pub(crate) const EXACT: f64 = 0.1;

/// Last known distance of a pair.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Track {
    /// The distance after the last step; `None` before the first.
    last: Option<Known>,
}

#[derive(Debug, Clone, Copy)]
struct Known {
    /// The distance, or a lower bound of it.
    at_least: f64,
    /// Whether the bound comes from a measurement at the end of the last step.
    is_measured: bool,
}

/// Limits of the requested distances.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Wanted {
    /// The smallest distance of the step is wanted if it is below this one.
    pub(crate) threshold: f64,
    /// A distance by which a smaller one differs at least, to be wanted.
    pub(crate) margin: f64,
    /// The distance at the end of the step is wanted up to this one.
    pub(crate) limit: f64,
}

/// A distance within a step.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Found {
    pub(crate) measured: Measured,
    /// Fraction of the step, 0 to 1.
    pub(crate) fraction: f64,
}

impl Track {
    /// A lower bound of the distance after the last step; the distance itself if it is below the limit of
    /// [`Self::follow`].
    pub(crate) fn at_least(&self) -> f64 {
        self.last.map_or(0.0, |known| known.at_least)
    }

    /// Follows a pair through a step. Returns its smallest distance in the step if it is wanted.
    pub(crate) fn follow(&mut self, step: &Step<'_>, pair: &Pair, wanted: Wanted) -> Option<Found> {
        let travel = step.travel(pair);
        let before = self.last.filter(|_| travel.is_some());
        let way = travel.unwrap_or(f64::INFINITY);
        if let Some(known) = before.filter(|known| known.at_least - way > wanted.limit) {
            self.last = Some(Known { at_least: known.at_least - way, is_measured: false });
            return None;
        }
        // Far enough that the next steps of the same speed need no measurement.
        let far = wanted.limit + if way.is_finite() { 8.0 * way } else { 0.0 } + 5.0;
        let end = step.measure(pair, 1.0, far);
        self.last = Some(Known { at_least: end.at_least(), is_measured: true });
        let start = match before {
            Some(known) if known.is_measured => known.at_least,
            Some(_) => step.measure(pair, 0.0, far).at_least(),
            // The first look, or a carrier that has been placed elsewhere.
            None => return Search::new(step, pair, 0.0, wanted).begin(end),
        };
        let mut search = Search::new(step, pair, way, wanted);
        search.take(end, 1.0);
        search.divide((0.0, start), (1.0, end.at_least()));
        search.found
    }
}

/// The search for the smallest distance within a step.
struct Search<'s> {
    step: &'s Step<'s>,
    pair: &'s Pair,
    /// Greatest change of the distance over the whole step.
    way: f64,
    wanted: Wanted,
    /// Only smaller distances count.
    best: f64,
    found: Option<Found>,
}

impl<'s> Search<'s> {
    fn new(step: &'s Step<'s>, pair: &'s Pair, way: f64, wanted: Wanted) -> Self {
        Self { step, pair, way, best: wanted.threshold, wanted, found: None }
    }

    fn begin(mut self, end: Reading) -> Option<Found> {
        self.take(end, 1.0);
        self.found
    }

    fn take(&mut self, reading: Reading, fraction: f64) {
        if let Reading::Measured(measured) = reading
            && measured.distance < self.best
        {
            self.best = measured.distance;
            self.found = Some(Found { measured, fraction });
        }
    }

    /// Searches between two fractions with known distances, as long as the way between them permits a smaller one. The
    /// depth of an overlap is known only at the ends of steps.
    fn divide(&mut self, from: (f64, f64), to: (f64, f64)) {
        let mut open = vec![(from, to)];
        while let Some((from, to)) = open.pop() {
            let way = self.way * (to.0 - from.0);
            let least = (from.1 + to.1 - way) / 2.0;
            let margin = if self.found.is_some() { EXACT } else { self.wanted.margin };
            if way <= EXACT || least >= self.best - margin || self.best <= 0.0 {
                continue;
            }
            let fraction = (from.0 + to.0) / 2.0;
            let reading = self.step.measure(self.pair, fraction, self.best.max(0.0) + way);
            self.take(reading, fraction);
            let middle = (fraction, reading.at_least());
            open.push((middle, to));
            open.push((from, middle));
        }
    }
}
