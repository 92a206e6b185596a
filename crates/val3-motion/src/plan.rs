//! Planner: sets the greatest permitted speed at each timeline point, and plans halts.
//!
//! Two passes as in TOPP-RA: the backward pass computes the greatest speed from which the rest of the path can be
//! followed, and the forward pass the greatest reachable speed below it. Points that the arm has passed never change.
//! If the acceleration ends or braking begins between two points, a point is inserted.

use crate::bounds::Bounds;
use crate::motion::MotionMode;
use crate::span::Span;
use crate::timeline::{Interval, TimedSpan, Timeline, TimelinePoint, UNPLANNED};

/// Distance below which two points are the same, as a fraction of the interval.
const SAME_POINT: f64 = 1e-6;

/// Point of the timeline: index of the span, and index of the point in the span.
pub(crate) type Index = (usize, usize);

impl Timeline {
    /// Appends a span. The arm enters the span without a stop unless the span begins from rest or is gated.
    pub(crate) fn append(&mut self, timed: TimedSpan, mode: MotionMode) {
        let was_at_end = self.is_at_end();
        let is_gated = mode == MotionMode::Step && self.begins_piece(&timed.span);
        let is_arm_on_path = self.spans.back().is_some_and(|last| !last.is_forgotten);
        self.spans.push_back(TimedSpan { is_gated, ..timed });
        // A waiting arm stays exactly at the end of the piece.
        if was_at_end && !(is_gated && is_arm_on_path) {
            self.spans.drain(..self.spans.len() - 1);
            (self.cursor, self.has_halt) = (Default::default(), false);
        }
        let unchanged = self.plan_backwards(self.commit());
        self.plan_forwards(unchanged);
    }

    /// First point with a fixed speed: the end of the current interval, or the point at which the arm halts.
    pub(crate) fn commit(&self) -> Index {
        let moving = usize::from(self.cursor.elapsed > 0.0 || self.rate() > 0.0);
        // Without a halt, the search would visit every point of the queue. Appending to 1,000 moves took 0.83 ms with
        // the search and 0.37 ms without.
        let halt = if self.has_halt { self.planned_halt() } else { None };
        halt.unwrap_or((0, self.cursor.point + moving))
    }

    /// First point of the queue at which the arm halts.
    fn planned_halt(&self) -> Option<Index> {
        self.spans.iter().enumerate().find_map(|(index, span)| Some((index, span.halt()?)))
    }

    /// Sets `most` from the end back to `commit` or to the first point whose value does not change. Returns this point.
    fn plan_backwards(&mut self, commit: Index) -> Index {
        let mut after: Option<(f64, bool)> = None;
        for index in (commit.0..self.spans.len()).rev() {
            let ratio = self.ratio(index);
            let Some(timed) = self.spans.get_mut(index) else { break };
            let end = match (after, ratio) {
                (Some((most, false)), Some(ratio)) => most / ratio,
                _ => 0.0,
            };
            let first = if index == commit.0 { commit.1 } else { 0 };
            if let Some(unchanged) = backwards(timed, first, end) {
                return (index, unchanged);
            }
            after = timed.points.first().map(|point| (point.most, timed.begins_at_rest()));
        }
        commit
    }

    /// Sets x from a point on. The x of this point itself is kept, unless its span begins there.
    fn plan_forwards(&mut self, (first, point): Index) {
        let mut x = self.spans.get(first).and_then(|timed| timed.points.get(point)).map_or(0.0, |point| point.x);
        for index in first..self.spans.len() {
            let ratio = index.checked_sub(1).and_then(|before| self.ratio(before));
            let Some(timed) = self.spans.get_mut(index) else { break };
            let start = if index == first { point } else { 0 };
            if index > first {
                x = if timed.begins_at_rest() { 0.0 } else { x * ratio.unwrap_or_default() };
            }
            x = forwards(timed, start, x);
        }
    }

