//! Debuggers that attach to a run, and debug sessions through a port.

use std::io::{BufRead as _, BufReader, Read as _, Write as _};
use std::net::TcpStream;
use std::process::{Child, ChildStderr, Command, Stdio};

use expect_test::expect;
use serde_json::{Value, json};

use crate::dap_client::{Session, application, assert_ended, example};
use crate::serve::{ServedRun, Viewer};

/// A process that listens on a free port.
struct Listener {
    process: Child,
    stderr: BufReader<ChildStderr>,
    address: String,
    /// Last word of the first line: the secret, or its environment variable's name.
    secret: String,
}

impl Listener {
    fn new(arguments: &[&str]) -> Self {
        Self::with_variables(arguments, &[])
    }

    fn with_variables(arguments: &[&str], variables: &[(&str, &str)]) -> Self {
        let mut process = Command::new(env!("CARGO_BIN_EXE_val3"))
            .args(arguments)
            .env_remove("VAL3_DEBUG_SECRET")
            .envs(variables.iter().copied())
            .stdin(Stdio::null())
            .stdout(Stdio::null())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        let mut stderr = BufReader::new(process.stderr.take().unwrap());
        let mut note = String::new();
        stderr.read_line(&mut note).unwrap();
        let mut words = note.split_whitespace().map(str::to_owned);
        let address = words.find(|word| word.starts_with("127.0.0.1:")).unwrap();
        Self { process, stderr, address, secret: words.next_back().unwrap() }
    }

    /// Runs the shipped example in real time, so that the run lasts as long as the test.
    fn run(options: &[&str]) -> Self {
        let (application, script) = (application(), example("boxes.toml"));
        let run = ["run", &application, "--script", &script, "--time", "real", "--debug-port", "0"];
        Self::new(&[&run, options].concat())
    }

    fn port(&self) -> u16 {
        self.address.rsplit(':').next().unwrap().parse().unwrap()
    }

    fn is_running(&mut self) -> bool {
        self.process.try_wait().unwrap().is_none()
    }

    /// Remaining error output of a process that ends.
    fn ending(mut self) -> String {
        assert_ended(&mut self.process);
        let mut text = String::new();
        self.stderr.read_to_string(&mut text).unwrap();
        text
    }
}

