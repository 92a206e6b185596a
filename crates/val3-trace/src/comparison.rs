//! Comparison of a recorded trace with the present trace, move by move.

use std::ops::Range;

use val3_geometry::Vector3;
use val3_lang::ports::Time;

use crate::align::{MovePair, aligned};
use crate::distance::{Distance, Tolerances, distance};
use crate::row::TraceRow;
use crate::stretch::stretches;
use crate::times::{TraceTimes, UNCERTAINTY, differs};

/// Differences between two traces.
#[derive(Debug, Clone, PartialEq)]
pub struct Comparison {
    /// Moves of both traces, in order.
    pub moves: Vec<MoveComparison>,
    /// Total times of the recorded trace and the present trace.
    pub times: [TraceTimes; 2],
    /// Tolerances of the comparison.
    pub tolerances: Tolerances,
}

/// Differences of a move.
#[derive(Debug, Clone, PartialEq)]
pub struct MoveComparison {
    /// Integer part of the move's id.
    pub number: i64,
    /// Row range in the present trace; an empty range at the move's place if the present trace does not contain it.
    pub rows: Range<usize>,
    /// Times in the recorded trace and the present trace; `None` in a trace without the move.
    pub times: [Option<TraceTimes>; 2],
    /// Largest deviation between the traces.
    pub deviation: Option<Deviation>,
}

/// A point in one trace that deviates from the path of the other trace.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Deviation {
    /// Trace that contains the point.
    pub side: TraceSide,
    /// Time at the point, in nanoseconds of the trace's clock.
    pub time: Time,
    /// Point in world, in mm.
    pub at: Vector3<f64>,
    /// Distance to the path of the other trace.
    pub distance: Distance,
    /// Distance as a multiple of the tolerances.
    pub excess: f64,
}

/// One of the two traces.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TraceSide {
    /// The recorded trace.
    Recorded,
    /// The present trace.
    Present,
}

/// Compares the rows of a recorded trace with the rows of the present trace.
#[must_use]
pub fn compare(recorded: &[TraceRow], present: &[TraceRow], tolerances: Tolerances) -> Comparison {
    let pairs = aligned(&stretches(recorded), &stretches(present));
    let moves = pairs.into_iter().map(|pair| compare_move(pair, recorded, present, &tolerances)).collect();
    let times = [recorded, present].map(|rows| TraceTimes::of(rows, 0..rows.len()));
    Comparison { moves, times, tolerances }
}

fn compare_move(
    pair: MovePair,
    recorded: &[TraceRow],
    present: &[TraceRow],
    tolerances: &Tolerances,
) -> MoveComparison {
    let (old, new) = (&pair.recorded, &pair.present);
    let ways = [
        (TraceSide::Present, rows(present, new), widened(recorded, old)),
        (TraceSide::Recorded, rows(recorded, old), widened(present, new)),
    ];
    let times = |rows: &[TraceRow], part: &Range<usize>| (!part.is_empty()).then(|| TraceTimes::of(rows, part.clone()));
    MoveComparison {
        number: pair.number,
        rows: new.clone(),
        times: [times(recorded, old), times(present, new)],
        deviation: ways
            .into_iter()
            .filter_map(|(side, places, path)| largest(side, places, path, tolerances))
            .reduce(Deviation::larger),
    }
}

fn rows<'r>(rows: &'r [TraceRow], part: &Range<usize>) -> &'r [TraceRow] {
    rows.get(part.clone()).unwrap_or_default()
}

/// Extends a range by one row on both sides, because rows on the same path are at other points at another speed. A
/// missing move is compared with the path past it.
fn widened<'r>(all: &'r [TraceRow], part: &Range<usize>) -> &'r [TraceRow] {
    rows(all, &(part.start.saturating_sub(1)..all.len().min(part.end + 1)))
}

/// Returns the point with the largest distance to a path.
fn largest(side: TraceSide, places: &[TraceRow], path: &[TraceRow], tolerances: &Tolerances) -> Option<Deviation> {
    places.iter().filter_map(|place| deviation(side, place, path, tolerances)).reduce(Deviation::larger)
}

fn deviation(side: TraceSide, place: &TraceRow, path: &[TraceRow], tolerances: &Tolerances) -> Option<Deviation> {
    let distance = distance(place, path, tolerances)?;
    let excess = distance.excess(tolerances);
    Some(Deviation { side, time: place.time, at: place.position(), distance, excess })
}

impl Deviation {
    /// Returns the larger deviation; the first if they are equal.
    fn larger(self, other: Self) -> Self {
        if other.excess > self.excess { other } else { self }
    }

    /// Whether the deviation exceeds the tolerances.
    #[must_use]
    pub fn is_beyond(&self) -> bool {
        self.excess > 1.0
    }
}

impl MoveComparison {
    /// Whether the path of the arm differs in this move.
    #[must_use]
    pub fn diverges(&self) -> bool {
        let is_elsewhere = self.deviation.is_some_and(|deviation| deviation.is_beyond());
        is_elsewhere || self.is_missing() || self.is_additional()
    }

    /// Whether only the recorded trace contains the move.
    #[must_use]
    pub fn is_missing(&self) -> bool {
        matches!(self.times, [Some(times), None] if times.moving > UNCERTAINTY)
    }

    /// Whether only the present trace contains the move.
    #[must_use]
    pub fn is_additional(&self) -> bool {
        matches!(self.times, [None, Some(times)] if times.moving > UNCERTAINTY)
    }

    /// Returns the times of motion in the recorded trace and the present trace, if both contain the move.
    #[must_use]
    pub fn moving(&self) -> Option<[Time; 2]> {
        let [recorded, present] = self.times;
        Some([recorded?.moving, present?.moving])
    }
}

impl Comparison {
    /// Returns the first move whose path differs.
    #[must_use]
    pub fn first(&self) -> Option<&MoveComparison> {
        self.moves.iter().find(|one| one.diverges())
    }

    /// Returns the move with the largest deviation.
    #[must_use]
    pub fn largest(&self) -> Option<(&MoveComparison, Deviation)> {
        let deviations = self.moves.iter().filter_map(|one| Some((one, one.deviation?)));
        deviations.reduce(|best, next| if next.1.excess > best.1.excess { next } else { best })
    }

    /// Returns the moves whose time differs, with the recorded and the present time.
    pub fn slower_or_faster(&self) -> impl Iterator<Item = (&MoveComparison, [Time; 2])> {
        let times = self.moves.iter().filter_map(|one| Some((one, one.moving()?)));
        times.filter(|(_, [recorded, present])| differs(*recorded, *present, self.tolerances.time))
    }

    /// Whether the total time differs.
    #[must_use]
    pub fn takes_other_time(&self) -> bool {
        let [recorded, present] = self.times;
        differs(recorded.whole(), present.whole(), self.tolerances.time)
    }

    /// Returns the number of moves in the recorded trace and the present trace.
    #[must_use]
    pub fn counts(&self) -> [usize; 2] {
        [0, 1].map(|side| self.moves.iter().filter(|one| one.times.get(side).is_some_and(Option::is_some)).count())
    }

    /// Whether the traces are equal within the tolerances.
    #[must_use]
    pub fn is_same(&self) -> bool {
        self.first().is_none() && !self.takes_other_time() && self.slower_or_faster().next().is_none()
    }
}

#[cfg(test)]
mod tests;
