//! Geometry of arms.

use crate::structure::structure;

structure! {
    /// Denavit-Hartenberg parameters of a joint.
    DhParameters {
        /// Angle about z, in rad.
        theta: f64 = "theta",
        /// Distance along z, in m.
        d: f64 = "d",
        /// Distance along x, in m.
        a: f64 = "a",
        /// Angle about x, in rad.
        alpha: f64 = "alpha",
        /// Angle about y, in rad.
        beta: f64 = "beta",
    }
}
