//! Timeline: speeds along the determined spans, set by the planner and followed by the executor.

use std::collections::VecDeque;
use std::sync::Arc;

use val3_moves::{Manner, Percent};

use crate::bounds::Bounds;
use crate::compliant::Glide;
use crate::span::{Reduction, Span};

/// Spans with their speeds, and the position of the arm. The arm is on the first span.
#[derive(Clone, Debug, Default)]
pub(crate) struct Timeline {
    pub(crate) spans: VecDeque<TimedSpan>,
    pub(crate) cursor: Cursor,
    /// Whether a point halts the arm.
    pub(crate) has_halt: bool,
}

/// Value of `most` before planning.
pub(crate) const UNPLANNED: f64 = f64::NAN;

/// Span with its speeds.
#[derive(Clone, Debug)]
pub(crate) struct TimedSpan {
    pub(crate) span: Arc<Span>,
    /// Points in ascending order of p, at least two.
    pub(crate) points: Vec<TimelinePoint>,
    /// Whether the arm rests before this span.
    pub(crate) from_rest: bool,
    /// Whether the arm waits for a release before this span (step mode).
    pub(crate) is_gated: bool,
    /// |dq/dp| at the end of the span with a deviation; `None` without a deviation.
    pub(crate) exit_rate: Option<f64>,
    /// Whether a reset has removed the move. The arm then only brakes on the span.
    pub(crate) is_forgotten: bool,
    /// Reduced speed limits; `None` at normal speed.
    pub(crate) reduction: Option<Reduction>,
}

/// Speed at one value of p. Between two points p̈ is constant.
#[derive(Clone, Copy, Debug)]
pub(crate) struct TimelinePoint {
    pub(crate) p: f64,
    /// ṗ².
    pub(crate) x: f64,
    /// Maximum x from which the arm can follow the rest of the path.
    pub(crate) most: f64,
    /// Whether the arm waits at the point for a release.
    pub(crate) halt: bool,
}

/// Position of the arm in the first span.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Cursor {
    /// Index of the last passed point.
    pub(crate) point: usize,
    /// Seconds since the last passed point.
    pub(crate) elapsed: f64,
    /// State of a compliant move, which follows no plan.
    pub(crate) glide: Option<Glide>,
}

impl TimedSpan {
    /// Creates a span without speeds; the planner sets them.
    pub(crate) fn new(span: Arc<Span>, from_rest: bool) -> Self {
        let last = span.len() - 1;
        let [_, end] = span.range();
        let p = |index| if index == last { end } else { span.at_knot(index) };
        let points =
            (0..=last).map(|index| TimelinePoint { p: p(index), x: 0.0, most: UNPLANNED, halt: false }).collect();
        Self { span, points, from_rest, is_gated: false, exit_rate: None, is_forgotten: false, reduction: None }
    }

    /// Whether the arm rests before this span in the plan.
    pub(crate) fn begins_at_rest(&self) -> bool {
        self.from_rest || self.is_gated
    }

    /// Index of the first point at which the arm halts.
    pub(crate) fn halt(&self) -> Option<usize> {
        self.points.iter().position(|point| point.halt)
    }

    /// Interval that begins at the point `index`.
    pub(crate) fn interval(&self, index: usize) -> Option<Interval> {
        Interval::at(&self.points, index)
    }

    /// Limits of the span, and its points for the planner.
    pub(crate) fn plan(&mut self) -> (SpanLimit<'_>, &mut Vec<TimelinePoint>) {
        (SpanLimit { span: &self.span, reduction: self.reduction.as_ref() }, &mut self.points)
    }

    /// Seconds from the point `index` to the end of the span.
    pub(crate) fn seconds_from(&self, index: usize) -> f64 {
        (index..self.points.len()).filter_map(|index| self.interval(index)).map(|interval| interval.seconds()).sum()
    }
}

/// Speed limits of a span.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SpanLimit<'a> {
    span: &'a Span,
    reduction: Option<&'a Reduction>,
}

impl<'a> SpanLimit<'a> {
    /// Limits from the point `index` to the next.
    pub(crate) fn bounds(&self, points: &[TimelinePoint], index: usize) -> Option<Bounds<'a>> {
        let next = points.get(index + 1).map(|next| next.p);
        self.span.bounds_within(points.get(index)?.p, next, self.reduction)
    }
}

