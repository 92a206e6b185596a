//! Positions as matrices.

use crate::structure::structure;

structure! {
    /// Position and orientation: the columns n (x axis), o (y axis) and a (z axis), and the origin p in m.
    Matrix {
        /// X axis, coordinate x.
        nx: f64 = "nx",
        /// X axis, coordinate y.
        ny: f64 = "ny",
        /// X axis, coordinate z.
        nz: f64 = "nz",
        /// Y axis, coordinate x.
        ox: f64 = "ox",
        /// Y axis, coordinate y.
        oy: f64 = "oy",
        /// Y axis, coordinate z.
        oz: f64 = "oz",
        /// Z axis, coordinate x.
        ax: f64 = "ax",
        /// Z axis, coordinate y.
        ay: f64 = "ay",
        /// Z axis, coordinate z.
        az: f64 = "az",
        /// Origin, coordinate x, in m.
        px: f64 = "px",
        /// Origin, coordinate y, in m.
        py: f64 = "py",
        /// Origin, coordinate z, in m.
        pz: f64 = "pz",
    }
}
