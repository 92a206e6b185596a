//! `unlockAllIos`: unlocks all signals.

use crate::structure::{operation, structure};

structure! {
    /// Request `unlockAllIos`.
    UnlockAllIos {}
}

structure! {
    /// Answer of `unlockAllIos`.
    UnlockAllIosAnswer {
        /// Number of unlocked signals.
        successes: i32 = "nbSuccess",
    }
}

operation!(UnlockAllIos: V2 "unlockAllIos" => UnlockAllIosAnswer, "SoapAllPhysicalIoResponse");
