//! `getCS8Compatibility`: the version with which the software is compatible.

use crate::structure::{operation, structure};

structure! {
    /// Request `getCS8Compatibility`.
    GetCs8Compatibility {}
}

structure! {
    /// Answer of `getCS8Compatibility`.
    GetCs8CompatibilityAnswer {
        /// Compatible version.
        compatibility: Option<String> = "compatibility",
    }
}

operation!(GetCs8Compatibility: V0 "getCS8Compatibility" => GetCs8CompatibilityAnswer, "getCS8CompatibilityResponse");
