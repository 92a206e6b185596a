//! Division of a path into spans, each with the knot density that this part of the path requires.

use std::ops::RangeInclusive;

use val3_moves::Manner;

use super::follow::{follow, widest_of, without_jump};
use super::knots::{LEAST_KNOTS, LimitedKnots};
use super::{Curve, Span, SpanRequest};
use crate::fault::Cause;
use crate::model::{Axes, Model};

/// Minimum number of intervals between the knots of a nominal path.
const INTERVALS: usize = 32;

/// Minimum number of intervals between the knots of a blend, which bends more.
const BLEND_INTERVALS: usize = 64;

/// Maximum number of intervals between knots.
const MOST_INTERVALS: usize = 1600;

/// Multiple of the minimum number of intervals from which a path is divided if only a part requires more knots.
const DIVIDED: usize = 4;

/// Minimum p range for parts of a path.
const LEAST_RANGE: f64 = 1e-4;

/// Axis motion between two knots above which more knots are necessary, in degrees or mm.
const FINE: f64 = 1.0;

/// Minimum distance of knots that are inserted because of accelerations, in degrees or mm. Rounding errors would
/// dominate the derivatives of nearer knots.
const FINEST: f64 = 1e-3;

/// Spans of a path, as far as the arm can follow the path.
#[derive(Debug, Default)]
pub(crate) struct Pieces {
    /// Consecutive spans; empty if the arm cannot follow even the start.
    pub(crate) spans: Vec<Span>,
    /// Cause for which the arm cannot follow the path further.
    pub(crate) fault: Option<Cause>,
}

impl Pieces {
    /// Divides a path into spans.
    pub(crate) fn of(model: &Model<'_>, request: SpanRequest) -> Self {
        let mut pieces = Self::default();
        pieces.fault = pieces.add(model, request);
        pieces
    }

    /// Adds the spans of a path. Returns the cause for which the arm cannot follow the path to its end.
    fn add(&mut self, model: &Model<'_>, request: SpanRequest) -> Option<Cause> {
        let [from, to] = request.range;
        let least = least_intervals(&request.curve);
        let mut intervals = least;
        loop {
            let step = (to - from) / intervals as f64;
            let (knots, fault) = follow(model, &request, step, intervals);
            let widest = knots.windows(2).map(widest_of).fold(0.0, f64::max);
            let wanted = if fault.is_some() { MOST_INTERVALS } else { intervals * (widest / FINE).ceil() as usize };
            if wanted > intervals && intervals < MOST_INTERVALS {
                intervals = wanted.min(MOST_INTERVALS);
                continue;
            }
            let (knots, fault) = without_jump(model, knots, fault);
            let is_finest = widest <= FINEST;
            if fault.is_some() {
                let limited = up_to_fine_end(model, &request, step, knots, is_finest);
                self.spans.extend(limited.map(|limited| Span::new(request, step, limited)));
                return fault;
            }
            let limited = LimitedKnots::new(model, &request, step, knots)?;
            let Some(coarse) = limited.coarse_range().filter(|_| !is_finest) else {
                self.spans.push(Span::new(request, step, limited));
                return None;
            };
            let is_divided = intervals >= DIVIDED * least && can_be_divided(&request);
            match cuts(&coarse, intervals).filter(|_| is_divided) {
                Some(cuts) => return self.add_parts(model, &request, &limited.knots, &cuts),
                None if intervals == MOST_INTERVALS => {
                    self.spans.push(Span::new(request, step, limited));
                    return None;
                }
                None => intervals = (2 * intervals).min(MOST_INTERVALS),
            }
        }
    }

    /// Adds the parts of a path between the knots in `cuts`.
    fn add_parts(&mut self, model: &Model<'_>, request: &SpanRequest, knots: &[Axes], cuts: &[usize]) -> Option<Cause> {
        let [from, to] = request.range;
        let last = knots.len() - 1;
        let p = |knot: usize| if knot == last { to } else { from + (to - from) / last as f64 * knot as f64 };
        cuts.windows(2).find_map(|cut| {
            let &[first, second] = cut else { return None };
            let start = knots.get(first).copied().unwrap_or(request.start);
            self.add(model, SpanRequest { range: [p(first), p(second)], start, ..request.clone() })
        })
    }
}

fn least_intervals(curve: &Curve) -> usize {
    match curve {
        Curve::Nominal(_) => INTERVALS,
        Curve::Blend(_) => BLEND_INTERVALS,
    }
}

/// Whether a path can be divided. A compliant move is one span, because it follows no plan.
fn can_be_divided(request: &SpanRequest) -> bool {
    let [from, to] = request.range;
    to - from > LEAST_RANGE && !matches!(request.manner, Manner::Compliant(_))
}

/// Knots at which a path is divided to separate its coarse part, both ends included; `None` if this part is more than
/// half of the path.
fn cuts(coarse: &RangeInclusive<usize>, intervals: usize) -> Option<Vec<usize>> {
    let (first, last) = (*coarse.start(), *coarse.end());
    let margin = LEAST_KNOTS.max((last - first) / 2);
    let from = first.saturating_sub(margin);
    let to = (last + margin).min(intervals);
    let from = if from < LEAST_KNOTS { 0 } else { from };
    let to = if intervals - to < LEAST_KNOTS { intervals } else { to };
    let mut cuts = vec![0, from, to, intervals];
    cuts.dedup();
    (2 * (to - from) <= intervals).then_some(cuts)
}

/// Knots up to a fault, without the coarse knots at the end, before which the arm comes to rest. Next to a singular
/// position, no knot density suffices.
fn up_to_fine_end(
    model: &Model<'_>,
    request: &SpanRequest,
    step: f64,
    mut knots: Vec<Axes>,
    is_finest: bool,
) -> Option<LimitedKnots> {
    loop {
        let limited = LimitedKnots::new(model, request, step, knots)?;
        let fine = limited.fine_len();
        if is_finest || fine == limited.knots.len() || fine < LEAST_KNOTS {
            return Some(limited);
        }
        knots = limited.knots;
        knots.truncate(fine);
    }
}

#[cfg(test)]
mod tests {
    use super::cuts;

    #[test]
    fn a_path_is_divided_around_its_coarse_part() {
        assert_eq!(cuts(&(0..=3), 256), Some(vec![0, 10, 256]));
        assert_eq!(cuts(&(250..=256), 256), Some(vec![0, 243, 256]));
        assert_eq!(cuts(&(100..=140), 256), Some(vec![0, 80, 160, 256]));
        assert_eq!(cuts(&(0..=256), 256), None);
    }
}
