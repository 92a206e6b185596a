//! `subscribeToControllerEvents`: requests events at an address of the client.

use crate::structure::{operation, structure};
use crate::value::Empty;

structure! {
    /// Request `subscribeToControllerEvents`.
    SubscribeToControllerEvents {
        /// Address of the event service.
        service_url: Option<String> = "serviceUrl",
        /// Time between two messages, probably in ms.
        send_interval: i32 = "sendInterval",
    }
}

operation!(SubscribeToControllerEvents: V2 "subscribeToControllerEvents" => Empty, "subscribeResponse");
