//! Test client of the debug adapter. Each message in both directions is validated against the protocol's schema.

use std::io::{BufReader, Read, Write};
use std::net::{Shutdown, TcpStream};
use std::process::{Child, Command, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::time::Duration;

use serde_json::{Value, json};
use val3_dap::validate::SchemaValidator;
use val3_dap::{Incoming, read_messages};

use crate::support::add_stops;

/// Timeout above the duration of any response on a busy machine.
const TIMEOUT: Duration = Duration::from_secs(60);

/// Path in the shipped example.
pub(crate) fn example(path: &str) -> String {
    let folder = std::fs::canonicalize(concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/palletiser")).unwrap();
    folder.join(path).to_str().unwrap().to_owned()
}

pub(crate) fn application() -> String {
    example("usr/usrapp/palletiser")
}

/// A client and its adapter process.
pub(crate) struct Session {
    /// Process that serves the client, unless the test owns it.
    adapter: Option<Child>,
    output: Option<Box<dyn Write>>,
    /// Connection, which is closed with the session.
    stream: Option<TcpStream>,
    inbox: Receiver<Incoming>,
    validator: SchemaValidator,
    seq: i64,
    /// Received messages that no call has returned.
    events: Vec<Value>,
}

impl Session {
    /// Connects a client to the standard input and output of a new adapter.
    pub(crate) fn new() -> Self {
        let mut adapter = Command::new(env!("CARGO_BIN_EXE_val3"))
            .arg("dap")
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .unwrap();
        let (input, output) = (adapter.stdout.take().unwrap(), adapter.stdin.take().unwrap());
        let mut session = Self::over(input, output);
        session.adapter = Some(adapter);
        session
    }

    /// Connects a client to a port of this machine.
    pub(crate) fn connected(address: &str) -> Self {
        let stream = TcpStream::connect(address).unwrap();
        let mut session = Self::over(stream.try_clone().unwrap(), stream.try_clone().unwrap());
        session.stream = Some(stream);
        session
    }

    fn over(input: impl Read + Send + 'static, output: impl Write + 'static) -> Self {
        let (sender, inbox) = channel();
        std::thread::spawn(move || read_messages(BufReader::new(input), &sender));
        let validator = SchemaValidator::new().unwrap();
        Self {
            adapter: None,
            output: Some(Box::new(output)),
            stream: None,
            inbox,
            validator,
            seq: 0,
            events: Vec::new(),
        }
    }

    /// Launches the example in a new session, and stops before its first line.
    pub(crate) fn launched(options: Value) -> (Self, i64) {
        options["program"].as_str().into_iter().for_each(|program| add_stops(program.as_ref()));
        Self::new().launch(options)
    }

    /// Launches the example, and waits for the stop before its first line.
    pub(crate) fn launch(self, options: Value) -> (Self, i64) {
        let mut session = self;
        let client = json!({ "adapterID": "val3", "supportsProgressReporting": true });
        let capabilities = session.ask("initialize", client);
        assert_eq!(capabilities["supportsStepBack"], true);
        let mut launch = json!({ "program": application(), "script": example("boxes.toml"), "stopOnEntry": true });
        launch.as_object_mut().unwrap().extend(options.as_object().unwrap().clone());
        session.ask("launch", launch);
        session.event("initialized");
        session.ask("setExceptionBreakpoints", json!({ "filters": ["unhandled"] }));
        session.ask("configurationDone", json!({}));
        let task = session.stopped("entry");
        assert_eq!(session.event("process")["startMethod"], "launch");
        (session, task)
    }

    /// Sends a request without waiting for its response, and returns its number.
    pub(crate) fn send(&mut self, command: &str, arguments: Value) -> i64 {
        self.seq += 1;
        let request = json!({ "seq": self.seq, "type": "request", "command": command, "arguments": arguments });
        self.validator.validate(&request).unwrap();
        self.write(&request.to_string());
        self.seq
    }

    /// Sends a request that may not have the form of the protocol, and returns its number.
    pub(crate) fn send_any(&mut self, command: &str, arguments: &Value) -> i64 {
        self.seq += 1;
        let request = json!({ "seq": self.seq, "type": "request", "command": command, "arguments": arguments });
        self.write(&request.to_string());
        self.seq
    }

    fn write(&mut self, body: &str) {
        self.write_bytes(format!("Content-Length: {}\r\n\r\n{body}", body.len()).as_bytes());
    }

    /// Sends raw bytes.
    pub(crate) fn write_bytes(&mut self, bytes: &[u8]) {
        let output = self.output.as_mut().unwrap();
        output.write_all(bytes).unwrap();
        output.flush().unwrap();
    }

    /// Waits for the response to a request.
    pub(crate) fn response(&mut self, request: i64) -> Value {
        loop {
            if let Some(at) = self.events.iter().position(|message| message["request_seq"] == request) {
                return self.events.remove(at);
            }
            let message = self.next();
            self.events.push(message);
        }
    }

    pub(crate) fn request(&mut self, command: &str, arguments: Value) -> Value {
        let request = self.send(command, arguments);
        self.response(request)
    }

    /// Sends a request that must succeed, and returns the body of the response.
    #[track_caller]
    pub(crate) fn ask(&mut self, command: &str, arguments: Value) -> Value {
        let response = self.request(command, arguments);
        assert_eq!(response["success"], true, "{response}");
        response["body"].clone()
    }

    /// Sends a request that must fail, and returns the message of the response.
    #[track_caller]
    pub(crate) fn refused(&mut self, command: &str, arguments: Value) -> String {
        let response = self.request(command, arguments);
        assert_eq!(response["success"], false, "{response}");
        response["message"].as_str().unwrap().to_owned()
    }

    fn next(&mut self) -> Value {
        let Incoming::Message(message) = self.inbox.recv_timeout(TIMEOUT).unwrap() else { panic!("no message") };
        let message = serde_json::to_value(message).unwrap();
        self.validator.validate(&message).unwrap();
        message
    }

    pub(crate) fn event(&mut self, name: &str) -> Value {
        loop {
            if let Some(at) = self.events.iter().position(|event| event["event"] == name) {
                return self.events.remove(at)["body"].clone();
            }
            let message = self.next();
            self.events.push(message);
        }
    }

    /// Waits for a stop for this reason, and returns its task.
    #[track_caller]
    pub(crate) fn stopped(&mut self, reason: &str) -> i64 {
        let stop = self.event("stopped");
        assert_eq!(stop["reason"], reason, "{stop}");
        stop["threadId"].as_i64().unwrap()
    }

    /// Name, line and id of the innermost stack frame.
    pub(crate) fn frame(&mut self, task: i64) -> (String, i64, i64) {
        let trace = self.ask("stackTrace", json!({ "threadId": task }));
        let frame = &trace["stackFrames"][0];
        let number = |name: &str| frame[name].as_i64().unwrap();
        (frame["name"].as_str().unwrap().to_owned(), number("line"), number("id"))
    }

    pub(crate) fn set_breakpoint(&mut self, file: &str, breakpoint: Value) -> Value {
        let source = json!({ "path": format!("{}/{file}", application()) });
        let set = self.ask("setBreakpoints", json!({ "source": source, "breakpoints": [breakpoint] }));
        set["breakpoints"][0].clone()
    }

    pub(crate) fn evaluate(&mut self, frame: i64, text: &str) -> String {
        let arguments = json!({ "expression": text, "frameId": frame, "context": "watch" });
        self.ask("evaluate", arguments)["result"].as_str().unwrap().to_owned()
    }

    /// Ends the session and the adapter.
    #[track_caller]
    pub(crate) fn end(mut self) {
        self.ask("disconnect", json!({ "terminateDebuggee": true }));
        self.assert_ended();
    }

    /// Sends a signal to the adapter, and returns its exit code.
    #[cfg(unix)]
    pub(crate) fn signal(&mut self, signal: rustix::process::Signal) -> Option<i32> {
        let adapter = self.adapter.as_mut().unwrap();
        rustix::process::kill_process(rustix::process::Pid::from_child(adapter), signal).unwrap();
        assert_ended(adapter);
        adapter.wait().unwrap().code()
    }

    #[track_caller]
    pub(crate) fn assert_ended(&mut self) {
        drop(self.output.take());
        assert_ended(self.adapter.as_mut().unwrap());
    }
}

impl Drop for Session {
    fn drop(&mut self) {
        self.stream.iter().for_each(|stream| drop(stream.shutdown(Shutdown::Both)));
        // The adapter is still running if the test has failed.
        self.adapter.iter_mut().for_each(|adapter| drop(adapter.kill()));
    }
}

/// Waits for the end of a process.
#[track_caller]
pub(crate) fn assert_ended(process: &mut Child) {
    let ended = (0..600).any(|_| {
        std::thread::sleep(Duration::from_millis(50));
        process.try_wait().unwrap().is_some()
    });
    assert!(ended, "the process does not end");
}
