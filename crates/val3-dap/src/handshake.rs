//! Handshake: the messages of a client before `launch` or `attach`.

use std::time::Duration;

use crate::capabilities::{capabilities, of_attached_runs};
use crate::client::{Client, Incoming};
use crate::conventions::Conventions;
use crate::error::ReadError;
use crate::message::{MessageContent, ProtocolMessage};
use crate::protocol::{CapabilitiesEvent, InitializeRequestArguments, Response, StandardEvent, StandardRequest};
use crate::secret::Secret;
use crate::session::{DebugSession, RunState};
use crate::session_start::SessionStart;

/// Client that has not sent `launch` or `attach`.
#[derive(Debug)]
pub struct Handshake {
    client: Client,
    conventions: Conventions,
    /// Arguments of `initialize`.
    introduction: InitializeRequestArguments,
    /// Secret that `launch` and `attach` have to contain; `None` for the client that started this process.
    secret: Option<Secret>,
}

/// Result of the handshake so far.
#[derive(Debug)]
pub enum HandshakeResult {
    /// The client has sent neither `launch` nor `attach`.
    None,
    /// The client launches an application.
    Launch(SessionStart),
    /// The client attaches to a run.
    Attach(SessionStart),
    /// The client has disconnected.
    Disconnected,
}

impl Handshake {
    /// Creates the handshake with the client that started this process.
    #[must_use]
    pub fn new(client: Client) -> Self {
        Self {
            client,
            conventions: Conventions::default(),
            introduction: InitializeRequestArguments::default(),
            secret: None,
        }
    }

    /// Creates the handshake with a client of a port, which has to send a secret with `launch` or `attach`. Before
    /// that, all requests except `initialize` and `disconnect` are rejected.
    #[must_use]
    pub fn through_port(client: Client, secret: Secret) -> Self {
        Self { secret: Some(secret), ..Self::new(client) }
    }

    /// Waits for a message, at most for this time.
    pub fn wait(&mut self, time: Duration) {
        self.client.wait(time);
    }

    /// Handles the received messages up to `launch` or `attach`.
    pub fn attend(&mut self) -> HandshakeResult {
        loop {
            let (seq, command, arguments) = match self.client.poll() {
                None if self.client.is_connected() => return HandshakeResult::None,
                None => return HandshakeResult::Disconnected,
                Some(Incoming::End(fault)) => {
                    self.client.disconnect(fault);
                    return HandshakeResult::Disconnected;
                }
                Some(Incoming::Garbage(error)) => {
                    self.say(&format!("{error}\n"));
                    continue;
                }
                Some(Incoming::Message(ProtocolMessage {
                    seq,
                    content: MessageContent::Request { command, arguments },
                })) => (seq, command, arguments),
                Some(Incoming::Message(_)) => continue,
            };
            match StandardRequest::parse(&command, arguments) {
                Ok(StandardRequest::Initialize(arguments)) => {
                    self.conventions = Conventions::of(&arguments);
                    self.introduction = arguments;
                    self.client.send(MessageContent::success(seq, &Response::Initialize(capabilities())));
                }
                Ok(StandardRequest::Launch(arguments)) => {
                    let is_plain_run = arguments.no_debug.unwrap_or_default();
                    match SessionStart::new(seq, false, arguments.additional, self.secret.as_ref()) {
                        Ok(start) => return HandshakeResult::Launch(SessionStart { is_plain_run, ..start }),
                        Err(reason) => self.client.refuse(seq, "launch", &reason),
                    }
                }
                Ok(StandardRequest::Attach(arguments)) => {
                    match SessionStart::new(seq, true, arguments.additional, self.secret.as_ref()) {
                        Ok(start) => return HandshakeResult::Attach(start),
                        Err(reason) => self.client.refuse(seq, "attach", &reason),
                    }
                }
                Ok(StandardRequest::Disconnect(_)) => {
                    self.client.send(MessageContent::success(seq, &Response::Disconnect));
                    return HandshakeResult::Disconnected;
                }
                Ok(request) => {
                    self.client.refuse(seq, request.command(), "the session has not begun: send `launch` or `attach`");
                }
                Err(error) => self.client.send(error.response(seq)),
            }
        }
    }

    /// Shows a text in the debug console as standard error output.
    pub fn say(&mut self, text: &str) {
        self.client.say(text);
    }

    /// Returns the error that has ended the connection to the client.
    #[must_use]
    pub const fn fault(&self) -> Option<&ReadError> {
        self.client.fault()
    }

    /// Whether the client shows colours that ANSI escape sequences set.
    #[must_use]
    pub const fn shows_colors(&self) -> bool {
        self.conventions.shows_colors
    }

    /// Rejects the client's `launch` or `attach`. The client may send another one.
    pub fn refuse(&mut self, start: &SessionStart, reason: &str) {
        self.client.refuse(start.seq, start.command(), reason);
    }

    /// Starts the session for a run in this state.
    #[must_use]
    pub fn accept(mut self, start: &SessionStart, run: RunState) -> DebugSession {
        let response = if start.is_attach { Response::Attach } else { Response::Launch };
        self.client.send(MessageContent::success(start.seq, &response));
        if start.is_attach {
            self.client.event(&StandardEvent::Capabilities(CapabilitiesEvent { capabilities: of_attached_runs() }));
        }
        self.client.event(&StandardEvent::Initialized);
        DebugSession::new(self.client, self.conventions, start, run)
    }

    /// Returns the connection and the arguments of `initialize`, for a session that another process serves.
    #[must_use]
    pub fn into_parts(self) -> (Client, InitializeRequestArguments) {
        (self.client, self.introduction)
    }
}
