//! The beginning of a session: the client introduces itself and says what to run.

use std::time::Duration;

use serde_json::{Map, Value};

use crate::capabilities::capabilities;
use crate::client::{Client, Incoming};
use crate::conventions::Conventions;
use crate::message::{Content, ProtocolMessage};
use crate::protocol::{Event, OutputEvent, OutputEventCategory, Request, Response};
use crate::session::DebugSession;

/// The longest wait for a message until the caller can look at other things.
const ATTENTION: Duration = Duration::from_millis(100);

/// A client that has not said yet what to run.
#[derive(Debug)]
pub struct Greeting {
    client: Client,
    conventions: Conventions,
}

/// What the client wants to run.
#[derive(Debug)]
pub enum Wish {
    /// Nothing yet.
    None,
    /// `launch`: an application.
    Launch(SessionStart),
    /// `attach`: a run that exists.
    Attach(SessionStart),
    /// The client has left.
    Left,
}

/// The request that begins a session.
#[derive(Debug, Clone, PartialEq)]
pub struct SessionStart {
    /// The number of the request.
    seq: i64,
    command: &'static str,
    /// Whether to ignore breakpoints.
    pub is_plain_run: bool,
    /// Its properties that the specification does not list.
    pub arguments: Map<String, Value>,
}

impl SessionStart {
    /// Whether the run exists for this session alone.
    pub(crate) fn is_launch(&self) -> bool {
        self.command == "launch"
    }

    /// Whether to stop before the first line.
    pub(crate) fn stops_on_entry(&self) -> bool {
        self.arguments.get("stopOnEntry").and_then(Value::as_bool).unwrap_or_default()
    }
}

impl Greeting {
    /// A client that has sent nothing yet.
    #[must_use]
    pub fn new(client: Client) -> Self {
        Self { client, conventions: Conventions::default() }
    }

    /// Waits for a message, at most for a tenth of a second.
    pub fn wait(&mut self) {
        self.client.wait(ATTENTION);
    }

    /// Handles the messages that have arrived, up to the one that begins the session.
    pub fn attend(&mut self) -> Wish {
        loop {
            let (seq, command, arguments) = match self.client.poll() {
                None if self.client.is_connected() => return Wish::None,
                None | Some(Incoming::End) => return Wish::Left,
                Some(Incoming::Garbage(error)) => {
                    self.say(&format!("{error}\n"));
                    continue;
                }
                Some(Incoming::Message(ProtocolMessage { seq, content: Content::Request { command, arguments } })) => {
                    (seq, command, arguments)
                }
                Some(Incoming::Message(_)) => continue,
            };
            match Request::parse(&command, arguments) {
                Ok(Request::Initialize(arguments)) => {
                    self.conventions = Conventions::of(&arguments);
                    self.client.send(Content::success(seq, &Response::Initialize(capabilities())));
                }
                Ok(Request::Launch(arguments)) => {
                    let is_plain_run = arguments.no_debug.unwrap_or_default();
                    let arguments = arguments.additional;
                    return Wish::Launch(SessionStart { seq, command: "launch", is_plain_run, arguments });
                }
                Ok(Request::Attach(arguments)) => {
                    let arguments = arguments.additional;
                    return Wish::Attach(SessionStart { seq, command: "attach", is_plain_run: false, arguments });
                }
                Ok(Request::Disconnect(_)) => {
                    self.client.send(Content::success(seq, &Response::Disconnect));
                    return Wish::Left;
                }
                Ok(request) => {
                    self.client.refuse(seq, request.command(), "nothing runs yet: send `launch` or `attach`")
                }
                Err(error) => self.client.send(error.response(seq)),
            }
        }
    }

    /// Shows a text of the standard error output to the user.
    pub fn say(&mut self, text: &str) {
        let output = OutputEvent {
            output: text.to_owned(),
            category: Some(OutputEventCategory::Stderr),
            ..OutputEvent::default()
        };
        self.client.event(&Event::Output(output));
    }

    /// Refuses to begin. The client may try again.
    pub fn refuse(&mut self, start: &SessionStart, reason: &str) {
        self.client.refuse(start.seq, start.command, reason);
    }

    /// Begins the session with a run that is ready.
    #[must_use]
    pub fn accept(mut self, start: &SessionStart) -> DebugSession {
        let response = if start.command == "launch" { Response::Launch } else { Response::Attach };
        self.client.send(Content::success(start.seq, &response));
        self.client.event(&Event::Initialized);
        DebugSession::new(self.client, self.conventions, start)
    }

    /// Gives up the client, for example to pass its connection on.
    #[must_use]
    pub fn into_client(self) -> Client {
        self.client
    }
}
