//! `ping`: whether the controller responds.

use crate::structure::{operation, structure};

structure! {
    /// Request `ping`.
    Ping {
        /// Any text.
        message: Option<String> = "message",
    }
}

structure! {
    /// Answer of `ping`.
    PingAnswer {
        /// Text of the request.
        message: Option<String> = "message",
    }
}

operation!(Ping: V0 "ping" => PingAnswer, "pingResponse", without session);
