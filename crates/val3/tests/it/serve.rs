//! `val3 run --serve`: a run in the browser, with clients that know the addresses from its output.

use std::net::TcpStream;
use std::process::{Child, Stdio};
use std::time::{Duration, Instant};

use rustix::process::{Pid, Signal, kill_process};
use serde_json::{Value, json};
use tungstenite::http::Request;
use tungstenite::{Message, WebSocket};

use crate::support::Folder;
use crate::waiting::{OutputLines, Wait, ended};

/// A program that prints 25 times a second.
const PRINTING: &str = "num nCount\nwhile true\n  nCount=nCount+1\n  ? nCount\n  delay(0.04)\nendWhile\n";

/// A run that is served.
pub(crate) struct ServedRun {
    process: Child,
    stderr: OutputLines,
    pub(crate) operator: String,
    pub(crate) guest: String,
    pub(crate) folder: Folder,
}

impl ServedRun {
    pub(crate) fn of(code: &str, options: &[&str]) -> Self {
        Self::with_variables(code, options, &[])
    }

    fn with_variables(code: &str, options: &[&str], variables: &[(&str, &str)]) -> Self {
        let folder = Folder::with(code);
        let run = ["run", "usrapp/main", "--serve", "127.0.0.1:0"];
        let mut command = folder.command(&[&run, options].concat());
        let mut process =
            command.envs(variables.iter().copied()).stdout(Stdio::null()).stderr(Stdio::piped()).spawn().unwrap();
        let stderr = OutputLines::of(process.stderr.take().unwrap());
        // Findings of the application come first.
        let [operator, guest] =
            [(), ()].map(|()| stderr.wait_for("http://").trim().rsplit(' ').next().unwrap().to_owned());
        assert!(operator.starts_with("http://127.0.0.1:"), "{operator}");
        Self { process, stderr, operator, guest, folder }
    }

    pub(crate) fn signal(&self, signal: Signal) {
        kill_process(Pid::from_child(&self.process), signal).unwrap();
    }

    /// Waits for a line of the error output that contains a text, and returns it.
    #[track_caller]
    pub(crate) fn wait_for(&mut self, text: &str) -> String {
        self.stderr.wait_for(text)
    }

    /// The exit code and the rest of the error output.
    #[track_caller]
    pub(crate) fn ending(&mut self) -> (i32, String) {
        let code = ended(&mut self.process).code().unwrap();
        (code, self.stderr.rest())
    }
}

impl Drop for ServedRun {
    fn drop(&mut self) {
        // The process has already ended, unless the test has failed.
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}

/// A page in a browser.
pub(crate) struct Viewer(WebSocket<TcpStream>);

impl Viewer {
    pub(crate) fn new(page: &str) -> Self {
        let address = page.strip_prefix("http://").unwrap();
        let (host, _) = address.split_once('/').unwrap();
        let stream = TcpStream::connect(host).unwrap();
        stream.set_read_timeout(Some(Duration::from_secs(20))).unwrap();
        let request = Request::get(format!("ws://{address}socket"))
            .header("Host", host)
            .header("Origin", format!("http://{host}"))
            .header("Connection", "Upgrade")
            .header("Upgrade", "websocket")
            .header("Sec-WebSocket-Version", "13")
            .header("Sec-WebSocket-Key", "dGhlIHNhbXBsZSBub25jZQ==");
        Self(tungstenite::client(request.body(()).unwrap(), stream).unwrap().0)
    }

    /// The next text message.
    #[track_caller]
    fn next(&mut self) -> Value {
        let mut wait = Wait::new("text message");
        loop {
            match self.0.read().unwrap() {
                Message::Text(text) => return serde_json::from_str(&text).unwrap(),
                other => wait.saw(format!("{other:?}")),
            }
        }
    }

    /// Returns the next message `clock` of a paused run.
    #[track_caller]
    pub(crate) fn paused_clock(&mut self) -> Value {
        let mut wait = Wait::new("clock of a paused run");
        loop {
            let clock = self.next_of("clock");
            if clock["isPaused"] == true {
                return clock;
            }
            wait.saw(clock.to_string());
        }
    }

    /// The next message of a kind. A clock message each second keeps a connection alive that has no other messages.
    #[track_caller]
    pub(crate) fn next_of(&mut self, kind: &str) -> Value {
        let mut wait = Wait::new(format!("message `{kind}`"));
        loop {
            let message = self.next();
            if message["kind"] == kind {
                return message;
            }
            wait.saw(message["kind"].to_string());
        }
    }

