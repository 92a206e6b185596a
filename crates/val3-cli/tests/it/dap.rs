//! `val3 dap` as a process: a client debugs the shipped example. Each message is validated against the schema.

use std::io::{BufReader, Write as _};
use std::process::{Child, Command, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::time::Duration;

use serde_json::{Value, json};
use val3_dap::validate::SchemaValidator;
use val3_dap::{Incoming, read_messages};

/// Longer than any answer takes, also on a busy machine.
const PATIENCE: Duration = Duration::from_secs(60);

/// A path of the shipped example.
fn example(path: &str) -> String {
    let folder = std::fs::canonicalize(concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/palletiser")).unwrap();
    folder.join(path).to_str().unwrap().to_owned()
}

fn application() -> String {
    example("usr/usrapp/palletiser")
}

/// A client and its adapter.
struct Session {
    adapter: Child,
    inbox: Receiver<Incoming>,
    validator: SchemaValidator,
    seq: i64,
    events: Vec<Value>,
}

impl Session {
    fn new() -> Self {
        let mut adapter = Command::new(env!("CARGO_BIN_EXE_val3"))
            .arg("dap")
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .unwrap();
        let (sender, inbox) = channel();
        let output = adapter.stdout.take().unwrap();
        std::thread::spawn(move || read_messages(BufReader::new(output), &sender));
        Self { adapter, inbox, validator: SchemaValidator::new().unwrap(), seq: 0, events: Vec::new() }
    }

    /// A session that has stopped before the first line of the example.
    fn launched(options: Value) -> (Self, i64) {
        let mut session = Self::new();
        let capabilities = session.ask("initialize", json!({ "adapterID": "val3" }));
        assert_eq!(capabilities["supportsStepBack"], true);
        let mut launch = json!({ "program": application(), "script": example("boxes.toml"), "stopOnEntry": true });
        launch.as_object_mut().unwrap().extend(options.as_object().unwrap().clone());
        session.ask("launch", launch);
        session.event("initialized");
        session.ask("setExceptionBreakpoints", json!({ "filters": ["unhandled"] }));
        session.ask("configurationDone", json!({}));
        let task = session.stopped("entry");
        (session, task)
    }

    fn request(&mut self, command: &str, arguments: Value) -> Value {
        self.seq += 1;
        let request = json!({ "seq": self.seq, "type": "request", "command": command, "arguments": arguments });
        self.validator.validate(&request).unwrap();
        let body = request.to_string();
        let input = self.adapter.stdin.as_mut().unwrap();
        write!(input, "Content-Length: {}\r\n\r\n{body}", body.len()).unwrap();
        input.flush().unwrap();
        loop {
            let message = self.next();
            if message["type"] == "response" && message["request_seq"] == self.seq {
                return message;
            }
            self.events.push(message);
        }
    }

    /// The body of the response to a request that is executed.
    #[track_caller]
    fn ask(&mut self, command: &str, arguments: Value) -> Value {
        let response = self.request(command, arguments);
        assert_eq!(response["success"], true, "{response}");
        response["body"].clone()
    }

    /// The reason why a request is refused.
    #[track_caller]
    fn refused(&mut self, command: &str, arguments: Value) -> String {
        let response = self.request(command, arguments);
        assert_eq!(response["success"], false, "{response}");
        response["message"].as_str().unwrap().to_owned()
    }

    fn next(&mut self) -> Value {
        let Incoming::Message(message) = self.inbox.recv_timeout(PATIENCE).unwrap() else { panic!("no message") };
        let message = serde_json::to_value(message).unwrap();
        self.validator.validate(&message).unwrap();
        message
    }

    fn event(&mut self, name: &str) -> Value {
        loop {
            if let Some(at) = self.events.iter().position(|event| event["event"] == name) {
                return self.events.remove(at)["body"].clone();
            }
            let message = self.next();
            self.events.push(message);
        }
    }

    /// The task of a stop for this reason.
    #[track_caller]
    fn stopped(&mut self, reason: &str) -> i64 {
        let stop = self.event("stopped");
        assert_eq!(stop["reason"], reason, "{stop}");
        stop["threadId"].as_i64().unwrap()
    }

    /// The name, the line and the number of the innermost frame.
    fn frame(&mut self, task: i64) -> (String, i64, i64) {
        let trace = self.ask("stackTrace", json!({ "threadId": task }));
        let frame = &trace["stackFrames"][0];
        let number = |name: &str| frame[name].as_i64().unwrap();
        (frame["name"].as_str().unwrap().to_owned(), number("line"), number("id"))
    }

    fn set_breakpoint(&mut self, file: &str, breakpoint: Value) -> Value {
        let source = json!({ "path": format!("{}/{file}", application()) });
        let set = self.ask("setBreakpoints", json!({ "source": source, "breakpoints": [breakpoint] }));
        set["breakpoints"][0].clone()
    }

    fn evaluate(&mut self, frame: i64, text: &str) -> String {
        let arguments = json!({ "expression": text, "frameId": frame, "context": "watch" });
        self.ask("evaluate", arguments)["result"].as_str().unwrap().to_owned()
    }

    /// Ends the session, and the adapter with it.
    #[track_caller]
    fn end(mut self) {
        self.ask("disconnect", json!({ "terminateDebuggee": true }));
        self.assert_ended();
    }

    #[track_caller]
    fn assert_ended(&mut self) {
        drop(self.adapter.stdin.take());
        let ended = (0..600).any(|_| {
            std::thread::sleep(Duration::from_millis(50));
            self.adapter.try_wait().unwrap().is_some()
        });
        assert!(ended, "the adapter does not end");
    }
}

impl Drop for Session {
    fn drop(&mut self) {
        // It has ended unless the test has failed.
        let _ = self.adapter.kill();
    }
}

#[test]
fn lines_are_stepped_over_forwards_and_backwards() {
    let (mut session, task) = Session::launched(json!({}));
    let (name, first, _) = session.frame(task);
    assert_eq!(name, "palletiser:start()");
    session.ask("next", json!({ "threadId": task }));
    assert_eq!(session.stopped("step"), task);
    let (_, second, _) = session.frame(task);
    assert!(second > first);
    session.ask("next", json!({ "threadId": task }));
    session.stopped("step");
    session.ask("stepBack", json!({ "threadId": task }));
    assert_eq!(session.stopped("step"), task);
    assert_eq!(session.frame(task).1, second);
    session.ask("stepBack", json!({ "threadId": task }));
    // The beginning of the run.
    assert_eq!(session.stopped("entry"), task);
    assert_eq!(session.frame(task).1, first);
    session.end();
}

#[test]
fn a_breakpoint_stops_and_values_are_seen_and_set() {
    let (mut session, task) = Session::launched(json!({}));
    let placed = session.set_breakpoint("home.pgx", json!({ "line": 12 }));
    assert_eq!((&placed["verified"], &placed["line"]), (&json!(true), &json!(13)), "a comment has no instruction");
    session.ask("continue", json!({ "threadId": task }));
    let task = session.stopped("breakpoint");
    let (name, line, frame) = session.frame(task);
    assert_eq!((name.as_str(), line), ("palletiser:home()", 13));
    let scopes = session.ask("scopes", json!({ "frameId": frame }));
    let names: Vec<&str> =
        scopes["scopes"].as_array().unwrap().iter().map(|scope| scope["name"].as_str().unwrap()).collect();
    assert_eq!(names, ["Parameters", "Locals", "Globals", "Library io", "I/O", "Robot", "Motion queue"]);
    let locals = scopes["scopes"][1]["variablesReference"].clone();
    let set = json!({ "variablesReference": locals, "name": "l_jAway", "value": "{1,2,3,4,5,6}" });
    session.ask("setVariable", set);
    assert_eq!(session.evaluate(frame, "l_jAway.j3*2"), "6");
    let refusal = session.refused("evaluate", json!({ "expression": "nothing", "frameId": frame, "context": "watch" }));
    assert!(refusal.contains("nothing"), "{refusal}");
    session.end();
}

#[test]
fn motion_is_stepped_piece_by_piece() {
    let (mut session, task) = Session::launched(json!({ "motionMode": "step" }));
    session.set_breakpoint("home.pgx", json!({ "line": 22 }));
    session.ask("continue", json!({ "threadId": task }));
    // Each line that changes the motion is a stop in step mode.
    let task = loop {
        let stop = session.event("stopped");
        let task = stop["threadId"].as_i64().unwrap();
        if stop["reason"] == "breakpoint" {
            break task;
        }
        session.ask("continue", json!({ "threadId": task }));
    };
    let reason = session.refused("val3/motionStep", json!({}));
    assert!(reason.contains("no further motion"), "{reason}");
    session.ask("next", json!({ "threadId": task }));
    session.event("stopped");
    let queue = session.ask("val3/motionQueue", json!({}));
    let joints = session.ask("val3/pose", json!({}))["joints"].clone();
    session.ask("next", json!({ "threadId": task }));
    session.event("stopped");
    assert!(queue["moves"].is_array());
    assert_ne!(session.ask("val3/pose", json!({}))["joints"], joints, "the arm has moved");
    session.end();
}

#[test]
fn inputs_are_forced_and_the_page_is_seen() {
    let (mut session, _) = Session::launched(json!({}));
    session.ask("val3/ioForce", json!({ "link": "BasicIO-1\\%I2", "value": true }));
    let io = session.ask("val3/io", json!({}));
    let clamp =
        io["signals"].as_array().unwrap().iter().find(|signal| signal["link"] == "BasicIO-1\\%I2").unwrap().clone();
    assert_eq!(clamp["value"], 1.0);
    let reason = session.refused("val3/ioForce", json!({ "link": "BasicIO-1\\%I99", "value": true }));
    assert!(reason.contains("%I99"), "{reason}");
    assert_eq!(session.ask("val3/userPage", json!({}))["lines"].as_array().unwrap().len(), 14);
    session.end();
}

#[test]
fn a_run_ends_with_its_exit_code() {
    let (mut session, task) = Session::launched(json!({ "until": 1, "untilOk": true }));
    session.ask("continue", json!({ "threadId": task }));
    assert_eq!(session.event("exited")["exitCode"], 0);
    session.event("terminated");
    session.end();
}

#[test]
fn a_run_is_paused_and_restarted() {
    let (mut session, task) = Session::launched(json!({ "time": "real" }));
    let (_, first, _) = session.frame(task);
    session.ask("continue", json!({ "threadId": task }));
    assert_eq!(session.refused("stepBack", json!({ "threadId": task })), "notStopped");
    session.ask("pause", json!({ "threadId": task }));
    session.stopped("pause");
    session.ask("restart", json!({}));
    let task = session.stopped("entry");
    assert_eq!(session.frame(task).1, first);
    session.end();
}

#[test]
fn an_application_that_cannot_be_opened_is_refused() {
    let mut session = Session::new();
    session.ask("initialize", json!({ "adapterID": "val3" }));
    let reason = session.refused("launch", json!({ "program": "/nowhere" }));
    assert!(reason.contains("/nowhere"), "{reason}");
    let reason = session.refused("launch", json!({ "program": application(), "motionMode": "fast" }));
    assert!(reason.contains("fast"), "{reason}");
    let reason = session.refused("attach", json!({}));
    assert!(reason.contains("launch"), "{reason}");
    assert!(session.refused("threads", json!({})).contains("launch"));
    assert!(session.refused("val3/unknown", json!({})).contains("unknown"));
    session.end();
}

#[test]
fn an_adapter_whose_client_disappears_ends() {
    let (mut session, task) = Session::launched(json!({}));
    session.ask("continue", json!({ "threadId": task }));
    session.assert_ended();
}