impl Drop for Listener {
    fn drop(&mut self) {
        // A server runs until it is killed; a run has usually ended by itself.
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}

/// A client that attaches to a run.
fn attach(run: &Listener, options: &Value) -> Session {
    let mut session = Session::connected(&run.address);
    session.ask("initialize", json!({ "adapterID": "val3" }));
    session.ask("attach", with_secret(options, &run.secret));
    assert_eq!(session.event("capabilities")["capabilities"]["supportTerminateDebuggee"], true);
    session.event("initialized");
    session
}

fn with_secret(options: &Value, secret: &str) -> Value {
    let mut arguments = options.clone();
    arguments["secret"] = secret.into();
    arguments
}

fn stop_in_the_run(session: &mut Session) -> i64 {
    session.ask("configurationDone", json!({}));
    let task = session.ask("threads", json!({}))["threads"][0]["id"].clone();
    session.ask("pause", json!({ "threadId": task }));
    session.stopped("pause")
}

#[test]
fn clients_attach_to_a_run_and_leave_it() {
    let mut run = Listener::run(&[]);
    for _ in 0..2 {
        let mut session = attach(&run, &json!({}));
        assert!(session.refused("restart", json!({})).contains("attached"));
        let task = stop_in_the_run(&mut session);
        session.ask("next", json!({ "threadId": task }));
        session.event("stopped");
        session.ask("stepBack", json!({ "threadId": task }));
        session.event("stopped");
        session.ask("disconnect", json!({}));
        assert!(run.is_running());
    }
    let mut session = attach(&run, &json!({}));
    session.ask("pause", json!({ "threadId": 0 }));
    session.stopped("pause");
    session.ask("configurationDone", json!({}));
    session.event("process");
    session.ask("disconnect", json!({}));
    let mut session = attach(&run, &json!({ "stopOnEntry": true }));
    session.ask("configurationDone", json!({}));
    session.stopped("pause");
    session.ask("disconnect", json!({ "terminateDebuggee": true }));
    let text = run.ending();
    assert!(text.contains("the debugger has ended the run"), "{text}");
}

/// The page shows a step back at once, without another cycle or command.
#[test]
fn a_page_follows_a_debugger_that_steps_back() {
    let code = "num nA\nnA=1\nnA=2\nnA=3\ndelay(1)\n";
    let mut run = ServedRun::of(code, &["--debug-port", "0", "--debug-wait"]);
    let note = run.wait_for("waits for a debugger on");
    let mut words = note.split_whitespace();
    let address = words.find(|word| word.starts_with("127.0.0.1:")).unwrap().to_owned();
    let mut viewer = Viewer::new(&run.operator);
    let mut session = Session::connected(&address);
    session.ask("initialize", json!({ "adapterID": "val3" }));
    session.ask("attach", with_secret(&json!({ "stopOnEntry": true }), words.next_back().unwrap()));
    session.event("initialized");
    session.ask("configurationDone", json!({}));
    let task = session.stopped("entry");
    for command in ["next", "next", "stepBack"] {
        session.ask(command, json!({ "threadId": task }));
        session.stopped("step");
    }
    let rewind = viewer.next_of("rewind")["t"].as_f64().unwrap();
    assert!(rewind > 0.0 && rewind < 1e-3, "{rewind}");
}

#[test]
fn a_run_waits_for_its_debugger() {
    let run = Listener::run(&["--debug-wait", "--until", "1"]);
    let mut session = attach(&run, &json!({ "stopOnEntry": true }));
    session.ask("configurationDone", json!({}));
    let task = session.stopped("entry");
    let (name, ..) = session.frame(task);
    assert_eq!(name, "palletiser:start()");
    session.ask("continue", json!({ "threadId": task }));
    assert_eq!(session.event("exited")["exitCode"], 3);
    session.event("terminated");
    session.ask("disconnect", json!({}));
    run.ending();
}

#[test]
fn a_run_stays_stopped_until_the_next_client() {
    let mut run = Listener::run(&[]);
    let mut session = attach(&run, &json!({}));
    stop_in_the_run(&mut session);
    let pose = session.ask("val3/pose", json!({}));
    session.ask("disconnect", json!({ "suspendDebuggee": true }));
    let mut session = attach(&run, &json!({}));
    session.ask("configurationDone", json!({}));
    session.stopped("pause");
    assert_eq!(session.ask("val3/pose", json!({})), pose);
    // The run continues after a broken connection.
    drop(session);
    let mut session = attach(&run, &json!({}));
    stop_in_the_run(&mut session);
    assert!(run.is_running());
    session.ask("disconnect", json!({ "terminateDebuggee": true }));
    run.ending();
}

#[test]
fn a_second_client_is_told_that_there_is_another() {
    let run = Listener::run(&[]);
    let mut session = attach(&run, &json!({}));
    let mut second = Session::connected(&run.address);
    second.ask("initialize", json!({ "adapterID": "val3" }));
    let arguments = json!({ "secret": run.secret });
    assert_eq!(second.refused("attach", arguments.clone()), "another client debugs this run");
    session.ask("disconnect", json!({}));
    second.ask("attach", arguments);
}

#[test]
fn an_adapter_on_standard_input_attaches() {
    let run = Listener::run(&[]);
    let mut session = Session::new();
    session.ask("initialize", json!({ "adapterID": "val3" }));
    let reason = session.refused("attach", json!({ "port": 1 }));
    assert!(reason.contains("--debug-port 1"), "{reason}");
    let reason = session.refused("attach", json!({ "port": run.port(), "secret": "0" }));
    assert!(reason.contains("`secret` is another one"), "{reason}");
    session.ask("attach", json!({ "port": run.port(), "secret": run.secret }));
    session.event("initialized");
    let task = stop_in_the_run(&mut session);
    let process = session.event("process");
    assert_eq!((&process["name"], &process["startMethod"]), (&json!("palletiser"), &json!("attach")));
    session.ask("stepIn", json!({ "threadId": task }));
    session.event("stopped");
    session.ask("disconnect", json!({ "terminateDebuggee": true }));
    run.ending();
    session.assert_ended();
}

/// A page in a browser could send this request.
#[test]
fn a_port_refuses_what_is_no_debugger() {
    let mut run = Listener::run(&[]);
    let mut stream = TcpStream::connect(&run.address).unwrap();
    let body = json!({ "seq": 1, "type": "request", "command": "initialize", "arguments": { "adapterID": "x" } });
    let (body, mut answer) = (body.to_string(), String::new());
    let request = format!("POST / HTTP/1.1\r\nContent-Length: {}\r\n\r\n{body}", body.len());
    stream.write_all(request.as_bytes()).unwrap();
    // The system resets a connection that is closed with unread bytes.
    let _ = stream.read_to_string(&mut answer);
    assert_eq!(answer, "");
    assert!(run.is_running());
}

#[test]
fn two_sessions_through_a_port_are_independent() {
    let server = Listener::new(&["dap", "--port", "0"]);
    let secret = json!({ "secret": server.secret });
    let (mut first, task) = Session::connected(&server.address).launch(secret.clone());
    let (mut second, other) = Session::connected(&server.address).launch(secret);
    first.ask("next", json!({ "threadId": task }));
    first.stopped("step");
    assert_ne!(first.frame(task).1, second.frame(other).1);
    first.ask("disconnect", json!({}));
    second.ask("next", json!({ "threadId": other }));
    second.stopped("step");
    second.ask("disconnect", json!({}));
}

/// The listening process would write each file that an option names.
#[test]
fn a_client_without_the_secret_changes_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let server = Listener::new(&["dap", "--port", "0"]);
    let canary = folder.path().join("canary");
    std::fs::write(&canary, "sings").unwrap();
    let mut session = Session::connected(&server.address);
    session.ask("initialize", json!({ "adapterID": "val3" }));
    for option in ["events", "trace", "traceAll", "plot", "times", "export"] {
        let launch = json!({ "program": application(), "until": 1, option: canary, "noDebug": true });
        let reason = session.refused("launch", launch.clone());
        assert!(reason.contains("`secret` is missing"), "{reason}");
        let reason = session.refused("launch", with_secret(&launch, &"0".repeat(32)));
        assert!(reason.contains("`secret` is another one"), "{reason}");
    }
    assert!(session.refused("attach", json!({ "port": 1 })).contains("`secret` is missing"));
    for (command, arguments) in [
        ("evaluate", json!({ "expression": "1" })),
        ("threads", json!({})),
        ("val3/key", json!({ "key": "F1" })),
        ("setBreakpoints", json!({ "source": { "path": canary } })),
    ] {
        session.refused(command, arguments);
    }
    session.ask("disconnect", json!({}));
    assert_eq!(std::fs::read_to_string(&canary).unwrap(), "sings");
    assert_eq!(folder.path().read_dir().unwrap().count(), 1);
}

