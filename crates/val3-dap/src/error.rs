//! Errors of the protocol.

use std::collections::BTreeMap;
use std::fmt;
use std::io;

use crate::frame::{BODY_LIMIT, HEADER_LIMIT};
use crate::message::MessageContent;
use crate::protocol::Message;

/// Reason why a request cannot be decoded. The response is [`RequestError::response`].
#[derive(Debug)]
pub enum RequestError {
    /// The specification has no request of this name. It may be a custom one.
    UnknownCommand {
        /// The name.
        command: String,
    },
    /// The arguments have another type.
    Arguments {
        /// The name of the request.
        command: String,
        /// The first mismatch.
        reason: serde_json::Error,
    },
}

impl RequestError {
    /// Returns the failed response to the request with the number `request_seq`.
    ///
    /// # Errors
    /// If the message has no JSON form.
    pub fn response(&self, request_seq: i64) -> serde_json::Result<MessageContent> {
        let (id, command, reason) = match self {
            Self::UnknownCommand { command } => (1, command, None),
            Self::Arguments { command, reason } => (2, command, Some(reason.to_string())),
        };
        // Name and reason are passed as variables, so that braces in them are not read as placeholders.
        let format = match reason {
            None => "the request `{command}` is unknown",
            Some(_) => "the arguments of `{command}` are wrong: {reason}",
        };
        let variables = [("command", Some(command.clone())), ("reason", reason)];
        let variables = variables.into_iter().filter_map(|(name, value)| Some((name.to_owned(), value?)));
        let error = Message {
            id,
            format: format.to_owned(),
            variables: Some(variables.collect::<BTreeMap<_, _>>()),
            ..Message::default()
        };
        MessageContent::failure(request_seq, command, &self.to_string(), error)
    }
}

impl fmt::Display for RequestError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::UnknownCommand { command } => write!(formatter, "the request `{command}` is unknown"),
            Self::Arguments { command, reason } => {
                write!(formatter, "the arguments of `{command}` are wrong: {reason}")
            }
        }
    }
}

impl std::error::Error for RequestError {}

/// The reason why the body of a frame is no message.
#[derive(Debug)]
pub enum MessageError {
    /// The text is not JSON.
    Json(serde_json::Error),
    /// A property of the envelope is missing or has another type.
    Envelope {
        /// The number of the message, if it has one.
        seq: Option<i64>,
        /// The first mismatch.
        reason: serde_json::Error,
    },
}

impl fmt::Display for MessageError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Json(reason) => write!(formatter, "the message is not JSON: {reason}"),
            Self::Envelope { seq: None, reason } => write!(formatter, "the message has no envelope: {reason}"),
            Self::Envelope { seq: Some(seq), reason } => {
                write!(formatter, "the message {seq} has no envelope: {reason}")
            }
        }
    }
}

impl std::error::Error for MessageError {}

/// A fault of a frame.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum HeaderError {
    /// Bytes that are no header. Contains the beginning of the text.
    Garbage(String),
    /// The header has no `Content-Length`.
    NoLength,
    /// The value of `Content-Length` is not a number.
    Length(String),
    /// The header has more than [`HEADER_LIMIT`] bytes.
    HeaderSize,
    /// The body has more than [`BODY_LIMIT`] bytes.
    BodySize(u64),
    /// The input ends inside a frame.
    Truncated,
}

impl fmt::Display for HeaderError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Garbage(text) => write!(formatter, "{text:?} is not a header of a message"),
            Self::NoLength => write!(formatter, "the header of the message has no `Content-Length`"),
            Self::Length(value) => write!(formatter, "the value of `Content-Length` is not a number: {value:?}"),
            Self::HeaderSize => write!(formatter, "the header of the message has more than {HEADER_LIMIT} bytes"),
            Self::BodySize(length) => {
                write!(formatter, "the message has {length} bytes, more than the limit of {BODY_LIMIT}")
            }
            Self::Truncated => write!(formatter, "the input ends inside a message"),
        }
    }
}

impl std::error::Error for HeaderError {}

/// The reason why no message could be read.
#[derive(Debug)]
pub enum ReadError {
    /// The input cannot be read.
    Io(io::Error),
    /// A frame is wrong.
    Frame(HeaderError),
    /// The content of a frame is wrong.
    Message(MessageError),
}

impl ReadError {
    /// Whether the next message can be read: its beginning is known, or can be searched for.
    pub const fn can_continue(&self) -> bool {
        matches!(self, Self::Message(_) | Self::Frame(HeaderError::Garbage(_) | HeaderError::NoLength))
    }
}

impl fmt::Display for ReadError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Io(error) => error.fmt(formatter),
            Self::Frame(error) => error.fmt(formatter),
            Self::Message(error) => error.fmt(formatter),
        }
    }
}

impl std::error::Error for ReadError {}

impl From<io::Error> for ReadError {
    fn from(error: io::Error) -> Self {
        Self::Io(error)
    }
}

impl From<HeaderError> for ReadError {
    fn from(error: HeaderError) -> Self {
        Self::Frame(error)
    }
}

impl From<MessageError> for ReadError {
    fn from(error: MessageError) -> Self {
        Self::Message(error)
    }
}
