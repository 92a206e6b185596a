//! The answer that a client waits for. It is given once: the first answer counts.
//!
//! It is written on the thread that computed it, so that a long answer delays no other.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError, Weak};

use rustc_hash::FxHashMap;
use salsa::CancellationToken;
use tower_lsp::jsonrpc::{Error, Id, Result};

use crate::panics;
use crate::transport::{Pump, frame};

/// Gives the answer to one request, unless it was cancelled before. A request whose last reply is dropped is answered
/// as well: nobody may wait for ever.
#[derive(Clone)]
pub(crate) struct Reply(Arc<Inner>);

struct Inner {
    id: Id,
    pump: Pump,
    waiting: Waiting,
    state: Mutex<State>,
}

#[derive(Default)]
struct State {
    is_answered: bool,
    /// Stops the computation that is under way.
    running: Option<CancellationToken>,
}

impl Reply {
    /// Answers with a result, which is JSON, or an error. Of several answers the first counts.
    pub(crate) fn give(&self, answer: Result<String>) {
        self.0.give(answer);
    }

    /// Starts a computation that `token` stops. False if its answer is no longer waited for.
    pub(crate) fn begins(&self, token: CancellationToken) -> bool {
        let mut state = self.0.state();
        state.running = Some(token);
        !state.is_answered
    }

    /// Answers that the request was cancelled, and stops the computation.
    fn cancel(&self) {
        self.give(Err(Error::request_cancelled()));
        if let Some(running) = &self.0.state().running {
            running.cancel();
        }
    }
}

impl Inner {
    fn give(&self, answer: Result<String>) {
        if std::mem::replace(&mut self.state().is_answered, true) {
            return;
        }
        self.waiting.map().remove(&self.id);
        let id = json(&self.id);
        let message = match answer {
            Ok(result) => format!("{{\"jsonrpc\":\"2.0\",\"id\":{id},\"result\":{result}}}"),
            Err(error) => format!("{{\"jsonrpc\":\"2.0\",\"id\":{id},\"error\":{}}}", json(&error)),
        };
        self.pump.write(frame(message.as_bytes()));
    }

    fn state(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Drop for Inner {
    fn drop(&mut self) {
        self.give(Err(panics::lost()));
    }
}

fn json(value: &impl serde::Serialize) -> String {
    serde_json::to_string(value).unwrap_or_else(|_| "null".to_owned())
}

/// The requests that wait for an answer.
#[derive(Clone, Default)]
pub(crate) struct Waiting(Arc<Mutex<FxHashMap<Id, Weak<Inner>>>>);

impl Waiting {
    /// Notes a request, whose answer goes to `pump`. Of two with one id the later can be cancelled.
    pub(crate) fn begin(&self, id: Id, pump: &Pump) -> Reply {
        let state = Mutex::default();
        let reply = Reply(Arc::new(Inner { id: id.clone(), pump: pump.clone(), waiting: self.clone(), state }));
        self.map().insert(id, Arc::downgrade(&reply.0));
        reply
    }

    /// Cancels a request, if it still waits.
    pub(crate) fn cancel(&self, id: &Id) {
        let waiting = self.map().get(id).and_then(Weak::upgrade);
        if let Some(waiting) = waiting {
            Reply(waiting).cancel();
        }
    }

    fn map(&self) -> MutexGuard<'_, FxHashMap<Id, Weak<Inner>>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
