//! Axes at equidistant knots of a path, as far as the arm can follow the path.

use super::SpanRequest;
use crate::fault::Cause;
use crate::model::{Axes, Model, full_turns};

/// Axis motion between two knots of the densest grid that counts as a jump, in degrees or mm.
const JUMP: f64 = 5.0;

/// Returns the axes at each knot, and the cause for which the arm cannot follow the path further.
pub(super) fn follow(
    model: &Model<'_>,
    request: &SpanRequest,
    step: f64,
    intervals: usize,
) -> (Vec<Axes>, Option<Cause>) {
    let mut knots = Vec::with_capacity(intervals + 1);
    let mut near = request.start;
    for index in 0..=intervals {
        let p = if index == intervals { request.range[1] } else { request.range[0] + step * index as f64 };
        match request.curve.axes(model, p, &near) {
            Ok(axes) => {
                near = axes;
                knots.push(axes);
            }
            Err(cause) => return (knots, Some(cause)),
        }
    }
    (knots, None)
}

/// Greatest axis motion between two knots, in degrees or mm.
pub(super) fn widest_of(pair: &[Axes]) -> f64 {
    if let [one, other] = pair { (other - one).amax() } else { 0.0 }
}

/// Removes the knots after the first jump, and returns its cause.
pub(super) fn without_jump(
    model: &Model<'_>,
    mut knots: Vec<Axes>,
    fault: Option<Cause>,
) -> (Vec<Axes>, Option<Cause>) {
    let jumps = |pair: &[Axes]| widest_of(pair) > JUMP;
    let Some(index) = knots.windows(2).position(jumps) else { return (knots, fault) };
    let after = knots.split_off(index + 1);
    let cause = knots.last().map_or(Cause::Singular, |before| cause_of_jump(model, before, &after));
    (knots, Some(cause))
}

/// Returns the cause of a jump. An axis at its limit jumps by a full turn, because only the other turn is in range. The
/// jump may occur before the limit: without the turn, one of the knots after the jump is beyond the limit.
fn cause_of_jump(model: &Model<'_>, before: &Axes, after: &[Axes]) -> Cause {
    let Some(first) = after.first() else { return Cause::Singular };
    let turns = full_turns(before, first);
    let is_turn = turns.amax() > 0.0 && (first - turns - before).amax() <= JUMP;
    let limit = after.iter().take_while(|_| is_turn).find_map(|axes| model.beyond_limit(&(axes - turns)));
    limit.unwrap_or(Cause::Singular)
}
