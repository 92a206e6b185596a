//! The reading thread. It passes valid requests to tower-lsp. Malformed messages, which would end tower-lsp's loop or
//! cause a panic in its request table, are rejected here, and responses of the client bypass tower-lsp.

use std::io::{self, BufRead};
use std::pin::Pin;
use std::task::{Context, Poll};

use futures::Stream as _;
use futures::channel::mpsc::{UnboundedReceiver, UnboundedSender, unbounded};
use serde::Deserialize;
use serde::de::IgnoredAny;
use serde_json::{Value, json};
use tokio::io::{AsyncRead, ReadBuf};
use tower_lsp::jsonrpc::Id;
use val3_syntax::TextSlice;

use super::frame::{FramingError, frame, read_message};
use super::pump::Pump;

/// Input stream of tower-lsp: framed messages.
pub(crate) struct Intake {
    messages: UnboundedReceiver<Vec<u8>>,
    rest: Vec<u8>,
    read: usize,
}

impl Intake {
    /// Creates an intake and the sender that fills it.
    pub(crate) fn new() -> (UnboundedSender<Vec<u8>>, Self) {
        let (sender, messages) = unbounded();
        (sender, Self { messages, rest: Vec::new(), read: 0 })
    }
}

impl AsyncRead for Intake {
    fn poll_read(
        mut self: Pin<&mut Self>,
        context: &mut Context<'_>,
        buffer: &mut ReadBuf<'_>,
    ) -> Poll<io::Result<()>> {
        if self.read == self.rest.len() {
            match Pin::new(&mut self.messages).poll_next(context) {
                Poll::Pending => return Poll::Pending,
                Poll::Ready(None) => return Poll::Ready(Ok(())),
                Poll::Ready(Some(message)) => (self.rest, self.read) = (message, 0),
            }
        }
        let length = buffer.remaining().min(self.rest.len() - self.read);
        let part = self.rest.part(self.read..self.read + length);
        buffer.put_slice(part);
        self.read += length;
        Poll::Ready(Ok(()))
    }
}

/// Message fields that the transport needs.
#[derive(Deserialize)]
struct Envelope<'a> {
    jsonrpc: &'a str,
    #[serde(default)]
    id: Option<Id>,
    #[serde(default)]
    method: Option<std::borrow::Cow<'a, str>>,
    #[serde(default)]
    result: Option<Value>,
    #[serde(default)]
    error: Option<Value>,
    #[serde(default, rename = "params")]
    _params: Option<IgnoredAny>,
}

/// Reads until the end of the input or an unrecoverable framing error. `answered` receives the client's responses by
/// request id.
pub(crate) fn read(
    mut input: impl BufRead,
    requests: &UnboundedSender<Vec<u8>>,
    answered: impl Fn(i64, Result<Value, Value>),
    pump: &Pump,
) {
    loop {
        let message = match read_message(&mut input) {
            Ok(Some(Ok(message))) => message,
            Ok(Some(Err(FramingError::Head))) => {
                refuse(pump, -32700, "a message begins with `Content-Length`");
                continue;
            }
            Ok(Some(Err(FramingError::Length))) => {
                refuse(pump, -32700, "the value of `Content-Length` is not a number");
                return;
            }
            Ok(Some(Err(FramingError::Size))) => {
                refuse(pump, -32700, "the message is too large");
                return;
            }
            Ok(None) | Err(_) => return,
        };
        match serde_json::from_slice::<Envelope<'_>>(&message) {
            Ok(Envelope { jsonrpc: "2.0", method: Some(_), .. }) => {
                if requests.unbounded_send(frame(&message)).is_err() {
                    return;
                }
            }
            Ok(Envelope { jsonrpc: "2.0", id: Some(Id::Number(id)), result, error, .. }) => {
                answered(id, error.map_or(Ok(result.unwrap_or(Value::Null)), Err));
            }
            Ok(_) => refuse(pump, -32600, "this is not a request"),
            Err(error) if error.is_data() => refuse(pump, -32600, "this is not a request"),
            Err(_) => refuse(pump, -32700, "this is not JSON"),
        }
    }
}

/// Sends an error for a message whose id is unknown.
fn refuse(pump: &Pump, code: i64, message: &str) {
    let answer = json!({ "jsonrpc": "2.0", "id": null, "error": { "code": code, "message": message } });
    pump.write(frame(answer.to_string().as_bytes()));
}
