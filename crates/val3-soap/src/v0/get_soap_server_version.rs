//! `getSoapServerVersion`: the version of the interface.

use super::InterfaceVersion;
use crate::structure::{operation, structure};

structure! {
    /// Request `getSoapServerVersion`.
    GetSoapServerVersion {
        /// Name of the client.
        client_name: Option<String> = "cltName",
        /// Version of the client.
        client_version: Option<String> = "cltVersion",
    }
}

structure! {
    /// Answer of `getSoapServerVersion`.
    GetSoapServerVersionAnswer {
        /// Version of the interface.
        server: InterfaceVersion = "server",
    }
}

operation!(GetSoapServerVersion: V0 "getSoapServerVersion" => GetSoapServerVersionAnswer, "getSoapServerVersionResponse", without session);
