//! The answer that a client waits for: given once, by whoever is first.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use rustc_hash::FxHashMap;
use salsa::CancellationToken;
use serde_json::Value;
use tokio::sync::oneshot;
use tower_lsp::jsonrpc::{Error, Id, Result};

/// Gives the answer to one request, unless it was cancelled before.
#[derive(Clone)]
pub(crate) struct Reply(Arc<Mutex<State>>);

struct State {
    /// `None` once the answer was given.
    waiting: Option<oneshot::Sender<Result<Value>>>,
    /// Stops the computation that is under way.
    running: Option<CancellationToken>,
}

impl Reply {
    /// A reply and the end that waits for it.
    pub(crate) fn new() -> (Self, oneshot::Receiver<Result<Value>>) {
        let (sender, receiver) = oneshot::channel();
        (Self(Arc::new(Mutex::new(State { waiting: Some(sender), running: None }))), receiver)
    }

    /// Answers. Of several answers the first counts.
    pub(crate) fn give(&self, answer: Result<Value>) {
        if let Some(waiting) = self.state().waiting.take() {
            // A client that is gone waits for nothing.
            let _ = waiting.send(answer);
        }
    }

    /// A computation begins that `token` stops; false if nobody waits for it any more.
    pub(crate) fn begins(&self, token: CancellationToken) -> bool {
        let mut state = self.state();
        state.running = Some(token);
        state.waiting.is_some()
    }

    /// Answers that the request was cancelled, and stops the computation.
    pub(crate) fn cancel(&self) {
        self.give(Err(Error::request_cancelled()));
        if let Some(running) = &self.state().running {
            running.cancel();
        }
    }

    fn state(&self) -> MutexGuard<'_, State> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// The requests that wait for an answer.
#[derive(Clone, Default)]
pub(crate) struct Waiting(Arc<Mutex<FxHashMap<Id, Reply>>>);

impl Waiting {
    /// Notes a request; false if another one of this id waits.
    pub(crate) fn add(&self, id: Id, reply: Reply) -> bool {
        self.map().insert(id, reply).is_none()
    }

    /// A request was answered.
    pub(crate) fn remove(&self, id: &Id) {
        self.map().remove(id);
    }

    /// Cancels a request, if it still waits.
    pub(crate) fn cancel(&self, id: &Id) {
        let reply = self.map().get(id).cloned();
        if let Some(reply) = reply {
            reply.cancel();
        }
    }

    fn map(&self) -> MutexGuard<'_, FxHashMap<Id, Reply>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
