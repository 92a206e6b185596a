//! Response to a request. Only the first result counts.
//!
//! It is written by the thread that computed it, so that a long response does not delay others.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError, Weak};

use rustc_hash::FxHashMap;
use salsa::CancellationToken;
use tower_lsp::jsonrpc::{Error, Id, Result};

use crate::panics;
use crate::transport::{Pump, frame};

/// Sends the response to one request, unless the request was cancelled. If the last clone is dropped without a
/// response, an error is sent, so that the client never waits forever.
#[derive(Clone)]
pub(crate) struct Reply(Arc<Inner>);

struct Inner {
    id: Id,
    pump: Pump,
    waiting: Waiting,
    state: Mutex<ReplyState>,
}

#[derive(Default)]
struct ReplyState {
    is_answered: bool,
    /// Token that cancels the current computation.
    running: Option<CancellationToken>,
}

impl Reply {
    /// Sends a result in JSON or an error. Only the first call has an effect.
    pub(crate) fn give(&self, answer: Result<String>) {
        self.0.give(answer);
    }

    /// Registers a computation that `token` cancels. Returns false if the request no longer needs a result.
    pub(crate) fn begins(&self, token: CancellationToken) -> bool {
        let mut state = self.0.state();
        state.running = Some(token);
        !state.is_answered
    }

    /// Responds that the request was cancelled, and cancels the computation.
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
        self.waiting.end(self);
        let id = json(&self.id);
        let message = match answer {
            Ok(result) => format!("{{\"jsonrpc\":\"2.0\",\"id\":{id},\"result\":{result}}}"),
            Err(error) => format!("{{\"jsonrpc\":\"2.0\",\"id\":{id},\"error\":{}}}", json(&error)),
        };
        self.pump.write(frame(message.as_bytes()));
    }

    fn state(&self) -> MutexGuard<'_, ReplyState> {
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

/// Requests without a response yet.
#[derive(Clone, Default)]
pub(crate) struct Waiting(Arc<Mutex<FxHashMap<Id, Weak<Inner>>>>);

impl Waiting {
    /// Registers a request, whose response is written to `pump`. If an id is used twice, only the later request can be
    /// cancelled.
    pub(crate) fn begin(&self, id: Id, pump: &Pump) -> Reply {
        let state = Mutex::default();
        let reply = Reply(Arc::new(Inner { id: id.clone(), pump: pump.clone(), waiting: self.clone(), state }));
        self.map().insert(id, Arc::downgrade(&reply.0));
        reply
    }

    /// Cancels a request if it has no response yet.
    pub(crate) fn cancel(&self, id: &Id) {
        let waiting = self.map().get(id).and_then(Weak::upgrade);
        if let Some(waiting) = waiting {
            Reply(waiting).cancel();
        }
    }

    /// Removes a request after its response. A later request with the same id stays registered.
    fn end(&self, answered: &Inner) {
        let mut waiting = self.map();
        if waiting.get(&answered.id).is_some_and(|entry| std::ptr::eq(entry.as_ptr(), answered)) {
            waiting.remove(&answered.id);
        }
    }

    fn map(&self) -> MutexGuard<'_, FxHashMap<Id, Weak<Inner>>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Stores the written bytes.
    #[derive(Clone, Default)]
    struct Written(Arc<Mutex<Vec<u8>>>);

    impl std::io::Write for Written {
        fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
            self.0.lock().unwrap().write(bytes)
        }

        fn flush(&mut self) -> std::io::Result<()> {
            Ok(())
        }
    }

    #[test]
    fn the_later_of_two_requests_with_one_id_can_be_cancelled() {
        let (written, waiting, id) = (Written::default(), Waiting::default(), Id::Number(1));
        let pump = Pump::start(written.clone(), || {}).unwrap();
        let (first, second) = (waiting.begin(id.clone(), &pump), waiting.begin(id.clone(), &pump));
        first.give(Ok("7".to_owned()));
        waiting.cancel(&id);
        second.give(Ok("8".to_owned()));
        pump.finish();
        let text = String::from_utf8(written.0.lock().unwrap().clone()).unwrap();
        assert!(
            text.contains("\"result\":7") && text.contains("\"error\"") && !text.contains("\"result\":8"),
            "{text}"
        );
        assert!(waiting.map().is_empty());
    }
}
