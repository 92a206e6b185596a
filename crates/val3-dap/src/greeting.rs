//! The beginning of a session: the client introduces itself and says what to run.

use serde_json::{Map, Value};
use val3_machine::arm::MotionMode;

use crate::capabilities::capabilities;
use crate::client::{ATTENTION, Client, Incoming};
use crate::conventions::Conventions;
use crate::custom::motion_mode;
use crate::message::{Content, ProtocolMessage};
use crate::protocol::{Event, Request, Response};
use crate::session::DebugSession;

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
    /// An application.
    Launch(SessionStart),
    /// The client has left.
    Left,
}

/// The request `launch`.
#[derive(Debug, Clone, PartialEq)]
pub struct SessionStart {
    /// The number of the request.
    seq: i64,
    /// Whether to ignore breakpoints.
    pub is_plain_run: bool,
    /// Its properties that the specification does not list.
    pub arguments: Map<String, Value>,
}

impl SessionStart {
    /// The mode of the motion (10.2.2).
    ///
    /// # Errors
    /// There is no such mode.
    pub fn motion_mode(&self) -> Result<MotionMode, String> {
        self.arguments.get("motionMode").map_or(Ok(MotionMode::Continuous), motion_mode)
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
                    return Wish::Launch(SessionStart { seq, is_plain_run, arguments: arguments.additional });
                }
                Ok(Request::Attach(_)) => {
                    self.client.refuse(seq, "attach", "this adapter cannot attach to a run: use `launch`");
                }
                Ok(Request::Disconnect(_)) => {
                    self.client.send(Content::success(seq, &Response::Disconnect));
                    return Wish::Left;
                }
                Ok(request) => self.client.refuse(seq, request.command(), "nothing runs yet: send `launch`"),
                Err(error) => self.client.send(error.response(seq)),
            }
        }
    }

    /// Shows a text of the standard error output to the user.
    pub fn say(&mut self, text: &str) {
        self.client.say(text);
    }

    /// Refuses to begin. The client may try again.
    pub fn refuse(&mut self, start: &SessionStart, reason: &str) {
        self.client.refuse(start.seq, "launch", reason);
    }

    /// Begins the session with a run that is ready.
    #[must_use]
    pub fn accept(mut self, start: &SessionStart) -> DebugSession {
        self.client.send(Content::success(start.seq, &Response::Launch));
        self.client.event(&Event::Initialized);
        DebugSession::new(self.client, self.conventions, start)
    }
}
