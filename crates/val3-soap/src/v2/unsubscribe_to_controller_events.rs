//! `unsubscribeToControllerEvents`: ends the subscription to events.

use crate::structure::{operation, structure};
use crate::value::Empty;

structure! {
    /// Request `unsubscribeToControllerEvents`.
    UnsubscribeToControllerEvents {}
}

operation!(UnsubscribeToControllerEvents: V2 "unsubscribeToControllerEvents" => Empty, "unsubscribeResponse");
