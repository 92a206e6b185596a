//! Messages to the main loop, in their order.

use std::sync::mpsc::{Receiver, Sender, channel};

use crate::server_state::ServerState;

/// Something for the main loop to do.
pub(crate) type Message = Box<dyn FnOnce(&mut ServerState) + Send>;

/// The way to the main loop. It takes any number of messages and never waits.
#[derive(Clone)]
pub(crate) struct Inbox(Sender<Message>);

impl Inbox {
    /// An inbox and the end that the main loop reads.
    pub(crate) fn new() -> (Self, Receiver<Message>) {
        let (sender, receiver) = channel();
        (Self(sender), receiver)
    }

    /// Adds a message at the end. Once the main loop has ended, no receiver is left.
    pub(crate) fn post(&self, message: impl FnOnce(&mut ServerState) + Send + 'static) {
        let _ = self.0.send(Box::new(message));
    }
}
