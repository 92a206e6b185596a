//! Limits of the tool centre point: maximum speed, a box that it must not leave, and a box that it must avoid.

use std::ops::Range;

use val3_geometry::Vector3;
use val3_lang::ports::Time;
use val3_machine::event::seconds;
use val3_vm::CYCLE;

use crate::row::TraceRow;
use crate::zone::Zone;

/// Excess in mm or mm/s below which a limit is kept, because of rounding.
const ROUNDING: f64 = 0.001;

/// A limit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Limit {
    /// Maximum speed within a box or everywhere.
    Speed {
        /// Maximum speed in mm/s.
        most: f64,
        /// Box in which the limit applies; `None` for everywhere.
        zone: Option<Zone>,
    },
    /// Box that the tool centre point must not leave.
    Inside(Zone),
    /// Box that the tool centre point must avoid.
    Clear {
        /// Box.
        zone: Zone,
        /// Minimum distance in mm.
        least: f64,
    },
}

/// The point at which a limit is exceeded the most.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Violation {
    /// Speed in mm/s, distance outside of the box in mm, or distance to the avoided box in mm.
    pub value: f64,
    /// Point in world, in mm.
    pub at: Vector3<f64>,
    /// Start time of the cycle with the point.
    pub time: Time,
    /// Row index in the trace.
    pub row: usize,
}

impl Limit {
    /// Returns the worst point in a part of a trace; `None` if the limit is kept.
    #[must_use]
    pub fn violation(&self, rows: &[TraceRow], part: Range<usize>) -> Option<Violation> {
        let ways = part.filter_map(|row| CyclePath::to(row, rows));
        let exceeding = ways.filter_map(|way| self.exceeded_by(&way));
        let (_, worst) = exceeding.reduce(|worst, next| if next.0 > worst.0 { next } else { worst })?;
        Some(worst)
    }

    /// Returns the excess and its point on the path of a cycle.
    fn exceeded_by(&self, way: &CyclePath<'_>) -> Option<(f64, Violation)> {
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

/// Path of the tool centre point in a cycle: a straight line, which deviates from the real path by less than a tenth of
/// a millimetre.
struct CyclePath<'r> {
    from: Vector3<f64>,
    row: &'r TraceRow,
    place: usize,
}

impl<'r> CyclePath<'r> {
    fn to(place: usize, rows: &'r [TraceRow]) -> Option<Self> {
        let row = rows.get(place)?;
        let before = place.checked_sub(1).and_then(|before| rows.get(before));
        let from = before.filter(|before| before.leads_to(row)).unwrap_or(row);
        Some(Self { from: from.position(), row, place })
    }

    /// Returns the share of the path at which it enters the box; `None` if the path is outside.
    fn share_in(&self, zone: &Zone) -> Option<f64> {
        let nearest = zone.nearest(&self.from, &self.row.position());
        (nearest.distance < ROUNDING).then_some(nearest.share)
    }
}

impl TraceRow {
    /// Whether the tool centre point can have moved to the next row within one cycle. It cannot if the tool was exchanged
    /// or the arm was placed elsewhere.
    fn leads_to(&self, next: &Self) -> bool {
        (next.position() - self.position()).norm() <= next.speed * seconds(CYCLE) + ROUNDING
    }
}

#[cfg(test)]
mod tests;
