//! `unlockIos`: returns locked signals to the application.

use super::UnlockedSignal;
use crate::structure::{operation, structure};

structure! {
    /// Request `unlockIos`.
    UnlockIos {
        /// Signals, for example `BasicIO-1\%Q0`.
        paths: Vec<String> = "ios" of "PhysicalPath",
        /// Whether the answer contains descriptions.
        with_description: bool = "x-getDescription",
    }
}

structure! {
    /// Answer of `unlockIos`.
    UnlockIosAnswer {
        /// Results, in the order of the request.
        responses: Vec<UnlockedSignal> = "out" of "PhysicalIoResponse",
    }
}

operation!(UnlockIos: V2 "unlockIos" => UnlockIosAnswer, "unlockIosResponse");
