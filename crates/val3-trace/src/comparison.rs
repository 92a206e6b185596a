//! The comparison of a recorded trace with the present one, move by move.

use std::ops::Range;

use val3_geometry::Vector3;
use val3_lang::ports::Time;

use crate::align::{Pair, aligned};
use crate::distance::{Distance, Tolerances, distance};
use crate::row::Row;
use crate::stretch::stretches;
use crate::times::{Times, UNCERTAINTY, differs};

/// The differences of two traces.
#[derive(Debug, Clone, PartialEq)]
pub struct Comparison {
    /// The moves of both traces, in order.
    pub moves: Vec<MoveComparison>,
    /// The times of the whole recorded trace and the present one.
    pub times: [Times; 2],
    /// The tolerances that apply.
    pub tolerances: Tolerances,
}

/// The differences of a move.
#[derive(Debug, Clone, PartialEq)]
pub struct MoveComparison {
    /// The whole part of its id.
    pub number: i64,
    /// The places of its rows in the present trace; an empty range at their place if this trace does not have it.
    pub rows: Range<usize>,
    /// Its times in the recorded trace and the present one; none in a trace that does not have it.
    pub times: [Option<Times>; 2],
    /// The place where the traces are the furthest apart.
    pub deviation: Option<Deviation>,
}

/// A place of one trace that is away from the path of the other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Deviation {
    /// The trace that has the place.
    pub side: Side,
    /// When the arm was there, in nanoseconds of the clock of that trace.
    pub time: Time,
    /// The place in world, in mm.
    pub at: Vector3<f64>,
    /// Its distance to the path of the other trace.
    pub distance: Distance,
    /// The distance as a multiple of the tolerances.
    pub excess: f64,
}

/// One of the two traces.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// The recorded one.
    Recorded,
    /// The present one.
    Present,
}

/// Compares the rows of a recorded trace with the present ones.
#[must_use]
pub fn compare(recorded: &[Row], present: &[Row], tolerances: Tolerances) -> Comparison {
    let pairs = aligned(&stretches(recorded), &stretches(present));
    let moves = pairs.into_iter().map(|pair| compare_move(pair, recorded, present, &tolerances)).collect();
    let times = [recorded, present].map(|rows| Times::of(rows, 0..rows.len()));
    Comparison { moves, times, tolerances }
}

fn compare_move(pair: Pair, recorded: &[Row], present: &[Row], tolerances: &Tolerances) -> MoveComparison {
    let (old, new) = (&pair.recorded, &pair.present);
    let ways = [
        (Side::Present, rows(present, new), widened(recorded, old)),
        (Side::Recorded, rows(recorded, old), widened(present, new)),
    ];
    let times = |rows: &[Row], part: &Range<usize>| (!part.is_empty()).then(|| Times::of(rows, part.clone()));
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

fn rows<'r>(rows: &'r [Row], part: &Range<usize>) -> &'r [Row] {
    rows.get(part.clone()).unwrap_or_default()
}

/// The part with the rows before and after it, which are on the way to it and from it. The same path has its rows
/// elsewhere at another speed. A move that is missing is compared with the way past it.
fn widened<'r>(all: &'r [Row], part: &Range<usize>) -> &'r [Row] {
    rows(all, &(part.start.saturating_sub(1)..all.len().min(part.end + 1)))
}

/// The place that is the furthest away from a path.
fn largest(side: Side, places: &[Row], path: &[Row], tolerances: &Tolerances) -> Option<Deviation> {
    let deviation = |place: &Row| {
        let distance = distance(place, path, tolerances)?;
        let excess = distance.excess(tolerances);
        Some(Deviation { side, time: place.time, at: place.position(), distance, excess })
    };
    places.iter().filter_map(deviation).reduce(Deviation::larger)
}

impl Deviation {
    /// The larger of two; the first one if they are equal.
    fn larger(self, other: Self) -> Self {
        if other.excess > self.excess { other } else { self }
    }

    /// Whether it is more than the tolerances allow.
    #[must_use]
    pub fn is_beyond(&self) -> bool {
        self.excess > 1.0
    }
}

impl MoveComparison {
    /// Whether the arm takes another path in this move.
    #[must_use]
    pub fn diverges(&self) -> bool {
        let is_elsewhere = self.deviation.is_some_and(|deviation| deviation.is_beyond());
        is_elsewhere || self.is_missing() || self.is_additional()
    }

    /// Whether the recorded trace alone has it.
    #[must_use]
    pub fn is_missing(&self) -> bool {
        matches!(self.times, [Some(times), None] if times.moving > UNCERTAINTY)
    }

    /// Whether the present trace alone has it.
    #[must_use]
    pub fn is_additional(&self) -> bool {
        matches!(self.times, [None, Some(times)] if times.moving > UNCERTAINTY)
    }

    /// The times while the arm moves, in the recorded trace and the present one, if both have the move.
    #[must_use]
    pub fn moving(&self) -> Option<[Time; 2]> {
        let [recorded, present] = self.times;
        Some([recorded?.moving, present?.moving])
    }
}

impl Comparison {
    /// The first move whose path is another one.
    #[must_use]
    pub fn first(&self) -> Option<&MoveComparison> {
        self.moves.iter().find(|one| one.diverges())
    }

    /// The move with the largest deviation of the run.
    #[must_use]
    pub fn largest(&self) -> Option<(&MoveComparison, Deviation)> {
        let deviations = self.moves.iter().filter_map(|one| Some((one, one.deviation?)));
        deviations.reduce(|best, next| if next.1.excess > best.1.excess { next } else { best })
    }

    /// The moves that take another time than the recorded ones, with both times.
    pub fn slower_or_faster(&self) -> impl Iterator<Item = (&MoveComparison, [Time; 2])> {
        let times = self.moves.iter().filter_map(|one| Some((one, one.moving()?)));
        times.filter(|(_, [recorded, present])| differs(*recorded, *present, self.tolerances.time))
    }

    /// Whether the whole motion takes another time.
    #[must_use]
    pub fn takes_other_time(&self) -> bool {
        let [recorded, present] = self.times;
        differs(recorded.whole(), present.whole(), self.tolerances.time)
    }

    /// The numbers of moves in the recorded trace and the present one.
    #[must_use]
    pub fn counts(&self) -> [usize; 2] {
        [0, 1].map(|side| self.moves.iter().filter(|one| one.times.get(side).is_some_and(Option::is_some)).count())
    }

    /// Whether the traces are the same within the tolerances.
    #[must_use]
    pub fn is_same(&self) -> bool {
        self.first().is_none() && !self.takes_other_time() && self.slower_or_faster().next().is_none()
    }
}

#[cfg(test)]
mod tests;
