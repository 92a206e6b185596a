//! The planner: gives the points of a timeline the greatest speeds that the limits allow, and brings the arm to rest.
//!
//! Two passes as in TOPP-RA: backwards the greatest speed from which the rest of the path can be followed, then forwards
//! the greatest speed that is below it. Points that the arm has already passed never change.

use std::sync::Arc;

use crate::span::Span;
use crate::timeline::{Interval, Point, TimedSpan, Timeline};

/// Points nearer than this share of their interval are one.
const SAME_POINT: f64 = 1e-6;

/// A point of the timeline: number of the span and of the point in it.
type Index = (usize, usize);

impl Timeline {
    /// Adds a span at the end, which the arm reaches without a stop unless it begins `from_rest`.
    pub(crate) fn append(&mut self, span: Arc<Span>, from_rest: bool) {
        let was_at_end = self.is_at_end();
        self.spans.push_back(TimedSpan::new(span, from_rest));
        if was_at_end {
            self.spans.drain(..self.spans.len() - 1);
            self.cursor = Default::default();
        }
        let commit = self.commit();
        let changed = self.plan_backwards(commit, true);
        self.plan_forwards(changed);
    }

    /// The first point whose speed may not change: the end of the interval that is executed, or where the arm halts.
    fn commit(&self) -> Index {
        let halt = |(index, span): (usize, &TimedSpan)| {
            span.points.iter().position(|point| point.halt).map(|point| (index, point))
        };
        let moving = usize::from(self.cursor.elapsed > 0.0 || self.rate() > 0.0);
        self.spans.iter().enumerate().find_map(halt).unwrap_or((0, self.cursor.point + moving))
    }

    /// Sets `most` from the end back to `commit`, or back to the first span that does not change any more if
    /// `changes_only`. Returns where it has stopped.
    fn plan_backwards(&mut self, commit: Index, changes_only: bool) -> Index {
        let mut after: Option<(f64, bool)> = None;
        for index in (commit.0..self.spans.len()).rev() {
            let ratio = self.ratio(index);
            let Some(timed) = self.spans.get_mut(index) else { break };
            let end = match (after, ratio) {
                (Some((most, false)), Some(ratio)) => most / ratio,
                _ => 0.0,
            };
            let first = if index == commit.0 { commit.1 } else { 0 };
            let unchanged = backwards(timed, first, end);
            if unchanged && changes_only {
                return (index, first).max(commit);
            }
            after = timed.points.first().map(|point| (point.most, timed.from_rest));
        }
        commit
    }

    /// Sets x from a point on, whose own x is kept unless the span begins there.
    fn plan_forwards(&mut self, (first, point): Index) {
        let mut x = self.spans.get(first).and_then(|timed| timed.points.get(point)).map_or(0.0, |point| point.x);
        for index in first..self.spans.len() {
            let ratio = index.checked_sub(1).and_then(|before| self.ratio(before));
            let Some(timed) = self.spans.get_mut(index) else { break };
            let start = if index == first { point } else { 0 };
            if index > first {
                x = if timed.from_rest { 0.0 } else { x * ratio.unwrap_or_default() };
            }
            x = forwards(timed, start, x);
        }
    }

    /// Brings the arm to rest on its path. `braking` gives the smallest p̈ that the arm can do at p and ṗ².
    ///
    /// `pace` is the share of the planned speed at which the arm moves. From here to the halt, speeds are real ones.
    pub(crate) fn halt(&mut self, pace: f64, braking: impl Fn(&Span, f64, f64) -> f64) {
        self.spans.iter_mut().flat_map(|span| &mut span.points).for_each(|point| point.halt = false);
        self.split_at_cursor(pace);
        let mut next = Some((0, self.cursor.point));
        while let Some(index) = next {
            next = self.brake(index, &braking);
        }
        self.plan_forwards(self.commit());
    }

    /// Lets the arm continue after a halt.
    pub(crate) fn release(&mut self) {
        self.spans.iter_mut().flat_map(|span| &mut span.points).for_each(|point| point.halt = false);
        // The halt has added points that have no speed yet.
        let commit = self.commit();
        self.plan_backwards(commit, false);
        self.plan_forwards(commit);
    }

    /// Removes the path after a halt, so that the rest of the timeline is the braking.
    pub(crate) fn cut(&mut self) {
        let (index, point) = self.commit();
        self.spans.truncate(index + 1);
        if let Some(last) = self.spans.back_mut().filter(|last| last.points.iter().any(|point| point.halt)) {
            last.points.truncate(point + 1);
        }
    }

    /// Makes the present p a point at which the arm moves at a share of its planned speed.
    fn split_at_cursor(&mut self, pace: f64) {
        let (Some(p), rate) = (self.p(), self.rate()) else { return };
        let Some(front) = self.spans.front_mut() else { return };
        if self.cursor.elapsed > 0.0 {
            let most = front.points.get(self.cursor.point + 1).map_or(0.0, |point| point.most);
            self.cursor.point += 1;
            front.points.insert(self.cursor.point, Point { p, x: rate * rate, most, halt: false });
            self.cursor.elapsed = 0.0;
        }
        if let Some(point) = front.points.get_mut(self.cursor.point) {
            point.x *= pace * pace;
        }
    }

    /// Brakes from one point to the next. None once the arm is at rest.
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

/// Halts the arm `way` after the point `at`, before the next one.
///
/// A point follows the halt in the middle of the rest of the interval, so that the arm can move on from there even if
/// it has to rest at the end of the interval too.
fn halt_after(timed: &mut TimedSpan, at: usize, way: f64) {
    let Some(Interval { from, to }) = timed.interval(at) else { return };
    let step = to.p - from.p;
    let halt = if way < step * SAME_POINT {
        at
    } else {
        let p = from.p + way.min(step * (1.0 - SAME_POINT));
        timed.points.insert(at + 1, Point { p, ..to });
        at + 1
    };
    if let Some(point) = timed.points.get_mut(halt) {
        (point.x, point.halt) = (0.0, true);
        let p = (point.p + to.p) / 2.0;
        timed.points.insert(halt + 1, Point { p, ..to });
    }
}

/// Sets `most` from the end of a span, where `end` is possible for x, back to the point `first`.
///
/// Returns whether `most` of its first point is what it was before: nothing changes further back.
fn backwards(timed: &mut TimedSpan, first: usize, end: f64) -> bool {
    let (mut next, mut unchanged): (Option<(f64, f64)>, bool) = (None, false);
    for point in timed.points.iter_mut().skip(first).rev() {
        let Some(bounds) = timed.span.bounds_at(point.p) else { continue };
        let most = match next {
            Some((p, most)) => bounds.controllable(p - point.p, most),
            None => end.min(bounds.top()),
        };
        unchanged = next.is_some() && most == point.most && most > 0.0;
        point.most = most;
        next = Some((point.p, most));
    }
    unchanged
}

/// Sets x from the point `first` to the end of a span. Returns x at the end.
fn forwards(timed: &mut TimedSpan, first: usize, start: f64) -> f64 {
    let mut before: Option<Point> = None;
    for point in timed.points.iter_mut().skip(first) {
        point.x = match before {
            None => start,
            Some(before) => {
                let highest = timed.span.bounds_at(before.p).map_or(0.0, |bounds| bounds.highest(before.x));
                point.most.min(before.x + 2.0 * (point.p - before.p) * highest).max(0.0)
            }
        };
        before = Some(*point);
    }
    before.map_or(start, |point| point.x)
}
