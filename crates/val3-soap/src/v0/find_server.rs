//! `findServer`: whether the controller has a server.

use crate::structure::{operation, structure};

structure! {
    /// Request `findServer`.
    FindServer {
        /// Path of the server, for example `/CS8ServerV2`.
        server_name: Option<String> = "serverName",
    }
}

structure! {
    /// Answer of `findServer`.
    FindServerAnswer {
        /// Whether the controller has the server.
        found: bool = "found",
    }
}

operation!(FindServer: V0 "findServer" => FindServerAnswer, "findServerResponse", without session);
