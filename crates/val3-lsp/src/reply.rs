//! The answer that a client waits for. It is given once: the first answer counts.
//!
//! It is written on the thread that computed it, so that a long answer does not delay the others.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError, Weak};

use rustc_hash::FxHashMap;
use salsa::CancellationToken;
use tower_lsp::jsonrpc::{Error, Id, Result};

use crate::panics;
use crate::transport::{Pump, frame};

/// Gives the answer to one request, unless it was cancelled before. A request whose last reply is dropped is answered
/// with an error, so that the client never waits for ever.
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
        self.waiting.end(self);
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

    /// Forgets an answered request. A later one with the same id keeps its entry.
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

    /// Keeps the written bytes.
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