#[test]
fn a_client_without_the_secret_leaves_a_run_alone() {
    let mut run = Listener::run(&["--debug-wait"]);
    let mut session = Session::connected(&run.address);
    session.ask("initialize", json!({ "adapterID": "val3" }));
    assert!(session.refused("attach", json!({ "stopOnEntry": true })).contains("`secret` is missing"));
    session.refused("pause", json!({ "threadId": 0 }));
    session.ask("disconnect", json!({ "terminateDebuggee": true }));
    assert!(run.is_running());
    let mut session = attach(&run, &json!({ "stopOnEntry": true }));
    session.ask("configurationDone", json!({}));
    session.stopped("entry");
    session.ask("disconnect", json!({ "terminateDebuggee": true }));
    run.ending();
}

#[test]
fn the_environment_may_contain_the_secret() {
    let secret = "correct horse battery";
    let server = Listener::with_variables(&["dap", "--port", "0"], &[("VAL3_DEBUG_SECRET", secret)]);
    assert_eq!(server.secret, "VAL3_DEBUG_SECRET", "a chosen secret is not shown");
    let (mut session, _) = Session::connected(&server.address).launch(json!({ "secret": secret }));
    session.ask("disconnect", json!({}));
    let mut process = Command::new(env!("CARGO_BIN_EXE_val3"));
    let output = process.args(["dap", "--port", "0"]).env("VAL3_DEBUG_SECRET", "short").output().unwrap();
    assert_eq!(output.status.code(), Some(2));
    expect![[r"
        error: `VAL3_DEBUG_SECRET` is no text of at least 16 characters
          help: choose a longer secret, or unset the variable for a random one
    "]]
    .assert_eq(&String::from_utf8(output.stderr).unwrap());
}

/// `noDebug`, which the protocol specification defines, is passed on to the adapter process of a port.
#[test]
fn a_port_runs_without_debugging() {
    let server = Listener::new(&["dap", "--port", "0"]);
    let mut session = Session::connected(&server.address);
    session.ask("initialize", json!({ "adapterID": "val3" }));
    let launch = json!({ "program": application(), "until": 0.1, "noDebug": true });
    session.ask("launch", with_secret(&launch, &server.secret));
    session.set_breakpoint("start.pgx", json!({ "line": 15 }));
    session.ask("configurationDone", json!({}));
    assert_eq!(session.event("exited")["exitCode"], 3);
    session.ask("disconnect", json!({}));
}
