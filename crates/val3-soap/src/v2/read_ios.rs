//! `readIos`: the states of signals.

use super::SignalState;
use crate::structure::{operation, structure};

structure! {
    /// Request `readIos`.
    ReadIos {
        /// Signals, for example `BasicIO-1\%Q0`.
        paths: Vec<String> = "ios" of "PhysicalPath",
        /// Whether the answer contains descriptions.
        with_description: bool = "x-getDescription",
    }
}

structure! {
    /// Answer of `readIos`.
    ReadIosAnswer {
        /// States, in the order of the request.
        states: Vec<SignalState> = "state" of "PhysicalIoState",
    }
}

operation!(ReadIos: V2 "readIos" => ReadIosAnswer, "readIosResponse");
