//! Small traces for tests.

use val3_geometry::{IsometryMatrix3, Trsf};
use val3_motion::Phase;

use crate::row::{Row, Trace};

/// Rows along x, a millimetre and a degree of axis 1 a cycle, ten a move from 1 on.
pub(crate) fn line(count: usize) -> Vec<Row> {
    let row = |index: usize| {
        let x = index as f64;
        Row {
            time: index as u64 * 4_000_000,
            id: 1.0 + (x / 10.0).max(0.05),
            phase: Phase::Nominal,
            joints: [x, 0.0, 0.0, 0.0, 0.0, 0.0],
            pose: Trsf::new([x, 0.0, 0.0], [0.0; 3]).isometry(),
            speed: 250.0,
        }
    };
    (0..count).map(row).collect()
}

/// A row moved in world and turned about itself.
pub(crate) fn at(row: &Row, way: [f64; 3], turn: [f64; 3]) -> Row {
    let moved = Trsf::new(way, [0.0; 3]).isometry() * row.pose * Trsf::new([0.0; 3], turn).isometry();
    Row { pose: IsometryMatrix3::from_parts(moved.translation, moved.rotation), ..*row }
}

/// A trace of a six-axis arm.
pub(crate) fn trace(rows: &[Row]) -> Trace {
    Trace { arm: Some("TX2-90".to_owned()), axes: 6, rows: rows.to_vec() }
}
