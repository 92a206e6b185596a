//! `lockIos`: sets signals to values that only the client can change.

use super::SignalResponse;
use crate::structure::{operation, structure};

structure! {
    /// Request `lockIos`.
    LockIos {
        /// Signals, for example `BasicIO-1\%Q0`.
        paths: Vec<String> = "ios" of "PhysicalPath",
        /// Values, in the order of the signals; a digital signal has 0 or 1.
        values: Vec<f64> = "values" of "PhysicalIoValue",
    }
}

structure! {
    /// Answer of `lockIos`.
    LockIosAnswer {
        /// Results, in the order of the request.
        responses: Vec<SignalResponse> = "out" of "PhysicalIoResponse",
    }
}

operation!(LockIos: V2 "lockIos" => LockIosAnswer, "lockIosResponse");
