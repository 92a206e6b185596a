//! Descriptions of differences and violations.

use val3_geometry::Vector3;
use val3_lang::ports::Time;
use val3_machine::controller::CodeSource;
use val3_machine::event::seconds;

use crate::comparison::{Comparison, Deviation, MoveComparison, TraceSide};
use crate::distance::{Distance, Tolerances};
use crate::limits::{Limit, Violation};
use crate::recording::MotionRecording;
use crate::times::change;

/// Maximum number of moves with another time that a report names.
const NAMED: usize = 5;

/// A difference or violation with its source.
#[derive(Debug, Clone, PartialEq)]
pub struct Finding {
    /// A sentence that describes the fault.
    pub message: String,
    /// Instruction of the move.
    pub source: Option<CodeSource>,
}

/// Describes differences of the present motion from a recorded motion: path, moves, times. Empty if the motions are
/// equal.
#[must_use]
pub fn describe(comparison: &Comparison, recording: &MotionRecording) -> Vec<Finding> {
    let report = TraceReport { comparison, recording };
    let times = report.times_of_moves().into_iter().chain(report.whole_time());
    report.path().into_iter().chain(report.count()).chain(times).collect()
}

/// Describes an exceeded limit.
#[must_use]
pub fn describe_violation(limit: &Limit, violation: &Violation, recording: &MotionRecording) -> Finding {
    let Violation { value, at, time, row } = *violation;
    let excess = match limit {
        Limit::Speed { most, .. } => format!("moves at {value:.1} mm/s instead of at most {most} mm/s"),
        Limit::Inside(_) => format!("is {value:.3} mm outside of its box"),
        Limit::Clear { least, .. } if value == 0.0 => {
            format!("is in the box to which it must keep a distance of {least} mm")
        }
        Limit::Clear { least, .. } => format!("comes within {value:.3} mm of the box to which it must keep {least} mm"),
    };
    let number = recording.trace.rows.get(row).map_or(0, |row| row.number());
    let source = recording.source(row).cloned();
    let (of_move, place) = (name(number, source.as_ref()), place(time, &at));
    Finding { message: format!("the tool centre point {excess}, {place}, in {of_move}"), source }
}

struct TraceReport<'a> {
    comparison: &'a Comparison,
    recording: &'a MotionRecording,
}

impl TraceReport<'_> {
    /// Describes the first move whose path differs, and the largest deviation.
    fn path(&self) -> Option<Finding> {
        let first = self.comparison.first()?;
        let source = self.source(first);
        let name = name(first.number, source.as_ref());
        let what = match first.deviation {
            _ if first.is_missing() => format!("move {} of the recorded motion is missing", first.number),
            _ if first.is_additional() => format!("{name} is not in the recorded motion"),
            Some(Deviation { side: TraceSide::Recorded, .. }) => format!("{name} misses a part of the recorded path"),
            _ => format!("{name} leaves the recorded path"),
        };
        let details = first.deviation.filter(Deviation::is_beyond).map(|deviation| self.details(&deviation));
        Some(Finding { message: format!("{what}{}{}", details.unwrap_or_default(), self.largest(first)), source })
    }

    /// Describes the largest deviation as the end of a sentence about the first one.
    fn largest(&self, first: &MoveComparison) -> String {
        match self.comparison.largest().filter(|(_, deviation)| deviation.is_beyond()) {
            None => String::new(),
            Some((largest, _)) if largest == first => "; this is the largest deviation".to_owned(),
            Some((largest, deviation)) => {
                let name = name(largest.number, self.source(largest).as_ref());
                format!("; the largest deviation is in {name}{}", self.details(&deviation))
            }
        }
    }

    fn details(&self, Deviation { side, time, at, distance, .. }: &Deviation) -> String {
        let recorded = if *side == TraceSide::Recorded { "recorded " } else { "" };
        format!(": {}, {recorded}{}", amount(distance, &self.comparison.tolerances), place(*time, at))
    }

    fn count(&self) -> Option<Finding> {
        let [recorded, present] = self.comparison.counts();
        let has_others = self.comparison.moves.iter().any(|one| one.is_missing() || one.is_additional());
        let message = format!("the motion has {} instead of {recorded}", moves(present));
        has_others.then_some(Finding { message, source: None })
    }

    fn times_of_moves(&self) -> Option<Finding> {
        let mut moves = self.comparison.slower_or_faster();
        let (first, times) = moves.next()?;
        let source = self.source(first);
        let name = |one: &MoveComparison| name(one.number, self.source(one).as_ref());
        let sentence = |one: &MoveComparison, times| format!("{} {}", name(one), takes(times));
        let others: Vec<String> = moves.by_ref().take(NAMED - 1).map(|(one, times)| sentence(one, times)).collect();
        let sentences: Vec<String> = [sentence(first, times)].into_iter().chain(others).collect();
        let left = match moves.count() {
            0 => String::new(),
            left => format!("; and {left} more"),
        };
        Some(Finding { message: sentences.join("; ") + &left, source })
    }

    fn whole_time(&self) -> Option<Finding> {
        let [recorded, present] = self.comparison.times;
        let rests = if recorded.resting == present.resting {
            String::new()
        } else {
            let [recorded, present] = [recorded.resting, present.resting].map(seconds);
            format!(", at rest for {present:.3} s instead of {recorded:.3} s")
        };
        let message = format!("the whole motion {}{rests}", takes([recorded.whole(), present.whole()]));
        self.comparison.takes_other_time().then_some(Finding { message, source: None })
    }

    fn source(&self, one: &MoveComparison) -> Option<CodeSource> {
        (!one.rows.is_empty()).then(|| self.recording.source(one.rows.start).cloned())?
    }
}

/// Formats the name of a move.
fn name(number: i64, source: Option<&CodeSource>) -> String {
    let source =
        source.map(|CodeSource { instruction, program, line, .. }| format!(" ({instruction}, {program}:{line})"));
    format!("move {number}{}", source.unwrap_or_default())
}

fn moves(count: usize) -> String {
    if count == 1 { "1 move".to_owned() } else { format!("{count} moves") }
}

/// Formats a distance in the units that exceed their tolerances.
#[must_use]
pub fn amount(distance: &Distance, tolerances: &Tolerances) -> String {
    let Distance { mm, degrees, joints, .. } = distance;
    let length = (*mm > tolerances.mm).then(|| format!("{mm:.3} mm away"));
    let turn = (*degrees > tolerances.degrees).then(|| format!("turned by {degrees:.3} degrees"));
    let parts: Vec<String> = length.into_iter().chain(turn).collect();
    if parts.is_empty() {
        format!("an axis is {joints:.1} degrees away, in another configuration")
    } else {
        parts.join(" and ")
    }
}

fn place(time: Time, at: &Vector3<f64>) -> String {
    format!("at {:.3} s at ({:.1}, {:.1}, {:.1})", seconds(time), at.x, at.y, at.z)
}

fn takes([recorded, present]: [Time; 2]) -> String {
    let change = change(recorded, present);
    let change = if change.is_finite() { format!(" ({change:+.1} %)") } else { String::new() };
    format!("takes {:.3} s instead of {:.3} s{change}", seconds(present), seconds(recorded))
}

#[cfg(test)]
mod tests;
