//! A client in memory, for tests of requests.

use std::io::{Cursor, Write};
use std::sync::mpsc::{Sender, channel};
use std::sync::{Arc, Mutex};

use serde_json::{Map, Value, json};
use val3_debug::{AdvanceResult, Debugger};
use val3_machine::controller::RunStatus;
use val3_machine::io::{Direction, IoTable, Signal};
use val3_session::{FrameEvaluator, Pace};
use val3_tests::running::{Running, application};

use crate::client::{Client, Incoming};
use crate::conventions::Conventions;
use crate::debugged_run::DebuggedRun;
use crate::frame::MessageReader;
use crate::message::{MessageContent, ProtocolMessage};
use crate::protocol::{InitializePathFormat, InitializeRequestArguments};
use crate::session::{DebugSession, NextAction, RunState, TimeEnd};
use crate::session_start::SessionStart;
use crate::validate::SchemaValidator;

/// Listing of a program with one line.
pub(crate) const EMPTY: &str = "program start()\nbegin\n  delay(1)\nend\n";

/// Listing of a program that changes a global number.
pub(crate) const COUNTER: &str = "num nCount\n\nprogram start()\nbegin\n  nCount=1\n  delay(1)\nend\n";

/// Listing of a program that calls another program.
pub(crate) const CALLER: &str = "\
program start()
begin
  call work()
  delay(1)
end

program work()
begin
  delay(1)
end
";

/// Listing of a program that creates a task.
pub(crate) const WORKER: &str = "\
program start()
begin
  taskCreate \"worker\",10,work()
  delay(1)
end

program work()
begin
  delay(1)
end
";

/// Thread id of the first task.
pub(crate) const MAIN_THREAD: u64 = 2;

/// Thread id of the task that [`WORKER`] creates.
pub(crate) const WORKER_THREAD: u64 = 3;

/// Module id of the application.
pub(crate) const MODULE: &str = "/cell/usr/usrapp/main/main.pjx";

/// Waits for the input `Io\start`, which is linked to `diIn`, then counts.
pub(crate) const INPUT: &str = r#"
program start()
begin
  wait(diIn)
  nCount=1
  delay(1)
end
=== main/main.dtx
<?xml version="1.0" encoding="utf-8"?>
<Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
  <Datas>
    <Data name="diIn" access="private" xsi:type="array" type="dio" size="1"><Value key="0" link="Io\start" /></Data>
    <Data name="nCount" access="private" xsi:type="array" type="num" size="1"/>
  </Datas>
</Database>
"#;

/// Line of the first instruction in the file of a program without parameters and locals.
pub(crate) const FIRST_LINE: u64 = 5;

/// Returns the file of a program, as responses contain it.
pub(crate) fn source(program: &str) -> Value {
    json!({ "name": format!("{program}.pgx"), "path": format!("/cell/usr/usrapp/main/{program}.pgx") })
}

/// Reader of program files. A line contains its own position, such as `start.pgx 7`.
fn text(file: &str) -> Option<String> {
    let name = file.rsplit('/').next()?;
    Some((1..=99).map(|row| format!("{name} {row}\n")).collect())
}

