//! `getCS8Versions`: versions of the software.

use super::SoftwareVersion;
use crate::structure::{operation, structure};

structure! {
    /// Request `getCS8Versions`.
    GetCs8Versions {}
}

structure! {
    /// Answer of `getCS8Versions`.
    GetCs8VersionsAnswer {
        /// Parts of the software.
        versions: Vec<SoftwareVersion> = "out" of "Versions",
    }
}

operation!(GetCs8Versions: V0 "getCS8Versions" => GetCs8VersionsAnswer, "getCS8VersionsResponse");
