//! A client in memory, for tests of requests.

use std::io::{Cursor, Write};
use std::sync::mpsc::{Sender, channel};
use std::sync::{Arc, Mutex};

use serde_json::{Value, json};
use val3_debug::Debugger;
use val3_session::FrameEvaluator;
use val3_tests::running::{Running, application};

use crate::client::{Client, Incoming};
use crate::conventions::Conventions;
use crate::debugged_run::DebuggedRun;
use crate::frame::MessageReader;
use crate::message::{MessageContent, ProtocolMessage};
use crate::session::{DebugSession, RunState};
use crate::session_start::SessionStart;

/// Listing of a program with one line.
pub(crate) const EMPTY: &str = "program start()\nbegin\n  delay(1)\nend\n";

/// Listing of a program that changes a global number.
pub(crate) const COUNTER: &str = "num nCount\n\nprogram start()\nbegin\n  nCount=1\n  delay(1)\nend\n";

/// Client of a run that is stopped before its first line.
pub(crate) struct TestClient {
    session: DebugSession,
    debugger: Debugger,
    evaluator: FrameEvaluator,
    inbox: Sender<Incoming>,
    output: ClientOutput,
}

/// Messages to the client.
#[derive(Clone, Default)]
struct ClientOutput(Arc<Mutex<Vec<u8>>>);

impl Write for ClientOutput {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        self.0.lock().unwrap().write(bytes)
    }

    fn flush(&mut self) -> std::io::Result<()> {
        Ok(())
    }
}

impl TestClient {
    /// Starts the program `start` of a listing, and stops before its first line.
    pub(crate) fn stopped(listing: &str) -> Self {
        Self::launched(listing, json!({ "stopOnEntry": true }))
    }

    /// Starts the program `start` of a listing with these arguments of `launch`.
    pub(crate) fn launched(listing: &str, arguments: Value) -> Self {
        let (inbox, messages) = channel();
        let output = ClientOutput::default();
        let client = Client::new(messages, Box::new(output.clone()));
        let start = SessionStart::new(1, false, arguments.as_object().unwrap().clone(), None).unwrap();
        let session = DebugSession::new(client, Conventions::default(), &start, RunState::Fresh);
        let mut debugger = Debugger::new(Running::start(listing).controller);
        start.settings.apply(&mut debugger);
        let evaluator = FrameEvaluator::new(application(listing));
        let mut this = Self { session, debugger, evaluator, inbox, output };
        this.session.begin(&mut DebuggedRun { debugger: &mut this.debugger, evaluator: &mut this.evaluator });
        this.body("configurationDone", json!({}));
        this
    }

    /// Sends a request, and returns the messages of the session.
    pub(crate) fn exchange(&mut self, command: &str, arguments: Value) -> Vec<MessageContent> {
        let content = MessageContent::Request { command: command.to_owned(), arguments: Some(arguments) };
        self.inbox.send(Incoming::Message(ProtocolMessage { seq: 1, content })).unwrap();
        self.session.attend(&mut DebuggedRun { debugger: &mut self.debugger, evaluator: &mut self.evaluator });
        let bytes = std::mem::take(&mut *self.output.0.lock().unwrap());
        let mut reader = MessageReader::new(Cursor::new(bytes));
        std::iter::from_fn(|| reader.read().unwrap()).map(|message| message.content).collect()
    }

    fn response(&mut self, command: &str, arguments: Value) -> Result<Option<Value>, String> {
        let mut responses = self.exchange(command, arguments).into_iter().filter_map(|content| match content {
            MessageContent::Response { success: true, body, .. } => Some(Ok(body)),
            MessageContent::Response { message, .. } => Some(Err(message.unwrap())),
            MessageContent::Request { .. } | MessageContent::Event { .. } => None,
        });
        responses.next_back().unwrap()
    }

    /// Returns the body of a successful response; `null` if it has none.
    pub(crate) fn body(&mut self, command: &str, arguments: Value) -> Value {
        self.response(command, arguments).unwrap().unwrap_or_default()
    }

    /// Returns the message of a failed response.
    pub(crate) fn failure(&mut self, command: &str, arguments: Value) -> String {
        self.response(command, arguments).unwrap_err()
    }

    /// Returns the number of the first thread and of its innermost stack frame.
    pub(crate) fn thread_and_frame(&mut self) -> (Value, Value) {
        let thread = self.body("threads", json!({}))["threads"][0]["id"].clone();
        let trace = self.body("stackTrace", json!({ "threadId": thread }));
        (thread, trace["stackFrames"][0]["id"].clone())
    }
}
