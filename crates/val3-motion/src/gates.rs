//! Timeline gates: in step mode the arm comes to rest before each path piece and waits for a release.
//!
//! A piece is the nominal part of a move or the blend around its destination (manual 10.2.2). Gates change only speeds.
//! The spans, and therefore the positions on the path, are the same as in continuous mode.

use crate::plan::Index;
use crate::span::Span;
use crate::timeline::{Cursor, TimedSpan, Timeline};

/// Relative tolerance by which the square of a speed may exceed the plan.
const ROUNDING: f64 = 1e-9;

impl Timeline {
    /// Whether the arm waits at a gate: at the start of the first span, or at its end before the next span.
    pub(crate) fn waits_at_gate(&self) -> bool {
        self.gate_of_arm().is_some()
    }

    /// Index of the span before which the arm waits.
    fn gate_of_arm(&self) -> Option<usize> {
        let front = self.spans.front()?;
        let is_done = self.cursor.point + 1 >= front.points.len();
        let next = if is_done { 1 } else { 0 };
        let is_before_next = is_done || self.cursor == Cursor::default();
        (is_before_next && self.spans.get(next)?.is_gated).then_some(next)
    }

    /// Whether a span after the last span would begin a new piece in step mode.
    pub(crate) fn begins_piece(&self, span: &Span) -> bool {
        self.is_at_end() || self.spans.back().is_none_or(|last| last.span.part != span.part)
    }

    /// Sets gates before all pieces that the arm has not begun, except gates at which the arm cannot stop in time.
    pub(crate) fn close_gates(&mut self) {
        let from = self.first_gate();
        let mut before = from.checked_sub(1).and_then(|before| self.spans.get(before)).map(|before| before.span.part);
        for timed in self.spans.iter_mut().skip(from) {
            timed.is_gated = before.replace(timed.span.part) != Some(timed.span.part);
        }
        self.replan();
        while !self.can_follow_plan(self.commit())
            && let Some(gated) = self.spans.iter_mut().find(|timed| timed.is_gated)
        {
            gated.is_gated = false;
            self.replan();
        }
    }

    /// Index of the first span that may have a gate.
    fn first_gate(&self) -> usize {
        let is_before_first = self.cursor == Cursor::default() && self.rate() == 0.0;
        if is_before_first && !self.has_halt { 0 } else { self.commit().0 + 1 }
    }

    /// Whether the arm can follow the plan from `commit`, where its speed is fixed.
    fn can_follow_plan(&self, (index, point): Index) -> bool {
        let point = self.spans.get(index).and_then(|timed| timed.points.get(point));
        point.is_none_or(|point| point.x <= point.most * (1.0 + ROUNDING))
    }

    /// Opens the gate at which the arm waits. Returns whether the arm has waited at a gate.
    pub(crate) fn open_gate(&mut self) -> bool {
        let gate = self.gate_of_arm().and_then(|index| self.spans.get_mut(index));
        // No new plan is necessary, because the arm does rest before this span.
        gate.is_some_and(|gated| std::mem::take(&mut gated.is_gated))
    }

    /// Opens all gates.
    pub(crate) fn open_gates(&mut self) {
        let has_other =
            self.spans.iter().enumerate().any(|(index, timed)| timed.is_gated && Some(index) != self.gate_of_arm());
        self.spans.iter_mut().for_each(|timed| timed.is_gated = false);
        if has_other {
            self.replan();
        }
    }

    /// Spans of the piece that begins with the span `index`.
    pub(crate) fn piece(&self, index: usize) -> impl Iterator<Item = &TimedSpan> {
        let part = self.spans.get(index).map(|timed| timed.span.part);
        let spans = self.spans.iter().skip(index).enumerate();
        spans
            .take_while(move |(place, timed)| Some(timed.span.part) == part && (*place == 0 || !timed.is_gated))
            .map(|(_, timed)| timed)
    }

    /// Index of the first span after the arm's current piece.
    pub(crate) fn next_piece(&self) -> Option<usize> {
        let next = self.gate_of_arm().unwrap_or_else(|| self.piece(0).count());
        (next < self.spans.len()).then_some(next)
    }
}