    /// Halts the arm on its path. `braking` returns the smallest p̈ that the arm can reach at p and ṗ².
    ///
    /// `pace` is the arm's fraction of the planned speed. Speeds up to the halt are real speeds, independent of the
    /// monitor speed.
    pub(crate) fn halt(&mut self, pace: f64, braking: impl Fn(&Span, f64, f64) -> f64) {
        self.clear_halt();
        self.has_halt = true;
        self.split_at_cursor(pace);
        let mut next = Some((0, self.cursor.point));
        while let Some(index) = next {
            next = self.brake(index, &braking);
        }
        self.plan_forwards(self.commit());
    }

    /// Ends a halt, so that the arm continues.
    pub(crate) fn release(&mut self) {
        self.clear_halt();
        // The halt has inserted points without a planned speed.
        self.replan();
    }

    /// Plans all points again whose speed is not fixed.
    pub(crate) fn replan(&mut self) {
        self.spans.iter_mut().flat_map(|span| &mut span.points).for_each(|point| point.most = UNPLANNED);
        let commit = self.plan_backwards(self.commit());
        self.plan_forwards(commit);
    }

    fn clear_halt(&mut self) {
        self.spans.iter_mut().flat_map(|span| &mut span.points).for_each(|point| point.halt = false);
        self.has_halt = false;
    }

    /// Removes the path after a halt, so that only the braking remains.
    pub(crate) fn cut(&mut self) {
        let (index, point) = self.commit();
        self.spans.truncate(index + 1);
        if let Some(last) = self.spans.back_mut().filter(|last| last.points.iter().any(|point| point.halt)) {
            last.points.truncate(point + 1);
        }
    }

    /// Inserts a point at the current p, where the arm moves at the fraction `pace` of the planned speed.
    fn split_at_cursor(&mut self, pace: f64) {
        let (Some(p), rate) = (self.p(), self.rate()) else { return };
        let Some(front) = self.spans.front_mut() else { return };
        if self.cursor.elapsed > 0.0 {
            let most = front.points.get(self.cursor.point + 1).map_or(0.0, |point| point.most);
            self.cursor.point += 1;
            front.points.insert(self.cursor.point, TimelinePoint { p, x: rate * rate, most, halt: false });
            self.cursor.elapsed = 0.0;
        }
        if let Some(point) = front.points.get_mut(self.cursor.point) {
            point.x *= pace * pace;
        }
    }

    /// Brakes from one point to the next, and returns the next point; `None` when the arm is at rest.
    fn brake(&mut self, (index, at): Index, braking: impl Fn(&Span, f64, f64) -> f64) -> Option<Index> {
        let ratio = self.ratio(index);
        let timed = self.spans.get_mut(index)?;
        let Some(interval) = timed.interval(at) else {
            let last = timed.points.last_mut()?;
            last.halt = last.x == 0.0;
            let x = last.x * ratio?;
            self.spans.get_mut(index + 1)?.points.first_mut()?.x = x;
            return (x > 0.0).then_some((index + 1, 0));
        };
        if interval.from.x == 0.0 {
            halt_after(timed, at, 0.0);
            return None;
        }
        let lowest = braking(&timed.span, interval.from.p, interval.from.x);
        let x = interval.from.x + 2.0 * (interval.to.p - interval.from.p) * lowest;
        if x <= 0.0 {
            halt_after(timed, at, -interval.from.x / (2.0 * lowest));
            return None;
        }
        timed.points.get_mut(at + 1)?.x = x.min(interval.to.x);
        Some((index, at + 1))
    }
}

/// Halts the arm at the distance `way` after the point `at`, before the next point.
///
/// Another point is inserted halfway to the end of the interval, so that the arm can continue even if it also has to
/// rest at the end of the interval.
fn halt_after(timed: &mut TimedSpan, at: usize, way: f64) {
    let Some(Interval { from, to }) = timed.interval(at) else { return };
    let step = to.p - from.p;
    let halt = if way < step * SAME_POINT {
        at
    } else {
        let p = from.p + way.min(step * (1.0 - SAME_POINT));
        timed.points.insert(at + 1, TimelinePoint { p, ..to });
        at + 1
    };
    if let Some(point) = timed.points.get_mut(halt) {
        (point.x, point.halt) = (0.0, true);
        let p = (point.p + to.p) / 2.0;
        timed.points.insert(halt + 1, TimelinePoint { p, ..to });
    }
}

