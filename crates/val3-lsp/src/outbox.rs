//! Notifications and requests to the client.

use std::sync::atomic::{AtomicI64, Ordering};
use std::sync::{Arc, Mutex, PoisonError};

use rustc_hash::FxHashMap;
use serde_json::{Value, json};
use tower_lsp::lsp_types::notification::{LogMessage, Notification, ShowMessage};
use tower_lsp::lsp_types::request::Request;
use tower_lsp::lsp_types::{LogMessageParams, MessageType, ShowMessageParams};

use crate::inbox::Inbox;
use crate::server_state::ServerState;
use crate::transport::{Pump, frame};

type ResponseHandler = Box<dyn FnOnce(&mut ServerState, Result<Value, Value>) + Send>;

/// The way to the client; it never waits.
#[derive(Clone)]
pub(crate) struct Outbox {
    pump: Pump,
    inbox: Inbox,
    next: Arc<AtomicI64>,
    waiting: Arc<Mutex<FxHashMap<i64, ResponseHandler>>>,
}

impl Outbox {
    /// Answers of the client go to the main loop through `inbox`.
    pub(crate) fn new(pump: Pump, inbox: Inbox) -> Self {
        Self { pump, inbox, next: Arc::default(), waiting: Arc::default() }
    }

    /// Sends a notification.
    pub(crate) fn notify<N: Notification>(&self, params: N::Params) {
        self.send(&json!({ "jsonrpc": "2.0", "method": N::METHOD, "params": params }));
    }

    /// Asks the client; `answered` runs on the main loop if it answers.
    pub(crate) fn ask<R: Request>(
        &self,
        params: R::Params,
        answered: impl FnOnce(&mut ServerState, Option<R::Result>) + Send + 'static,
    ) {
        let id = self.next.fetch_add(1, Ordering::Relaxed);
        let read = move |server: &mut ServerState, answer: Result<Value, Value>| match answer {
            Ok(value) => answered(server, serde_json::from_value(value).ok()),
            Err(error) => {
                server.log(&format!("the client refused `{}`: {error}", R::METHOD));
                answered(server, None);
            }
        };
        self.waiting.lock().unwrap_or_else(PoisonError::into_inner).insert(id, Box::new(read));
        self.send(&json!({ "jsonrpc": "2.0", "id": id, "method": R::METHOD, "params": params }));
    }

    /// The client answered. An answer without a waiting request is ignored.
    pub(crate) fn answered(&self, id: i64, answer: Result<Value, Value>) {
        let waiting = self.waiting.lock().unwrap_or_else(PoisonError::into_inner).remove(&id);
        if let Some(answered) = waiting {
            self.inbox.post(move |server| answered(server, answer));
        }
    }

    /// Shows a message to the user.
    pub(crate) fn show(&self, typ: MessageType, message: &str) {
        self.notify::<ShowMessage>(ShowMessageParams { typ, message: message.to_owned() });
    }

    /// Writes a line into the log that the client shows.
    pub(crate) fn log(&self, typ: MessageType, message: &str) {
        self.notify::<LogMessage>(LogMessageParams { typ, message: message.to_owned() });
    }

    fn send(&self, message: &Value) {
        self.pump.write(frame(message.to_string().as_bytes()));
    }
}
