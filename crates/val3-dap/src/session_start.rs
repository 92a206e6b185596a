//! Request that begins a session.

use serde_json::{Map, Value};

use crate::failure::RequestFailure;
use crate::message::{MessageContent, ProtocolMessage};
use crate::secret::Secret;
use crate::settings::SessionSettings;

/// Request `launch` or `attach`.
#[derive(Debug, Clone, PartialEq)]
pub struct SessionStart {
    /// Sequence number of the request.
    pub(crate) seq: i64,
    pub(crate) is_attach: bool,
    /// Whether to ignore breakpoints.
    pub is_plain_run: bool,
    /// Arguments that the specification does not list.
    pub arguments: Map<String, Value>,
    /// Session settings among the arguments.
    pub settings: SessionSettings,
}

impl SessionStart {
    /// Reads the arguments.
    ///
    /// # Errors
    /// The secret is wrong, or a setting is invalid.
    pub(crate) fn new(
        seq: i64,
        is_attach: bool,
        arguments: Map<String, Value>,
        secret: Option<&Secret>,
    ) -> Result<Self, RequestFailure> {
        secret.map_or(Ok(()), |secret| secret.check(&arguments))?;
        let mut settings = SessionSettings::of(&arguments)?;
        // `startAtEnd` is for new runs: a client attaches while the run is in progress.
        settings.starts_at_end &= !is_attach;
        Ok(Self { seq, is_attach, is_plain_run: false, arguments, settings })
    }

    /// Returns the request as a message, for another adapter.
    #[must_use]
    pub fn message(&self) -> ProtocolMessage {
        let mut arguments = self.arguments.clone();
        if self.is_plain_run {
            arguments.insert("noDebug".to_owned(), Value::Bool(true));
        }
        let arguments = Some(Value::Object(arguments));
        ProtocolMessage {
            seq: self.seq,
            content: MessageContent::Request { command: self.command().to_owned(), arguments },
        }
    }

    /// Command of the request.
    pub(crate) fn command(&self) -> &'static str {
        if self.is_attach { "attach" } else { "launch" }
    }
}
