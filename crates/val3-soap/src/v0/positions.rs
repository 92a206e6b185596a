//! Positions as coordinates and angles.

use crate::structure::structure;

structure! {
    /// Position and orientation.
    CartesianPosition {
        /// Coordinate x, in m.
        x: f64 = "x",
        /// Coordinate y, in m.
        y: f64 = "y",
        /// Coordinate z, in m.
        z: f64 = "z",
        /// First angle, about x, in rad.
        rx: f64 = "rx",
        /// Second angle, about the new y, in rad.
        ry: f64 = "ry",
        /// Third angle, about the new z, in rad.
        rz: f64 = "rz",
    }
}
