//! Messages of the main loop to the user and the log.

use tower_lsp::lsp_types::notification::LogTrace;
use tower_lsp::lsp_types::{LogTraceParams, MessageType};

use super::ServerState;
use crate::session::TraceLevel;

impl ServerState {
    /// Reports an internal error to the user, once. The server continues.
    pub(crate) fn complain(&mut self, what: &str, reason: &str) {
        self.log(&format!("{what} failed: {reason}"));
        if !self.complained.insert(what.to_owned()) {
            return;
        }
        let message = format!("val3: {what} failed because of a fault in the language server, which continues to run");
        self.outbox.show(MessageType::ERROR, &message);
    }

    /// Warns the user that the server works without something, for example without a setting. Each warning is shown
    /// once.
    pub(crate) fn warn(&mut self, warning: &str) {
        self.log(warning);
        if self.complained.insert(warning.to_owned()) {
            self.outbox.show(MessageType::WARNING, &format!("val3: {warning}"));
        }
    }

    /// Reports the computed request to a client with tracing enabled.
    pub(super) fn trace(&mut self, method: &str) {
        if self.session.trace == TraceLevel::On {
            self.outbox.notify::<LogTrace>(LogTraceParams { message: format!("computes {method}"), verbose: None });
        }
    }

    /// Writes a line to the log.
    pub(crate) fn log(&mut self, line: &str) {
        self.log.write(line);
        self.outbox.log(MessageType::LOG, line);
    }
}
