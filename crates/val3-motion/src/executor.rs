//! Executor: follows a timeline without planning.

use val3_moves::{Percent, Seconds};

use crate::span::Span;
use crate::timeline::{Cursor, Timeline};

/// Ramp time of the monitor speed from 0 to 100 %, in seconds (model choice).
const RAMP: f64 = 0.25;

/// Executor of a timeline at the monitor speed.
///
/// The monitor speed stretches time and therefore never changes the path.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Executor {
    /// Current fraction of full speed; 1 for 100 %.
    pace: f64,
    /// Monitor speed that the operator has set; 1 for 100 %.
    chosen: f64,
    /// Whether the arm halts. The monitor speed does not affect a halt.
    is_halting: bool,
}

impl Default for Executor {
    fn default() -> Self {
        Self { pace: 1.0, chosen: 1.0, is_halting: false }
    }
}

impl Executor {
    /// Sets the monitor speed. The change is a ramp, or immediate if the arm rests.
    pub(crate) fn set_monitor_speed(&mut self, speed: Percent, at_rest: bool) {
        self.chosen = (speed.0 / 100.0).max(0.0);
        if at_rest && !self.is_halting {
            self.pace = self.chosen;
        }
    }

    /// Starts a halt. Returns the fraction of full speed at which the arm moves.
    pub(crate) fn halt(&mut self) -> f64 {
        self.is_halting = true;
        std::mem::replace(&mut self.pace, 1.0)
    }

    /// Current fraction of full speed.
    pub(crate) fn pace(&self) -> f64 {
        self.pace
    }

    pub(crate) fn is_halting(&self) -> bool {
        self.is_halting
    }

    /// Ends a halt after the arm has come to rest.
    pub(crate) fn release(&mut self) {
        (self.pace, self.is_halting) = (self.chosen, false);
    }

    /// Moves the cursor by a duration. Calls `passage` for each transition from one span to the next, with the time
    /// since the beginning of the cycle. The time is exact while the monitor speed is constant.
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

    /// Converts `seconds` to the corresponding duration at full speed, and advances the ramp of the pace.
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

/// Result of a cycle.
pub(crate) struct Advance {
    /// Whether the arm has moved.
    pub(crate) moved: bool,
    /// Time in the cycle at which the arm came to rest; otherwise the duration of the cycle.
    pub(crate) end: Seconds,
}

/// Result of advancing by at most one interval.
enum IntervalEnd {
    /// The cycle ended within the interval.
    Within,
    /// The end of the interval was reached after this number of seconds.
    Passed(f64),
    /// The end of a span was reached, and another span follows.
    SpanDone,
    /// The arm halts, or no further path is determined.
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
