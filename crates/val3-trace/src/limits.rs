//! Limits of the tool centre point: a speed, a box that it must not leave, a box that it must not come near.

use std::ops::Range;

use val3_geometry::Vector3;
use val3_lang::ports::Time;
use val3_machine::event::seconds;
use val3_vm::CYCLE;

use crate::row::Row;
use crate::zone::Zone;

/// A value beyond its limit by less than this, in mm or mm/s, is rounded.
const ROUNDING: f64 = 0.001;

/// A limit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Limit {
    /// The highest speed in mm/s, within a box or everywhere.
    Speed {
        /// In mm/s.
        most: f64,
        /// Where it applies.
        zone: Option<Zone>,
    },
    /// The tool centre point stays in a box.
    Inside(Zone),
    /// The tool centre point keeps a distance to a box.
    Clear {
        /// The box.
        zone: Zone,
        /// The distance in mm.
        least: f64,
    },
}

/// The place at which a limit is exceeded the most.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Violation {
    /// The speed in mm/s, the distance to the box that it must not leave, or that to the box to keep away from, in mm.
    pub value: f64,
    /// The place in world, in mm.
    pub at: Vector3<f64>,
    /// When the cycle with the place began.
    pub time: Time,
    /// The place of its row in the trace.
    pub row: usize,
}

impl Limit {
    /// The worst place of a part of a trace; none if the limit is kept.
    #[must_use]
    pub fn violation(&self, rows: &[Row], part: Range<usize>) -> Option<Violation> {
        let ways = part.filter_map(|row| Way::to(row, rows));
        let exceeding = ways.filter_map(|way| self.exceeded_by(&way));
        let (_, worst) = exceeding.reduce(|worst, next| if next.0 > worst.0 { next } else { worst })?;
        Some(worst)
    }

    /// The excess of a way over the limit, and its place.
    fn exceeded_by(&self, way: &Way<'_>) -> Option<(f64, Violation)> {
        let (excess, value, share) = match self {
            Self::Speed { most, zone } => {
                let share = zone.map_or(Some(1.0), |zone| way.share_in(&zone))?;
                (way.row.speed - most, way.row.speed, share)
            }
            Self::Inside(zone) => {
                let outside = zone.distance(&way.row.position());
                (outside, outside, 1.0)
            }
            Self::Clear { zone, least } => {
                let nearest = zone.nearest(&way.from, &way.row.position());
                (least - nearest.distance, nearest.distance, nearest.share)
            }
        };
        let at = way.from + (way.row.position() - way.from) * share;
        (excess > ROUNDING).then_some((excess, Violation { value, at, time: way.row.time, row: way.place }))
    }
}

/// The way of the tool centre point in a cycle: a straight line, from which the path differs by less than a tenth of a
/// millimetre.
struct Way<'r> {
    from: Vector3<f64>,
    row: &'r Row,
    place: usize,
}

impl<'r> Way<'r> {
    fn to(place: usize, rows: &'r [Row]) -> Option<Self> {
        let row = rows.get(place)?;
        let before = place.checked_sub(1).and_then(|before| rows.get(before));
        let from = before.filter(|before| before.leads_to(row)).unwrap_or(row);
        Some(Self { from: from.position(), row, place })
    }

    /// The place at which the way is in a box.
    fn share_in(&self, zone: &Zone) -> Option<f64> {
        let nearest = zone.nearest(&self.from, &self.row.position());
        (nearest.distance < ROUNDING).then_some(nearest.share)
    }
}

impl Row {
    /// Whether the tool centre point has come from here in one cycle. It has not if the tool was exchanged, or the arm put
    /// elsewhere.
    fn leads_to(&self, next: &Self) -> bool {
        (next.position() - self.position()).norm() <= next.speed * seconds(CYCLE) + ROUNDING
    }
}

#[cfg(test)]
mod tests;
