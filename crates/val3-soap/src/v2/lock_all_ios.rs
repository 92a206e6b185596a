//! `lockAllIos`: locks all signals.

use crate::structure::{operation, structure};

structure! {
    /// Request `lockAllIos`.
    LockAllIos {}
}

structure! {
    /// Answer of `lockAllIos`.
    LockAllIosAnswer {
        /// Number of locked signals.
        successes: i32 = "nbSuccess",
    }
}

operation!(LockAllIos: V2 "lockAllIos" => LockAllIosAnswer, "SoapAllPhysicalIoResponse");
