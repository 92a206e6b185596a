//! `[[expect.time]]`: the time of a cycle, from one condition to another, or of the whole test.

use serde::Deserialize;
use toml::Spanned;
use val3_lang::ports::{Time, nanoseconds};
use val3_machine::controller::Controller;
use val3_machine::event::seconds;
use val3_machine::script::Condition;
use val3_trace::Positive;

use super::Cycle;
use crate::result::Failure;
use crate::source::Source;

/// The longest time of a cycle:
///
/// ```toml
/// [[expect.time]]
/// below = 12.5                                  # seconds of the controller's clock
/// from = { io = { "BasicIO-1\\%I0" = true } }   # the start of the test without it
/// to = { data = { nBoxes = 2 } }                # its end without it
/// ```
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct CycleTime {
    below: Positive,
    from: Option<Condition>,
    to: Option<Condition>,
}

/// The cycles of a test.
pub(super) struct CycleTimes<'s>(Vec<Stopwatch<'s>>);

impl<'s> CycleTimes<'s> {
    pub(super) fn new(expected: &'s [Spanned<CycleTime>]) -> Self {
        Self(expected.iter().map(Stopwatch::new).collect())
    }

    pub(super) fn see(&mut self, cycle: Cycle<'_>) {
        self.0.iter_mut().for_each(|stopwatch| stopwatch.see(cycle));
    }

    pub(super) fn failures(&self, controller: &Controller, source: &Source) -> Vec<Failure> {
        let failure = |stopwatch: &Stopwatch<'_>| {
            let message = stopwatch.failure(controller)?;
            Some(Failure { message, places: vec![source.place("expect.time", stopwatch.expected.span())] })
        };
        self.0.iter().filter_map(failure).collect()
    }
}

/// Measures from each time that a condition becomes true to the next time that another one does.
struct Stopwatch<'s> {
    expected: &'s Spanned<CycleTime>,
    from: Edge<'s>,
    to: Edge<'s>,
    /// When the cycle that is not over has begun.
    begun: Option<Time>,
    /// Begin and end of the longest cycle.
    longest: Option<[Time; 2]>,
}

/// The moments at which a condition becomes true.
struct Edge<'s> {
    condition: Option<&'s Condition>,
    held: bool,
}

impl<'s> Edge<'s> {
    fn new(condition: Option<&'s Condition>) -> Self {
        Self { condition, held: false }
    }

    fn rises(&mut self, controller: &Controller) -> bool {
        let holds = self.condition.is_some_and(|condition| controller.meets(condition));
        let held = std::mem::replace(&mut self.held, holds);
        holds && !held
    }
}

impl<'s> Stopwatch<'s> {
    fn new(expected: &'s Spanned<CycleTime>) -> Self {
        let CycleTime { from, to, .. } = expected.get_ref();
        let (from, to) = (Edge::new(from.as_ref()), Edge::new(to.as_ref()));
        Self { expected, from, to, begun: None, longest: None }
    }

    fn see(&mut self, Cycle { start, controller, .. }: Cycle<'_>) {
        if self.from.condition.is_none() && self.begun.is_none() && self.longest.is_none() {
            self.begun = Some(start);
        }
        let now = controller.now();
        if self.to.rises(controller) {
            self.end(now);
        }
        if self.from.rises(controller) {
            self.begun.get_or_insert(now);
        }
    }

    /// The cycle that is not over ends.
    fn end(&mut self, now: Time) {
        let Some(begun) = self.begun.take() else { return };
        let is_longer = self.longest.is_none_or(|[from, to]| now - begun > to - from);
        self.longest = if is_longer { Some([begun, now]) } else { self.longest };
    }

    fn failure(&self, controller: &Controller) -> Option<String> {
        let longest = match (self.longest, self.begun) {
            (Some(longest), _) => longest,
            (None, Some(begun)) if self.to.condition.is_none() => [begun, controller.now()],
            (None, Some(begun)) => return Some(never("to", self.to.condition, Some(begun), controller)),
            (None, None) => return Some(never("from", self.from.condition, None, controller)),
        };
        let [from, to] = longest;
        let below = self.expected.get_ref().below.0;
        let message = || {
            let [took, from, to] = [to - from, from, to].map(seconds);
            format!("the cycle takes {took:.3} s instead of at most {below} s, from {from:.3} s to {to:.3} s")
        };
        (to - from > nanoseconds(below)).then(message)
    }
}

/// The failure of a cycle that has never begun or ended.
fn never(key: &str, condition: Option<&Condition>, since: Option<Time>, controller: &Controller) -> String {
    let since = since.map_or(String::new(), |since| format!(" after {:.3} s", seconds(since)));
    let mismatches = condition.map(|condition| controller.mismatches(condition)).unwrap_or_default();
    let now: Vec<String> = mismatches.iter().map(ToString::to_string).collect();
    let now = if now.is_empty() { String::new() } else { format!(": at the end {}", now.join(", ")) };
    format!("the condition `{key}` of the cycle has never become true{since}{now}")
}
