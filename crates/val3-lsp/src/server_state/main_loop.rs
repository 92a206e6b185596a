//! The main loop: processes messages in order, and deferred work while the inbox is empty.

use std::sync::Arc;
use std::sync::mpsc::{Receiver, RecvTimeoutError, TryRecvError};
use std::time::Duration;

use salsa::{Cancelled, Database as _};
use tower_lsp::jsonrpc::Error;
use val3_analysis::db::Db as _;

use super::{ServerState, TREES};
use crate::inbox::MainLoopAction;
use crate::job::{Job, OnEdit};
use crate::panics::{self, contained};
use crate::reply::Reply;

/// Time limit for the client's response to the progress request.
const TIMEOUT: Duration = Duration::from_secs(1);

impl ServerState {
    /// Processes messages until the inbox is closed.
    pub(crate) fn run(mut self, inbox: &Receiver<MainLoopAction>) {
        loop {
            let message = match inbox.try_recv() {
                Ok(message) => message,
                Err(TryRecvError::Disconnected) => break,
                Err(TryRecvError::Empty) => match self.next(inbox) {
                    Some(message) => message,
                    None => break,
                },
            };
            if let Err(reason) = contained(|| message(&mut self)) {
                self.complain("an event", &reason);
            }
        }
        // The process ends, so dropping the database would only cost time.
        std::mem::forget(self.workspace);
    }

    /// Executes deferred work and waits for a message. The first scan starts only after the client has responded to the
    /// progress request. `None` if the inbox is closed.
    fn next(&mut self, inbox: &Receiver<MainLoopAction>) -> Option<MainLoopAction> {
        if !self.is_ready {
            return inbox.recv().ok();
        }
        if self.awaits_progress() {
            match inbox.recv_timeout(TIMEOUT) {
                Err(RecvTimeoutError::Timeout) => self.end_progress(),
                answer => return answer.ok(),
            }
        }
        self.settle();
        inbox.recv().ok()
    }

    /// Executes deferred work, because the inbox is empty.
    fn settle(&mut self) {
        let settled = contained(|| {
            self.bring_up_to_date();
            self.check();
            self.tidy();
        });
        if let Err(reason) = settled {
            self.complain("reading the workspace", &reason);
        }
    }

    /// Computes a request on the state that results from all earlier messages.
    pub(crate) fn compute(&mut self, job: Job, reply: Reply) {
        self.bring_up_to_date();
        self.trace(job.method);
        let snapshot = self.snapshot();
        if !reply.begins(snapshot.db.cancellation_token()) {
            return;
        }
        let (inbox, edits) = (self.inbox.clone(), self.edits);
        self.pool.spawn(job.priority, move || {
            let outcome = contained(|| Cancelled::catch(std::panic::AssertUnwindSafe(|| (job.compute)(&snapshot))));
            let has_surplus = Self::has_many_trees(&snapshot.db);
            // Dropped before the reply: a write blocks until all snapshots are dropped.
            drop(snapshot);
            if has_surplus {
                inbox.post(|server| server.has_surplus = true);
            }
            match outcome {
                Ok(Ok(Ok(Some(answer)))) => reply.give(Ok(answer)),
                Ok(Ok(Ok(None))) => inbox.post(move |server| server.continue_with(job, reply)),
                Ok(Ok(Err(error))) => reply.give(Err(error)),
                Ok(Err(Cancelled::Local)) => reply.give(Err(Error::request_cancelled())),
                Ok(Err(_)) => inbox.post(move |server| server.retry(job, reply, edits)),
                Err(reason) => {
                    reply.give(Err(panics::internal_error(job.method, &reason)));
                    inbox.post(move |server| server.complain(job.method, &reason));
                }
            }
        });
    }

    /// Computes the next part of a request. If no other thread reads the database, the data of the last part are freed
    /// first.
    fn continue_with(&mut self, job: Job, reply: Reply) {
        self.has_surplus = true;
        self.workspace.db.trees().keep_latest(TREES);
        self.tidy();
        self.compute(job, reply);
    }

    /// Computes a cancelled request again, or returns `ContentModified` if its positions are invalid after an edit.
    fn retry(&mut self, job: Job, reply: Reply, edits: u64) {
        if job.on_edit == OnEdit::Refuse && edits != self.edits {
            reply.give(Err(Error::content_modified()));
        } else {
            self.compute(job, reply);
        }
    }

    /// Frees data of earlier revisions while no thread computes, so that the next edit is faster.
    fn tidy(&mut self) {
        if self.has_surplus && Arc::strong_count(&self.readers) == 1 {
            self.forget_surplus();
        }
    }
}
