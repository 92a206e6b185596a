//! The executor: follows a timeline, never plans.

use val3_moves::{Percent, Seconds};

use crate::span::Span;
use crate::timeline::{Cursor, Timeline};

/// Seconds in which the monitor speed rises from 0 to 100 % (model choice).
const RAMP: f64 = 0.25;

/// Follows a timeline at the monitor speed.
///
/// The monitor speed stretches time and therefore never changes the path.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Executor {
    /// Share of full speed that is in force; 1 for 100 %.
    pace: f64,
    /// Share that the operator has chosen.
    chosen: f64,
    /// A halt is in force, whose speeds no monitor speed changes.
    is_halting: bool,
}

impl Default for Executor {
    fn default() -> Self {
        Self { pace: 1.0, chosen: 1.0, is_halting: false }
    }
}

impl Executor {
    /// Chooses the monitor speed; it comes into force as a ramp, or immediately while the arm rests.
    pub(crate) fn set_monitor_speed(&mut self, speed: Percent, at_rest: bool) {
        self.chosen = (speed.0 / 100.0).max(0.0);
        if at_rest && !self.is_halting {
            self.pace = self.chosen;
        }
    }

    /// A halt comes into force. Returns the share of full speed at which the arm moves.
    pub(crate) fn halt(&mut self) -> f64 {
        self.is_halting = true;
        std::mem::replace(&mut self.pace, 1.0)
    }

    /// Share of full speed that is in force.
    pub(crate) fn pace(&self) -> f64 {
        self.pace
    }

    pub(crate) fn is_halting(&self) -> bool {
        self.is_halting
    }

    /// The arm, which is at rest, may continue.
    pub(crate) fn release(&mut self) {
        (self.pace, self.is_halting) = (self.chosen, false);
    }

    /// Moves the cursor by a duration. `passage` gets each passage from one span to the next, with the time since the
    /// beginning. The time is exact while the monitor speed does not change.
    pub(crate) fn advance(
        &mut self,
        timeline: &mut Timeline,
        duration: Seconds,
        mut passage: impl FnMut(&Span, &Span, Seconds),
    ) -> Advance {
        let whole = self.stretched(duration.0);
        let mut left = whole;
        let mut moved = false;
        let since = |left: f64| Seconds(if whole > 0.0 { duration.0 * (1.0 - left / whole) } else { 0.0 });
        while left > 0.0 {
            match advance_within_interval(timeline, left) {
                IntervalEnd::Within => {
                    (moved, left) = (true, 0.0);
                }
                IntervalEnd::Passed(seconds) => {
                    moved |= seconds > 0.0;
                    left -= seconds;
                }
                IntervalEnd::SpanDone => {
                    let done = timeline.spans.pop_front();
                    timeline.cursor = Cursor::default();
                    if let (Some(done), Some(next)) = (done, timeline.spans.front()) {
                        passage(&done.span, &next.span, since(left));
                    }
                }
                IntervalEnd::Rests => break,
            }
        }
        Advance { moved, end: since(left) }
    }

    /// The duration at full speed that corresponds to `seconds`, while the pace follows its ramp.
    pub(crate) fn stretched(&mut self, seconds: f64) -> f64 {
        if self.is_halting {
            return seconds;
        }
        let change = (self.chosen - self.pace).clamp(-seconds / RAMP, seconds / RAMP);
        let ramp = change.abs() * RAMP;
        let mean = self.pace + change / 2.0;
        self.pace += change;
        mean * ramp + self.pace * (seconds - ramp)
    }
}

/// The result of a cycle.
pub(crate) struct Advance {
    /// Whether the arm has moved.
    pub(crate) moved: bool,
    /// When the arm came to rest in the cycle, or its duration.
    pub(crate) end: Seconds,
}

/// The result of advancing to the end of an interval at most.
enum IntervalEnd {
    /// The time is used up within the interval.
    Within,
    /// The end of the interval is reached after some seconds.
    Passed(f64),
    /// The end of a span is reached, and there is another one.
    SpanDone,
    /// The arm halts, or nothing more is determined.
    Rests,
}

fn advance_within_interval(timeline: &mut Timeline, left: f64) -> IntervalEnd {
    let more = timeline.spans.len() > 1;
    let is_held = timeline.compliant().is_some() || timeline.waits_at_gate();
    let Some(front) = timeline.spans.front().filter(|_| !is_held) else {
        return IntervalEnd::Rests;
    };
    let cursor = &mut timeline.cursor;
    if cursor.elapsed == 0.0 && front.points.get(cursor.point).is_some_and(|point| point.halt) {
        return IntervalEnd::Rests;
    }
    let Some(interval) = front.interval(cursor.point) else {
        return if more { IntervalEnd::SpanDone } else { IntervalEnd::Rests };
    };
    let duration = interval.seconds();
    if duration.is_infinite() {
        return IntervalEnd::Rests;
    }
    if cursor.elapsed + left < duration {
        cursor.elapsed += left;
        return IntervalEnd::Within;
    }
    let used = duration - cursor.elapsed;
    *cursor = Cursor { point: cursor.point + 1, ..Cursor::default() };
    IntervalEnd::Passed(used)
}
