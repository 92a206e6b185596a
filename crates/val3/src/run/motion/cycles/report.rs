//! Report of the complete cycles of a run.

use serde::{Deserialize, Serialize};
use val3_lang::ports::Time;
use val3_machine::controller::WaitCause;
use val3_machine::event::seconds;

use super::Part;

/// Cycle times in seconds: a table for users, and as JSON.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct CyclesReport {
    /// Event at which each cycle begins.
    pub(super) event: String,
    /// Number of complete cycles.
    pub(super) count: usize,
    /// First cycle, and shortest, mean and longest cycle; `None` without a complete cycle.
    #[serde(flatten)]
    pub(super) times: Option<CycleTimes>,
    /// Complete cycles in their order.
    pub(super) cycles: Vec<CycleRow>,
}

/// Times over all cycles, in seconds.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(super) struct CycleTimes {
    pub(super) first: f64,
    pub(super) min: f64,
    pub(super) mean: f64,
    pub(super) max: f64,
    /// Mean times of the parts.
    #[serde(flatten)]
    pub(super) parts: PartSeconds,
}

/// A complete cycle.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(crate) struct CycleRow {
    /// Beginning and end, in seconds of the controller's clock.
    from: f64,
    to: f64,
    seconds: f64,
    #[serde(flatten)]
    parts: PartSeconds,
}

/// Parts of a cycle time, in seconds.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct PartSeconds {
    /// The arm moves.
    moving: f64,
    /// The arm rests, and the task that moves it waits for a condition, a signal, the operator or a line.
    outside: f64,
    /// … for the arm, for example for power.
    arm: f64,
    /// … for a period of time.
    time: f64,
    /// … computes, or there is no such task.
    other: f64,
}

/// Parts of the current cycle, in nanoseconds.
#[derive(Debug, Default)]
pub(super) struct Parts {
    moving: Time,
    outside: Time,
    arm: Time,
    time: Time,
    other: Time,
}

impl Parts {
    pub(super) const fn add(&mut self, part: Part, time: Time) {
        let total = match part {
            Part::Moving => &mut self.moving,
            Part::Waiting(WaitCause::Outside) => &mut self.outside,
            Part::Waiting(WaitCause::Arm) => &mut self.arm,
            Part::Waiting(WaitCause::Time) => &mut self.time,
            Part::Other => &mut self.other,
        };
        *total += time;
    }

    fn seconds(&self) -> PartSeconds {
        let Self { moving, outside, arm, time, other } = *self;
        let [moving, outside, arm, time, other] = [moving, outside, arm, time, other].map(seconds);
        PartSeconds { moving, outside, arm, time, other }
    }
}

impl PartSeconds {
    /// Parts with their names in tables.
    pub(super) const fn named(&self) -> [(&'static str, f64); 5] {
        [
            ("the arm moves", self.moving),
            ("waits for a condition or signal", self.outside),
            ("waits for the arm", self.arm),
            ("waits for time", self.time),
            ("other", self.other),
        ]
    }

    fn total(&self) -> f64 {
        self.named().iter().map(|(_, seconds)| seconds).sum()
    }

    fn mean(rows: &[CycleRow]) -> Self {
        let parts = || rows.iter().map(|row| &row.parts);
        Self {
            moving: mean(parts().map(|parts| parts.moving)),
            outside: mean(parts().map(|parts| parts.outside)),
            arm: mean(parts().map(|parts| parts.arm)),
            time: mean(parts().map(|parts| parts.time)),
            other: mean(parts().map(|parts| parts.other)),
        }
    }
}

impl CycleRow {
    pub(super) fn new(from: f64, to: f64, parts: Parts) -> Self {
        Self { from, to, seconds: rounded(to - from), parts: parts.seconds() }
    }
}

/// Mean of the cycles' seconds.
fn mean(seconds: impl ExactSizeIterator<Item = f64>) -> f64 {
    let count = seconds.len() as f64;
    rounded(seconds.sum::<f64>() / count)
}

/// Rounds seconds to nanoseconds, so that a difference has no digits beyond the clock's.
fn rounded(seconds: f64) -> f64 {
    (seconds * 1e9).round() / 1e9
}

impl CyclesReport {
    pub(super) fn new(event: String, cycles: Vec<CycleRow>) -> Self {
        let seconds = || cycles.iter().map(|cycle| cycle.seconds);
        let times = cycles.first().map(|first| CycleTimes {
            first: first.seconds,
            min: seconds().fold(f64::INFINITY, f64::min),
            mean: rounded(seconds().sum::<f64>() / cycles.len() as f64),
            max: seconds().fold(0.0, f64::max),
            parts: PartSeconds::mean(&cycles),
        });
        Self { event, count: cycles.len(), times, cycles }
    }

    pub(super) const fn count(&self) -> usize {
        self.count
    }

    /// Table for users.
    pub(super) fn table(&self) -> String {
        let Some(times) = &self.times else { return String::new() };
        let CycleTimes { first, min, mean, max, parts } = times;
        let mut table = format!("{}\n", heading(&self.event, self.count));
        table += &format!("  first {first:.3} s, min {min:.3} s, mean {mean:.3} s, max {max:.3} s\n");
        let total = parts.total();
        for (name, seconds) in parts.named().into_iter().filter(|(_, seconds)| *seconds > 0.0) {
            table += &format!("  {seconds:>10.3} s {:>5.1} %  {name}\n", seconds / total * 100.0);
        }
        table
    }
}

/// Heading of a table.
pub(super) fn heading(event: &str, count: usize) -> String {
    let cycles = if count == 1 { "cycle" } else { "cycles" };
    format!("{count} {cycles} of {event}")
}
