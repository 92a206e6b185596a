//! Queue of messages to the main loop.

use std::sync::mpsc::{Receiver, Sender, channel};

use crate::server_state::ServerState;

/// Action for the main loop.
pub(crate) type MainLoopAction = Box<dyn FnOnce(&mut ServerState) + Send>;

/// Sender to the main loop. The queue is unbounded, so sending never blocks.
#[derive(Clone)]
pub(crate) struct Inbox(Sender<MainLoopAction>);

impl Inbox {
    /// Creates an inbox and the receiver for the main loop.
    pub(crate) fn new() -> (Self, Receiver<MainLoopAction>) {
        let (sender, receiver) = channel();
        (Self(sender), receiver)
    }

    /// Appends a message. After the main loop has ended, the message is dropped.
    pub(crate) fn post(&self, message: impl FnOnce(&mut ServerState) + Send + 'static) {
        let _ = self.0.send(Box::new(message));
    }
}
