//! Smallest distance of a pair in each step. Pairs that are too far apart are not measured.

use crate::measure::{Measured, Reading};
use crate::pairs::Pair;
use crate::step::Step;

/// Tolerance of a smallest distance, in mm.
pub(crate) const EXACT: f64 = 0.1;

/// Last distance of a pair.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Track {
    /// Distance after the last step; `None` before the first step.
    last: Option<Known>,
}

#[derive(Debug, Clone, Copy)]
struct Known {
    /// The distance in mm, or its lower bound.
    at_least: f64,
    /// Whether the bound was measured at the end of the last step.
    is_measured: bool,
}

/// Limits of the requested distances, in mm.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Wanted {
    /// Only a smallest distance below this threshold is returned.
    pub(crate) threshold: f64,
    /// Between the ends of a step, distances that are less than this below the threshold are not searched.
    pub(crate) margin: f64,
    /// Distance up to which the distance at the end of the step is measured exactly.
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
    /// Returns a lower bound of the distance after the last step. Below the limit of [`Self::follow`], it is the
    /// distance itself.
    pub(crate) fn at_least(&self) -> f64 {
        self.last.map_or(0.0, |known| known.at_least)
    }

    /// Follows a pair through a step. Returns the smallest distance in the step if it is below the threshold.
    pub(crate) fn follow(&mut self, step: &Step<'_>, pair: &Pair, wanted: Wanted) -> Option<Found> {
        let travel = step.travel(pair);
        let before = self.last.filter(|_| travel.is_some());
        let way = travel.unwrap_or(f64::INFINITY);
        if let Some(known) = before.filter(|known| known.at_least - way > wanted.limit) {
            self.last = Some(Known { at_least: known.at_least - way, is_measured: false });
            return None;
        }
        // With this limit, the next steps at the same speed need no measurement.
        let far = wanted.limit + if way.is_finite() { 8.0 * way } else { 0.0 } + 5.0;
        let end = step.measure(pair, 1.0, far);
        self.last = Some(Known { at_least: end.at_least(), is_measured: true });
        let start = match before {
            Some(known) if known.is_measured => known.at_least,
            Some(_) => step.measure(pair, 0.0, far).at_least(),
            // First step, or a carrier was placed elsewhere.
            None => return Search::new(step, pair, 0.0, wanted).begin(end),
        };
        let mut search = Search::new(step, pair, way, wanted);
        search.take(end, 1.0);
        let start = StepDistance { fraction: 0.0, distance: start };
        search.divide(start, StepDistance { fraction: 1.0, distance: end.at_least() });
        search.found
    }
}

/// Search for the smallest distance within a step.
struct Search<'s> {
    step: &'s Step<'s>,
    pair: &'s Pair,
    /// Upper bound for the change of the distance over the entire step.
    way: f64,
    wanted: Wanted,
    /// Smallest distance so far; only smaller distances are recorded.
    best: f64,
    found: Option<Found>,
}

/// Distance at a fraction of the step.
#[derive(Clone, Copy)]
struct StepDistance {
    fraction: f64,
    /// The distance in mm, or a lower bound.
    distance: f64,
}

impl<'s> Search<'s> {
    fn new(step: &'s Step<'s>, pair: &'s Pair, way: f64, wanted: Wanted) -> Self {
        Self { step, pair, way, best: wanted.threshold, wanted, found: None }
    }

    /// Evaluates only the end of the step.
    fn begin(mut self, end: Reading) -> Option<Found> {
        self.take(end, 1.0);
        self.found
    }

    /// Records a distance that is smaller than all earlier distances.
    fn take(&mut self, reading: Reading, fraction: f64) {
        if let Reading::Measured(measured) = reading
            && measured.distance < self.best
        {
            self.best = measured.distance;
            self.found = Some(Found { measured, fraction });
        }
    }

    /// Searches between two distances, as long as the movement between them permits a smaller distance. A contact ends
    /// the search, so the depth of overlaps is exact only at the ends of steps.
    fn divide(&mut self, from: StepDistance, to: StepDistance) {
        let mut open = vec![(from, to)];
        while let Some((from, to)) = open.pop() {
            let way = self.way * (to.fraction - from.fraction);
            let least = (from.distance + to.distance - way) / 2.0;
            let margin = if self.found.is_some() { EXACT } else { self.wanted.margin };
            if way <= EXACT || least >= self.best - margin || self.best <= 0.0 {
                continue;
            }
            let fraction = (from.fraction + to.fraction) / 2.0;
            let reading = self.step.measure(self.pair, fraction, self.best.max(0.0) + way);
            self.take(reading, fraction);
            let middle = StepDistance { fraction, distance: reading.at_least() };
            open.push((middle, to));
            open.push((from, middle));
        }
    }
}