/// Motion between two points, with a constant p̈.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Interval {
    pub(crate) from: TimelinePoint,
    pub(crate) to: TimelinePoint,
}

impl Interval {
    /// Interval that begins at the point `index`.
    pub(crate) fn at(points: &[TimelinePoint], index: usize) -> Option<Self> {
        let (from, to) = (points.get(index)?, points.get(index + 1)?);
        Some(Self { from: *from, to: *to })
    }

    /// Duration of the interval; infinite if the arm rests at both ends.
    pub(crate) fn seconds(&self) -> f64 {
        2.0 * (self.to.p - self.from.p) / (self.from.x.sqrt() + self.to.x.sqrt())
    }

    /// Value of p after a number of seconds.
    pub(crate) fn p_after(&self, seconds: f64) -> f64 {
        let p = self.from.p + seconds * (self.from.x.sqrt() + 0.5 * self.acceleration() * seconds);
        p.clamp(self.from.p, self.to.p)
    }

    /// Value of ṗ after a number of seconds.
    pub(crate) fn rate_after(&self, seconds: f64) -> f64 {
        (self.from.x.sqrt() + self.acceleration() * seconds).max(0.0)
    }

    /// Constant p̈ of the interval.
    pub(crate) fn acceleration(&self) -> f64 {
        (self.to.x - self.from.x) / (2.0 * (self.to.p - self.from.p))
    }
}

impl Timeline {
    /// Current p in the first span; `None` without a span.
    pub(crate) fn p(&self) -> Option<f64> {
        let front = self.spans.front()?;
        match front.interval(self.cursor.point) {
            _ if let Some(glide) = self.cursor.glide => Some(glide.p),
            Some(interval) if self.cursor.elapsed > 0.0 => Some(interval.p_after(self.cursor.elapsed)),
            _ => front.points.get(self.cursor.point).map(|point| point.p),
        }
    }

    /// First span and its force during a compliant move; `None` otherwise.
    pub(crate) fn compliant(&self) -> Option<(&TimedSpan, Percent)> {
        let front = self.spans.front()?;
        let is_done = self.cursor.point + 1 >= front.points.len();
        match front.span.manner {
            Manner::Compliant(force) if !is_done => Some((front, force)),
            _ => None,
        }
    }

    /// Records that the compliant move has reached its destination.
    pub(crate) fn pass_compliant(&mut self) {
        let last = self.spans.front().map_or(0, |front| front.points.len().saturating_sub(1));
        self.cursor = Cursor { point: last, ..Cursor::default() };
    }

    /// Value of p at the end of the last span.
    pub(crate) fn end(&self) -> Option<f64> {
        self.spans.back()?.points.last().map(|point| point.p)
    }

    /// Current ṗ in the first span.
    pub(crate) fn rate(&self) -> f64 {
        let Some(front) = self.spans.front() else { return 0.0 };
        match front.interval(self.cursor.point) {
            _ if let Some(glide) = self.cursor.glide => glide.rate.abs(),
            Some(interval) if self.cursor.elapsed > 0.0 => interval.rate_after(self.cursor.elapsed),
            _ => front.points.get(self.cursor.point).map_or(0.0, |point| point.x.sqrt()),
        }
    }

    /// Whether the arm is at the end of the determined path.
    pub(crate) fn is_at_end(&self) -> bool {
        match (self.spans.len(), self.spans.front()) {
            (0, _) | (_, None) => true,
            (1, Some(last)) => self.cursor.point + 1 >= last.points.len(),
            _ => false,
        }
    }

    /// Seconds until the end of the determined path, at full monitor speed.
    pub(crate) fn seconds_left(&self) -> f64 {
        let mut spans = self.spans.iter();
        let first = spans.next().map_or(0.0, |span| span.seconds_from(self.cursor.point) - self.cursor.elapsed);
        first.max(0.0) + spans.map(|span| span.seconds_from(0)).sum::<f64>()
    }

    /// Factor by which ṗ² changes from the span `index` to the next span, so that the axes keep their speeds.
    pub(crate) fn ratio(&self, index: usize) -> Option<f64> {
        let (span, next) = (self.spans.get(index)?, self.spans.get(index + 1)?);
        let ([_, end], [start, _]) = (span.span.ends(), next.span.ends());
        Some((span.exit_rate.unwrap_or(end) / start).powi(2))
    }
}
