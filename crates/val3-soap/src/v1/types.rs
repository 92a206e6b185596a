//! Structures that several operations share.

use crate::structure::structure;

structure! {
    /// Application of a controller.
    ListedApplication {
        /// Project, for example `Disk://name/name.pjx`.
        name: Option<String> = "name",
        /// Whether the application is in memory.
        loaded: bool = "loaded",
    }
}

structure! {
    /// Limits of joints, in rad or m.
    JointRange {
        /// Lower limits, by joint.
        min: Vec<f64> = "min",
        /// Upper limits, by joint.
        max: Vec<f64> = "max",
    }
}
