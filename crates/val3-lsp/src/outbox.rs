//! Notifications and requests to the client.

use std::sync::atomic::{AtomicI64, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use rustc_hash::FxHashMap;
use serde_json::{Value, json};
use tower_lsp::lsp_types::notification::{LogMessage, Notification, ShowMessage};
use tower_lsp::lsp_types::request::Request;
use tower_lsp::lsp_types::{LogMessageParams, MessageType, ShowMessageParams};

use crate::transport::{Pump, frame};

/// Sender of messages to the client; it never blocks.
#[derive(Clone)]
pub(crate) struct Outbox {
    pump: Pump,
    next: Arc<AtomicI64>,
    /// Methods of pending requests, by id.
    waiting: Arc<Mutex<FxHashMap<i64, &'static str>>>,
}

impl Outbox {
    /// Creates an outbox that writes to `pump`.
    pub(crate) fn new(pump: Pump) -> Self {
        Self { pump, next: Arc::default(), waiting: Arc::default() }
    }

    /// Sends a notification.
    pub(crate) fn notify<N: Notification>(&self, params: N::Params) {
        self.send(&json!({ "jsonrpc": "2.0", "method": N::METHOD, "params": params }));
    }

    /// Sends a request and returns its id.
    pub(crate) fn request<R: Request>(&self, params: R::Params) -> i64 {
        let id = self.next.fetch_add(1, Ordering::Relaxed);
        self.waiting().insert(id, R::METHOD);
        self.send(&json!({ "jsonrpc": "2.0", "id": id, "method": R::METHOD, "params": params }));
        id
    }

    /// Removes a pending request after its response, and returns its method. `None` if no request with this id is
    /// pending.
    pub(crate) fn answered(&self, id: i64) -> Option<&'static str> {
        self.waiting().remove(&id)
    }

    fn waiting(&self) -> MutexGuard<'_, FxHashMap<i64, &'static str>> {
        self.waiting.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Shows a message to the user.
    pub(crate) fn show(&self, typ: MessageType, message: &str) {
        self.notify::<ShowMessage>(ShowMessageParams { typ, message: message.to_owned() });
    }

    /// Writes a line to the client's log.
    pub(crate) fn log(&self, typ: MessageType, message: &str) {
        self.notify::<LogMessage>(LogMessageParams { typ, message: message.to_owned() });
    }

    fn send(&self, message: &Value) {
        self.pump.write(frame(message.to_string().as_bytes()));
    }
}