/// Client of a run.
pub(crate) struct TestClient {
    session: DebugSession,
    pub(crate) debugger: Debugger,
    evaluator: FrameEvaluator,
    inbox: Sender<Incoming>,
    output: ClientOutput,
    validator: SchemaValidator,
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
        let mut this = Self::launching(listing, arguments);
        this.body("configurationDone", json!({}));
        this
    }

    /// Starts the program `start` of a listing with `stopOnExit`, and stops it as at the end of its time.
    pub(crate) fn stopped_at_time(listing: &str, end: TimeEnd) -> Self {
        let mut this = Self::launched(listing, json!({ "stopOnExit": true }));
        let mut run = DebuggedRun { debugger: &mut this.debugger, evaluator: &mut this.evaluator, files: text };
        assert!(this.session.stop_at_time(end, &mut run));
        this
    }

    /// Opens a listing with these arguments of `launch`, and waits for `configurationDone`.
    pub(crate) fn launching(listing: &str, arguments: Value) -> Self {
        let start = SessionStart::new(1, false, arguments.as_object().unwrap().clone(), None).unwrap();
        Self::connected(listing, &start, RunState::Fresh)
    }

    /// Attaches to the run of a listing, and waits for `configurationDone`.
    pub(crate) fn attaching(listing: &str, run: RunState) -> Self {
        let start = SessionStart::new(1, true, Map::new(), None).unwrap();
        Self::connected(listing, &start, run)
    }

    fn connected(listing: &str, start: &SessionStart, run: RunState) -> Self {
        let (inbox, messages) = channel();
        let output = ClientOutput::default();
        let client = Client::new(messages, Box::new(output.clone()));
        let session = DebugSession::new(client, Conventions::default(), start, run);
        let debugger = debugger(listing, start);
        let evaluator = FrameEvaluator::new(application(listing));
        let validator = SchemaValidator::new().unwrap();
        let mut this = Self { session, debugger, evaluator, inbox, output, validator };
        this.session.begin(&mut DebuggedRun {
            debugger: &mut this.debugger,
            evaluator: &mut this.evaluator,
            files: text,
        });
        this.received();
        this
    }

    /// Opens a listing once more for the client, as after `restart`, and returns the events: name and body.
    pub(crate) fn open_again(&mut self, listing: &str) -> Vec<(String, Value)> {
        self.debugger = debugger(listing, &self.session.start);
        self.evaluator = FrameEvaluator::new(application(listing));
        self.session.begin(&mut DebuggedRun {
            debugger: &mut self.debugger,
            evaluator: &mut self.evaluator,
            files: text,
        });
        self.received().into_iter().filter_map(event).collect()
    }

    /// Changes the conventions of the client: lines and columns begin with 0, and files are URIs.
    pub(crate) fn counting_from_0(mut self) -> Self {
        self.session.conventions = Conventions::of(&InitializeRequestArguments {
            lines_start_at1: Some(false),
            columns_start_at1: Some(false),
            path_format: Some(InitializePathFormat::Uri),
            ..InitializeRequestArguments::default()
        });
        self
    }

    /// Lets the client support progress.
    pub(crate) fn knowing_progress(mut self) -> Self {
        self.session.conventions.knows_progress = true;
        self
    }

    /// Removes the inputs and outputs of the cell.
    pub(crate) fn without_signals(mut self) -> Self {
        self.debugger.controller.devices.state.io = IoTable::default();
        self
    }

    /// Sends a request with the number `seq`. The session handles it together with the next request.
    pub(crate) fn send(&self, seq: i64, command: &str, arguments: Value) {
        let content = MessageContent::Request { command: command.to_owned(), arguments: Some(arguments) };
        self.inbox.send(Incoming::Message(ProtocolMessage { seq, content })).unwrap();
    }

    /// Sends a request, and returns the next action of the run.
    pub(crate) fn action(&mut self, command: &str, arguments: Value) -> NextAction {
        self.send(1, command, arguments);
        self.session.attend(&mut DebuggedRun {
            debugger: &mut self.debugger,
            evaluator: &mut self.evaluator,
            files: text,
        })
    }

    /// Sends a request, and returns the messages of the session.
    pub(crate) fn exchange(&mut self, command: &str, arguments: Value) -> Vec<MessageContent> {
        self.action(command, arguments);
        self.received()
    }

    /// Sends a request, and returns the events after the response: name and body.
    pub(crate) fn events(&mut self, command: &str, arguments: Value) -> Vec<(String, Value)> {
        let messages = self.exchange(command, arguments);
        assert!(matches!(messages.first(), Some(MessageContent::Response { success: true, .. })), "{messages:?}");
        messages.into_iter().filter_map(event).collect()
    }

    /// Sends a request after other requests that are not handled yet, and returns all events: name and body.
    pub(crate) fn events_of_all(&mut self, command: &str, arguments: Value) -> Vec<(String, Value)> {
        self.exchange(command, arguments).into_iter().filter_map(event).collect()
    }

    /// Sends a request, runs to the next stop if the run does not stop immediately, and returns the body of `stopped`.
    #[track_caller]
    pub(crate) fn stop_after(&mut self, command: &str, arguments: Value) -> Value {
        let mut events = self.events(command, arguments);
        events.extend(self.run());
        let stops = events.into_iter().filter(|(event, _)| event == "stopped");
        stops.map(|(_, body)| body).next().expect("the run stops")
    }

    /// Runs to the next stop or the end of the application, and returns the events: name and body.
    pub(crate) fn run(&mut self) -> Vec<(String, Value)> {
        while self.session.is_running() {
            let start = self.debugger.controller.now();
            let progress = self.debugger.advance();
            let events = self.debugger.controller.devices.take_events();
            let mut run = DebuggedRun { debugger: &mut self.debugger, evaluator: &mut self.evaluator, files: text };
            self.session.report(&events, &mut run);
            self.session.see(start, &run);
            match progress {
                AdvanceResult::Stopped(stop) => {
                    let is_passed = self.session.passes(&stop, &run);
                    self.session.stop(&stop, &mut run);
                    if !is_passed {
                        break;
                    }
                }
                AdvanceResult::Ran(RunStatus::Waiting(wake)) => {
                    if Pace::default().wait(&mut run.debugger.controller, wake).is_none() {
                        self.session.stop_at_end(RunStatus::Stuck, &mut run);
                        break;
                    }
                }
                AdvanceResult::Ran(outcome) if outcome.is_final() || outcome == RunStatus::Stuck => {
                    self.session.stop_at_end(outcome, &mut run);
                    break;
                }
                AdvanceResult::Ran(_) => {}
            }
        }
        self.received().into_iter().filter_map(event).collect()
    }

    /// Returns the messages since the last call, after their validation against the schema of the specification.
    fn received(&mut self) -> Vec<MessageContent> {
        let bytes = std::mem::take(&mut *self.output.0.lock().unwrap());
        let mut reader = MessageReader::new(Cursor::new(bytes));
        let messages = std::iter::from_fn(|| reader.read().unwrap());
        let validated = messages.map(|message| {
            self.validator.validate(&json!(message)).unwrap();
            message.content
        });
        validated.collect()
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

    /// Returns the ids of the first thread and its innermost stack frame.
    pub(crate) fn thread_and_frame(&mut self) -> (Value, Value) {
        let thread = self.body("threads", json!({}))["threads"][0]["id"].clone();
        let trace = self.body("stackTrace", json!({ "threadId": thread }));
        (thread, trace["stackFrames"][0]["id"].clone())
    }

    /// Executes code of the debug console in the innermost stack frame of the first thread. Returns the result, and the
    /// events after it: name and body.
    pub(crate) fn console(&mut self, code: &str) -> (Value, Vec<(String, Value)>) {
        let (_, frame) = self.thread_and_frame();
        let arguments = json!({ "expression": code, "frameId": frame, "context": "repl" });
        let messages = self.exchange("evaluate", arguments);
        let result = messages.iter().find_map(|content| match content {
            MessageContent::Response { success: true, body, .. } => Some(body.as_ref()?["result"].clone()),
            MessageContent::Response { message, .. } => Some(json!(message)),
            MessageContent::Request { .. } | MessageContent::Event { .. } => None,
        });
        (result.expect("a response"), messages.into_iter().filter_map(event).collect())
    }

    /// Returns program and line of the innermost stack frame of the first thread.
    pub(crate) fn place(&mut self) -> (String, u64) {
        let (thread, _) = self.thread_and_frame();
        let trace = self.body("stackTrace", json!({ "threadId": thread }));
        let frame = &trace["stackFrames"][0];
        (frame["name"].as_str().unwrap().to_owned(), frame["line"].as_u64().unwrap())
    }

    /// Returns the handle of a scope in the first thread.
    pub(crate) fn scope(&mut self, name: &str) -> Value {
        let (_, frame) = self.thread_and_frame();
        let scopes = self.body("scopes", json!({ "frameId": frame }));
        let mut scopes = scopes["scopes"].as_array().unwrap().iter();
        scopes.find(|scope| scope["name"] == name).unwrap()["variablesReference"].clone()
    }

    /// Evaluates an expression in the innermost stack frame of the first thread.
    pub(crate) fn value(&mut self, expression: &str) -> Value {
        let (_, frame) = self.thread_and_frame();
        let arguments = json!({ "expression": expression, "frameId": frame });
        self.body("evaluate", arguments)["result"].clone()
    }
}

/// Returns the debugger of a run before its first line. The cell has the digital input `Io\start`.
fn debugger(listing: &str, start: &SessionStart) -> Debugger {
    let mut devices = Running::devices();
    let signal = Signal { direction: Direction::Input, ..Signal::from_path("Io\\start", true) };
    devices.state.io.declare(signal);
    let mut debugger = Debugger::new(Running::debugged_on(devices, listing).controller);
    start.settings.apply(&mut debugger);
    debugger
}

/// Returns name and body of an event.
fn event(content: MessageContent) -> Option<(String, Value)> {
    match content {
        MessageContent::Event { event, body } => Some((event, body.unwrap_or_default())),
        MessageContent::Request { .. } | MessageContent::Response { .. } => None,
    }
}