    /// The next message `state` with a property.
    #[track_caller]
    fn next_state(&mut self, has_property: impl Fn(&Value) -> bool) -> Value {
        let mut wait = Wait::new("message `state` with a property");
        loop {
            let state = self.next_of("state");
            if has_property(&state) {
                return state;
            }
            wait.saw(state.to_string());
        }
    }

    /// Sends a command and returns the answer.
    pub(crate) fn command(&mut self, command: Value) -> Value {
        self.0.send(Message::text(command.to_string())).unwrap();
        self.next_of("answer")
    }

    /// Returns the text of the next note.
    #[track_caller]
    fn next_notice(&mut self) -> String {
        let mut wait = Wait::new("note");
        loop {
            let events = self.next_of("events");
            let notice = events["events"].as_array().unwrap().iter().find(|event| event["kind"] == "notice");
            if let Some(notice) = notice {
                return notice["text"].as_str().unwrap().to_owned();
            }
            wait.saw(events.to_string());
        }
    }

    /// The next printed text and its time.
    #[track_caller]
    pub(crate) fn next_print(&mut self) -> (f64, String) {
        let mut wait = Wait::new("printed text");
        loop {
            let events = self.next_of("events");
            let print = events["events"].as_array().unwrap().iter().find(|event| event["kind"] == "print");
            if let Some(print) = print {
                return (print["t"].as_f64().unwrap(), print["text"].as_str().unwrap().to_owned());
            }
            wait.saw(events.to_string());
        }
    }
}

#[test]
fn viewers_see_a_run_from_its_beginning() {
    let mut run = ServedRun::of("? \"<script>alert(1)</script>\"\ndelay(3600)\n", &[]);
    let mut viewers = [&run.operator, &run.guest, &run.operator].map(|page| Viewer::new(page));
    for viewer in &mut viewers {
        assert_eq!(viewer.next()["kind"], "scene");
        assert_eq!(viewer.next_print().1, "<script>alert(1)</script>");
    }
    run.signal(Signal::INT);
    assert_eq!(viewers[0].next_of("end")["exitCode"], 130);
    let (code, text) = run.ending();
    assert_eq!(code, 130);
    assert!(text.contains("interrupted"), "{text}");
}

#[test]
fn the_server_stays_after_the_end_of_the_run() {
    let mut run = ServedRun::of("? 1\n", &[]);
    run.wait_for("the run has ended");
    let mut viewer = Viewer::new(&run.operator);
    assert_eq!(viewer.next_of("end")["exitCode"], 0);
    let answer = viewer.command(json!({ "id": 1, "command": "pace", "isPaused": true }));
    assert_eq!(answer["error"], "the run has ended; Run starts the application again");
    run.signal(Signal::INT);
    assert_eq!(run.ending().0, 0);
}

/// The arm is jogged without an application. The moves that the application has not executed do not disturb it.
#[test]
fn the_arm_is_jogged_after_the_end_of_the_run() {
    let code = "joint jA\nmdesc mA\ntool tA\nmovej({60,0,90,0,0,0},tA,mA)\ndelay(0.1)\n";
    let mut run = ServedRun::of(code, &["--arm", "TX2-60L", "--power", "--until", "0.3"]);
    run.wait_for("the run has ended");
    let mut viewer = Viewer::new(&run.operator);
    assert_eq!(viewer.next_of("end")["reason"], "finished");
    let operate = |viewer: &mut Viewer, keys: Value| {
        viewer.command(json!({ "id": 1, "command": "operate", "keys": keys }))["error"].clone()
    };
    assert_eq!(operate(&mut viewer, json!({ "mode": "manual" })), Value::Null);
    viewer.next_state(|state| state["mode"] == "manual" && state["power"] == false);
    assert_eq!(operate(&mut viewer, json!({ "power": true, "jog": [10, 20, 90, 0, -30, 0] })), Value::Null);
    viewer.next_state(|state| state["power"] == true);
    let late = viewer.next_state(|state| state["config"].as_str().unwrap().contains("wnegative"));
    assert!(late["t"].as_f64().unwrap() > 0.3, "{late}");
    assert_eq!(operate(&mut viewer, json!({ "stop": true })), "the run has ended; Run starts the application again");
}

/// Tasks of a run that was ended by its limit could continue, so that its arm is not moved.
#[test]
fn the_arm_of_an_interrupted_run_is_not_jogged() {
    let mut run = ServedRun::of("delay(3600)\n", &["--until", "0.1"]);
    run.wait_for("the run has ended");
    let mut viewer = Viewer::new(&run.operator);
    assert_eq!(viewer.next_of("end")["reason"], "limit");
    let answer = viewer.command(json!({ "id": 1, "command": "operate", "keys": { "power": true } }));
    assert!(answer["error"].as_str().unwrap().contains("while the application was running"), "{answer}");
}

#[test]
fn an_operator_starts_the_application_again() {
    let mut run = ServedRun::of("? 1\n", &[]);
    run.wait_for("the run has ended");
    let mut viewer = Viewer::new(&run.operator);
    assert_eq!(viewer.next_of("end")["reason"], "finished");
    let start = json!({ "id": 1, "command": "run" });
    let file = "usrapp/main/start.pgx";
    let before = run.folder.read(file);
    run.folder.write(file, &before.replace("? 1", "? nUnknown"));
    let reason = viewer.command(start.clone())["error"].as_str().unwrap().to_owned();
    assert!(reason.contains("start.pgx:") && reason.contains("nUnknown"), "{reason}");
    run.wait_for("nUnknown");

    run.folder.write(file, &before.replace("? 1", "? 2\n    wait(false)"));
    assert_eq!(viewer.command(start.clone())["error"], Value::Null);
    assert_eq!(viewer.next_of("scene")["role"], "operator");
    assert_eq!(viewer.next_print().1, "2");
    let mut late = Viewer::new(&run.guest);
    assert_eq!(late.next()["kind"], "scene");
    assert_eq!(late.next_print().1, "2");
    assert_eq!(viewer.command(start)["error"], "the application is running");
    run.signal(Signal::INT);
    assert_eq!(run.ending().0, 130);
}

/// As on a real controller, the arm stays where the last run ended or the operator has jogged it. The record of such a run
/// contains the position, so that its replay is equal.
#[test]
fn the_arm_stays_where_it_is_when_the_application_starts_again() {
    let code = "joint jA\nmdesc mA\ntool tA\njA=herej()\n? jA.j1\nmovej({60,0,90,0,0.1,0},tA,mA)\nwaitEndMove()\n";
    let options = ["--arm", "TX2-60L", "--power", "--start", "10,0,90,0,30,0", "--events", "run.jsonl"];
    let mut run = ServedRun::of(code, &options);
    let mut viewer = Viewer::new(&run.operator);
    assert_eq!(viewer.next_print().1, "10");
    assert_eq!(viewer.next_of("end")["reason"], "finished");

    let start = |id: i32| json!({ "id": id, "command": "run" });
    assert_eq!(viewer.command(start(1))["error"], Value::Null);
    run.wait_for("the arm stays at (60, 0, 90, 0, 0.1, 0)");
    assert_eq!(viewer.next_notice(), "the application starts again; the arm stays at (60, 0, 90, 0, 0.1, 0)");
    assert_eq!(viewer.next_print().1, "60");
    viewer.next_of("end");
    let replay = run.folder.val3(&["run", "--replay", "run.jsonl", "--events", "again.jsonl"]);
    assert_eq!((replay.code, replay.stdout.as_str()), (0, "60\n"), "{}", replay.stderr);
    assert_eq!(run.folder.read("again.jsonl"), run.folder.read("run.jsonl"));

    let initial = json!({ "id": 2, "command": "run", "atInitialPosition": true });
    assert_eq!(viewer.command(initial)["error"], Value::Null);
    assert_eq!(viewer.next_notice(), "the application starts again; the arm is at its initial position");
    assert_eq!(viewer.next_print().1, "10");
}

/// The settings of an ended run may name another arm, which cannot stand where the arm was.
#[test]
fn an_arm_that_cannot_stay_starts_at_its_initial_position() {
    let code = "joint jA\nmdesc mA\ntool tA\njA=herej()\n? jA.j2\nmovej({0,-129,90,0,30,0},tA,mA)\nwaitEndMove()\n";
    let mut run = ServedRun::of(code, &["--power"]);
    let mut viewer = Viewer::new(&run.operator);
    assert_eq!(viewer.next_print().1, "0");
    assert_eq!(viewer.next_of("end")["reason"], "finished");
    run.folder.write("val3.toml", "arm = \"TX2-60L\"\n");
    let answer = viewer.command(json!({ "id": 1, "command": "run", "atInitialPosition": "yes" }));
    assert_eq!(answer["error"], "`atInitialPosition` is true or false");
    assert_eq!(viewer.command(json!({ "id": 2, "command": "run" }))["error"], Value::Null);
    let note = viewer.next_notice();
    let beginning = "the application starts again; the arm is at its initial position, because it cannot stay at (0, -129, 90, 0, 30, 0): ";
    assert!(note.starts_with(beginning), "{note}");
    run.wait_for("because it cannot stay");
    assert_eq!(viewer.next_print().1, "0");
}

#[test]
fn unsaved_points_survive_the_end_and_a_new_start() {
    let mut run = ServedRun::of("point pA\n? pA.trsf.x\n", &[]);
    run.wait_for("the run has ended");
    let mut viewer = Viewer::new(&run.operator);
    let file = "usrapp/main/main.dtx";
    let before = run.folder.read(file);
    let set = |x: f64| json!({ "id": 1, "command": "setPoint", "name": "pA", "local": [x, 0, 0, 0, 0, 0] });
    assert_eq!(viewer.command(set(7.25))["error"], Value::Null);
    assert_eq!(viewer.command(json!({ "id": 2, "command": "run" }))["error"], Value::Null);
    assert_eq!(viewer.next_of("unsaved")["points"], json!([{ "name": "pA", "key": null }]));
    assert_eq!(viewer.next_print().1, "7.25");
    viewer.next_of("end");
    assert_eq!(viewer.command(json!({ "id": 3, "command": "save" }))["files"], json!(["Disk://main/main.dtx"]));
    let saved = run.folder.read(file);
    assert!(saved != before && saved.contains(r#"x="7.25""#), "{saved}");

    assert_eq!(viewer.command(set(1.5))["error"], Value::Null);
    assert_eq!(viewer.command(json!({ "id": 4, "command": "undo" }))["error"], Value::Null);
    assert_eq!(viewer.command(set(8.5))["error"], Value::Null);
    run.signal(Signal::INT);
    let (code, text) = run.ending();
    assert_eq!(code, 0);
    assert!(text.contains("`Disk://main/main.dtx.unsaved` contains the unsaved points"), "{text}");
    assert_eq!(run.folder.read(file), saved);
    assert_eq!(run.folder.read("usrapp/main/main.dtx.unsaved"), saved.replace(r#"x="7.25""#, r#"x="8.5""#));
}

/// A signal while the application is running loses no points either.
#[test]
fn an_interrupted_run_rescues_unsaved_points() {
    let mut run = ServedRun::of("point pA\ndelay(3600)\n", &[]);
    let mut viewer = Viewer::new(&run.operator);
    let set = json!({ "id": 1, "command": "setPoint", "name": "pA", "local": [3.5, 0, 0, 0, 0, 0] });
    assert_eq!(viewer.command(set)["error"], Value::Null);
    run.signal(Signal::INT);
    assert_eq!(run.ending().0, 130);
    assert!(run.folder.read("usrapp/main/main.dtx.unsaved").contains(r#"x="3.5""#));
}

#[test]
fn a_chosen_secret_keeps_the_addresses() {
    let secrets = |run: &ServedRun| [&run.operator, &run.guest].map(|page| page.rsplit('/').nth(1).unwrap().to_owned());
    let variable = [("VAL3_SERVE_SECRET", "correct horse battery")];
    let [first, second] = [(); 2].map(|()| ServedRun::with_variables("delay(3600)\n", &[], &variable));
    assert_eq!(secrets(&first), secrets(&second));
    assert_ne!(first.operator, first.guest);
    let other = ServedRun::of("delay(3600)\n", &[]);
    assert_ne!(secrets(&first), secrets(&other));
}

#[test]
fn operators_change_the_pace() {
    let mut run = ServedRun::of(PRINTING, &[]);
    let mut viewer = Viewer::new(&run.operator);
    let done = |answer: Value| assert_eq!(answer["error"], Value::Null, "{answer}");
    done(viewer.command(json!({ "id": 1, "command": "pace", "isPaused": true })));
    let mut second = Viewer::new(&run.guest);
    let clock = second.paused_clock();
    assert_eq!((&clock["isPaused"], &clock["speed"]), (&json!(true), &json!(1.0)));
    let paused = clock["t"].as_f64().unwrap();
    // Ten cycles of 4 ms: the next print.
    done(viewer.command(json!({ "id": 2, "command": "cycle", "cycles": 11 })));
    let (time, _) = viewer.next_print();
    assert!((time - paused).abs() < 0.05, "{time} {paused}");
    done(viewer.command(json!({ "id": 3, "command": "pace", "isPaused": false, "speed": 50 })));
    let start = Instant::now();
    while viewer.next_print().0 < paused + 10.0 {}
    assert!(start.elapsed() < Duration::from_secs(5), "{:?}", start.elapsed());
    done(viewer.command(json!({ "id": 4, "command": "pace", "speed": "max" })));
    while viewer.next_print().0 < paused + 60.0 {}
    let answer = viewer.command(json!({ "id": 5, "command": "pace", "speed": 1000 }));
    assert!(answer["error"].as_str().unwrap().contains("0.1 to 100"), "{answer}");
    run.signal(Signal::TERM);
    assert_eq!(run.ending().0, 143);
}

#[test]
fn a_changed_point_is_saved_and_nothing_else() {
    let mut run = ServedRun::of("point pA[3]\nnum nCount\n  nCount=5\n  pA[0].trsf.x=9\n  delay(3600)\n", &[]);
    let mut viewer = Viewer::new(&run.operator);
    let file = "usrapp/main/main.dtx";
    let before = run.folder.read(file);
    let set =
        |x: f64| json!({ "id": 1, "command": "setPoint", "name": "pA", "key": "1", "local": [x, 0, 0, 0, 0, 0.5] });
    assert_eq!(viewer.command(set(7.25))["error"], Value::Null);
    assert_eq!(viewer.command(json!({ "id": 2, "command": "save" }))["files"], json!(["Disk://main/main.dtx"]));
    let saved = run.folder.read(file);
    let lines: Vec<&str> = before.lines().collect();
    let new: Vec<&str> = saved.lines().filter(|line| !lines.contains(line)).map(str::trim).collect();
    assert!(new.iter().any(|line| line.contains(r#"key="1" x="7.25" rz="0.5""#)), "{new:?}");
    assert!(!saved.contains(r#"x="9""#) && !saved.contains(r#"value="5""#), "{saved}");

    let edited = saved.replace("7.25", "8") + "<!-- by hand -->\n";
    run.folder.write(file, &edited);
    assert_eq!(viewer.command(set(1.5))["error"], Value::Null);
    let conflict = viewer.command(json!({ "id": 3, "command": "save" }));
    assert_eq!((&conflict["error"], &conflict["conflict"]), (&Value::Null, &json!(["Disk://main/main.dtx"])));
    assert_eq!(run.folder.read(file), edited);
    let answer = viewer.command(json!({ "id": 4, "command": "save", "overwrite": true }));
    assert_eq!(answer["error"], Value::Null, "{answer}");
    assert_eq!(run.folder.read(file), edited.replace(r#"x="8""#, r#"x="1.5""#));
    let mut guest = Viewer::new(&run.guest);
    assert_ne!(guest.command(json!({ "id": 5, "command": "save", "overwrite": true }))["error"], Value::Null);
    run.signal(Signal::INT);
    assert_eq!(run.ending().0, 130);
}

/// The run keeps real time, and another viewer receives its messages.
#[test]
fn a_viewer_that_never_reads_delays_nothing() {
    let mut run = ServedRun::of(PRINTING, &[]);
    let _silent: Vec<_> = (0..8).map(|_| Viewer::new(&run.operator)).collect();
    let mut viewer = Viewer::new(&run.operator);
    let ((begin, _), start) = (viewer.next_print(), Instant::now());
    let mut time = begin;
    while time < begin + 1.0 {
        time = viewer.next_print().0;
    }
    let (passed, real) = (time - begin, start.elapsed().as_secs_f64());
    // The first printed text may have been received late.
    assert!(real < passed + 0.2, "{passed} s of the controller took {real} s");
    run.signal(Signal::INT);
    assert_eq!(run.ending().0, 130);
}

/// No task of the program can continue by itself, but an operator may still act.
#[test]
fn a_run_waits_for_its_operator() {
    for options in [&[][..], &["--time", "virtual"]] {
        let run = ServedRun::of("bool bGo\n? \"ready\"\nwait(bGo)\n", options);
        let mut viewer = Viewer::new(&run.operator);
        assert_eq!(viewer.next_print().1, "ready");
        let answer = viewer.command(json!({ "id": 1, "command": "cycle" }));
        assert_eq!(answer["error"], "the run is not paused");
    }
}

#[test]
fn usage_is_checked() {
    let folder = Folder::with("? 1\n");
    let usage = |args: &[&str]| usage_error(&folder, args);
    assert!(usage(&["--serve", "--interactive"]).contains("cannot be used with"));
    assert!(usage(&["--open"]).contains("--serve"));
    assert!(usage(&["--serve", "somewhere"]).contains("ADDRESS:PORT"));
    let taken = std::net::TcpListener::bind("127.0.0.1:0").unwrap();
    let address = taken.local_addr().unwrap().to_string();
    assert!(usage(&["--serve", &address]).contains(&format!("cannot serve on {address}")));
}

fn usage_error(folder: &Folder, args: &[&str]) -> String {
    let run = folder.val3(&[&["run", "usrapp/main"], args].concat());
    assert_eq!((run.code, run.stdout.as_str()), (2, ""));
    run.stderr
}
