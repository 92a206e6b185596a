//! Small traces for tests.

use val3_geometry::{IsometryMatrix3, Trsf};
use val3_motion::MotionPhase;

use crate::row::{Trace, TraceRow};

/// Returns rows along x. Between rows, x increases by 1 mm and axis 1 by 1 degree. Every move has ten rows, the first
/// move has number 1.
pub(crate) fn line(count: usize) -> Vec<TraceRow> {
    (0..count).map(row).collect()
}

fn row(index: usize) -> TraceRow {
    let x = index as f64;
    TraceRow {
        time: index as u64 * 4_000_000,
        id: 1.0 + (x / 10.0).max(0.05),
        phase: MotionPhase::Nominal,
        joints: [x, 0.0, 0.0, 0.0, 0.0, 0.0],
        pose: Trsf::new([x, 0.0, 0.0], [0.0; 3]).isometry(),
        speed: 250.0,
    }
}

/// Moves a row in world and turns it about its own axes.
pub(crate) fn at(row: &TraceRow, way: [f64; 3], turn: [f64; 3]) -> TraceRow {
    let moved = Trsf::new(way, [0.0; 3]).isometry() * row.pose * Trsf::new([0.0; 3], turn).isometry();
    TraceRow { pose: IsometryMatrix3::from_parts(moved.translation, moved.rotation), ..*row }
}

/// Returns a trace of a six-axis arm.
pub(crate) fn trace(rows: &[TraceRow]) -> Trace {
    Trace { arm: Some("TX2-90".to_owned()), axes: 6, rows: rows.to_vec() }
}
