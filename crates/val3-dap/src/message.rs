//! The envelope of a message.

use serde::{Deserialize, Serialize};
use serde_json::Value;

use crate::error::{MessageError, RequestError};
use crate::protocol::{ErrorResponse, Message, Response, StandardEvent, StandardRequest};

/// A message in either direction.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ProtocolMessage {
    /// Sequence number for each sender, from 1.
    pub seq: i64,
    /// The rest of the message.
    #[serde(flatten)]
    pub content: MessageContent,
}

/// A message without its number.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(tag = "type", rename_all = "camelCase")]
pub enum MessageContent {
    /// A request, of the specification or a custom one.
    Request {
        /// Name of the request.
        command: String,
        /// Arguments of the request.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        arguments: Option<Value>,
    },
    /// The response to a request.
    Response {
        /// The number of the request.
        request_seq: i64,
        /// Whether the request was executed.
        success: bool,
        /// The name of the request.
        command: String,
        /// Short reason of a failure. The protocol predefines `cancelled` and `notStopped`.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        message: Option<String>,
        /// The result, or an [`ErrorResponse`].
        #[serde(default, skip_serializing_if = "Option::is_none")]
        body: Option<Value>,
    },
    /// An event, of the specification or a custom one.
    Event {
        /// Name of the event.
        event: String,
        /// Details of the event.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        body: Option<Value>,
    },
}

impl ProtocolMessage {
    /// Parses the body of a frame.
    ///
    /// # Errors
    /// If the text is not JSON, or has no envelope.
    pub fn parse(text: &[u8]) -> Result<Self, MessageError> {
        let value: Value = serde_json::from_slice(text).map_err(MessageError::Json)?;
        let seq = value.get("seq").and_then(Value::as_i64);
        serde_json::from_value(value).map_err(|reason| MessageError::Envelope { seq, reason })
    }
}

impl MessageContent {
    /// A request.
    ///
    /// # Errors
    /// If the arguments have no JSON form.
    pub fn request(request: &StandardRequest) -> serde_json::Result<Self> {
        Ok(Self::Request { command: request.command().to_owned(), arguments: properties(request)? })
    }

    /// The response to a successful request.
    ///
    /// # Errors
    /// If the body has no JSON form.
    pub fn success(request_seq: i64, response: &Response) -> serde_json::Result<Self> {
        let (command, body) = (response.command().to_owned(), properties(response)?);
        Ok(Self::Response { request_seq, success: true, command, message: None, body })
    }

    /// The response to a successful request, with an encoded body.
    #[must_use]
    pub fn answer(request_seq: i64, command: &str, body: Option<Value>) -> Self {
        Self::Response { request_seq, success: true, command: command.to_owned(), message: None, body }
    }

    /// The response to a failed request. `reason` is the short form of `error`.
    ///
    /// # Errors
    /// If the error has no JSON form.
    pub fn failure(request_seq: i64, command: &str, reason: &str, error: Message) -> serde_json::Result<Self> {
        let body = properties(&ErrorResponse { error: Some(error) })?;
        let (command, message) = (command.to_owned(), Some(reason.to_owned()));
        Ok(Self::Response { request_seq, success: false, command, message, body })
    }

    /// An event.
    ///
    /// # Errors
    /// If the body has no JSON form.
    pub fn event(event: &StandardEvent) -> serde_json::Result<Self> {
        Ok(Self::Event { event: event.event().to_owned(), body: properties(event)? })
    }
}

/// The JSON form of arguments or a body; `None` if there are none.
fn properties(content: &impl Serialize) -> serde_json::Result<Option<Value>> {
    let value = serde_json::to_value(content)?;
    Ok((!value.is_null()).then_some(value))
}

impl StandardRequest {
    /// Decodes a request.
    ///
    /// # Errors
    /// If the specification has no such request, or the arguments do not have its type.
    pub fn parse(command: &str, arguments: Option<Value>) -> Result<Self, RequestError> {
        match Self::decode(command, arguments) {
            None => Err(RequestError::UnknownCommand { command: command.to_owned() }),
            Some(request) => request.map_err(|reason| RequestError::Arguments { command: command.to_owned(), reason }),
        }
    }
}
