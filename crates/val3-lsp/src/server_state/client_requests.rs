//! Requests to the client whose responses the main loop handles.

use serde_json::Value;
use tower_lsp::lsp_types::request::Request;

use super::ServerState;

impl ServerState {
    /// Sends a request to the client; `answered` runs on the main loop after the response.
    pub(crate) fn ask_client<R: Request>(
        &mut self,
        params: R::Params,
        answered: impl FnOnce(&mut Self, Option<R::Result>) + Send + 'static,
    ) {
        let id = self.outbox.request::<R>(params);
        let handler = Box::new(move |server: &mut Self, answer: Option<Value>| {
            answered(server, answer.and_then(|answer| serde_json::from_value(answer).ok()));
        });
        self.answer_handlers.insert(id, handler);
    }

    /// Handles a response of the client. A response to no pending request is ignored.
    pub(crate) fn answered(&mut self, id: i64, answer: Result<Value, Value>) {
        let Some(method) = self.outbox.answered(id) else { return };
        if let Err(error) = &answer {
            self.log(&format!("the client refused `{method}`: {error}"));
        }
        if let Some(answered) = self.answer_handlers.remove(&id) {
            answered(self, answer.ok());
        }
    }
}