/// Sets `most` from the end of a span, where x may be up to `end`, back to the point `first`. Stops at a point whose
/// value does not change, because no earlier value changes either, and returns it.
fn backwards(timed: &mut TimedSpan, first: usize, end: f64) -> Option<usize> {
    let (limit, points) = timed.plan();
    let mut index = points.len().checked_sub(1)?;
    let mut most = end.min(limit.bounds(points, index)?.top());
    loop {
        let point = points.get_mut(index)?;
        if point.most == most {
            return Some(index);
        }
        point.most = most;
        index = index.checked_sub(1).filter(|index| *index >= first)?;
        let (interval, mut bounds) = (Interval::at(points, index)?, limit.bounds(points, index)?);
        let mut next = interval.to;
        if let Some(begin) = begin_of_braking(&interval, &bounds) {
            points.insert(index + 1, begin);
            (next, bounds) = (begin, limit.bounds(points, index)?);
        }
        most = bounds.controllable(next.p - interval.from.p, next.most);
    }
}

/// Sets x from the point `first` to the end of a span. Returns the x at the end.
fn forwards(timed: &mut TimedSpan, first: usize, start: f64) -> f64 {
    let (limit, points) = timed.plan();
    let (mut index, mut x) = (first, start);
    loop {
        if let Some(point) = points.get_mut(index) {
            point.x = x;
        }
        let (Some(interval), Some(bounds)) = (Interval::at(points, index), limit.bounds(points, index)) else {
            return x;
        };
        let Interval { from, to } = interval;
        x = match end_of_acceleration(&interval, &bounds) {
            Some(next) => {
                points.insert(index + 1, next);
                next.x
            }
            None => to.most.min(x + 2.0 * (to.p - from.p) * bounds.highest(x)).max(0.0),
        };
        if from.x == 0.0 && x == 0.0 {
            points.insert(index + 1, between_rests(&interval, &bounds));
            index += 1;
        }
        index += 1;
    }
}

/// Point at which the arm must begin to brake after a constant x, to be slow enough at the end of the interval.
fn begin_of_braking(Interval { from, to }: &Interval, bounds: &Bounds<'_>) -> Option<TimelinePoint> {
    let x = bounds.level();
    if to.most >= x {
        return None;
    }
    let lowest = bounds.lowest(x);
    let way = (to.most - x) / (2.0 * lowest);
    let is_inside = lowest < 0.0 && bounds.allows_constant(x) && is_between(way, to.p - from.p);
    is_inside.then_some(TimelinePoint { p: to.p - way, x, most: x, halt: false })
}

/// Point at which the acceleration ends, because a greater x would exceed the maximum at one end of the interval.
fn end_of_acceleration(Interval { from, to }: &Interval, bounds: &Bounds<'_>) -> Option<TimelinePoint> {
    let x = from.most.min(to.most);
    if x <= from.x {
        return None;
    }
    let highest = bounds.highest(from.x);
    let way = (x - from.x) / (2.0 * highest);
    let is_inside = highest > 0.0 && bounds.allows_constant(x) && is_between(way, to.p - from.p);
    is_inside.then_some(TimelinePoint { p: from.p + way, x, most: x, halt: false })
}

/// Middle point between two rests, with the greatest speed from rest to rest.
fn between_rests(Interval { from, to }: &Interval, bounds: &Bounds<'_>) -> TimelinePoint {
    let weaker = bounds.highest(0.0).min(-bounds.lowest(0.0));
    let x = bounds.level().min((to.p - from.p) * weaker);
    TimelinePoint { p: (from.p + to.p) / 2.0, x, most: x, halt: false }
}

/// Whether a distance ends strictly inside a step.
fn is_between(way: f64, step: f64) -> bool {
    way > step * SAME_POINT && way < step * (1.0 - SAME_POINT)
}
