//! `val3 dap` with misbehaving clients and programs: each request has a response, the process ends with its client, and
//! files are complete.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use serde_json::{Value, json};

use crate::dap_client::{Session, application, example};
use crate::support::{Folder, copy_folder};

/// Pseudo-random numbers from a seed.
struct Chance(u64);

impl Chance {
    fn below(&mut self, bound: usize) -> usize {
        // Constants of Knuth's MMIX generator.
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        usize::try_from(self.0 >> 33).unwrap() % bound
    }

    fn one<T: Clone>(&mut self, choices: &[T]) -> T {
        choices[self.below(choices.len())].clone()
    }
}

/// Requests of the specification that do not end the session, and unknown requests.
const COMMANDS: &[&str] = &[
    "initialize",
    "launch",
    "attach",
    "restart",
    "terminate",
    "breakpointLocations",
    "setBreakpoints",
    "setFunctionBreakpoints",
    "setExceptionBreakpoints",
    "dataBreakpointInfo",
    "setDataBreakpoints",
    "continue",
    "continue",
    "next",
    "next",
    "stepIn",
    "stepOut",
    "stepBack",
    "reverseContinue",
    "restartFrame",
    "goto",
    "gotoTargets",
    "pause",
    "pause",
    "stackTrace",
    "stackTrace",
    "scopes",
    "variables",
    "setVariable",
    "source",
    "threads",
    "terminateThreads",
    "modules",
    "loadedSources",
    "evaluate",
    "evaluate",
    "setExpression",
    "stepInTargets",
    "completions",
    "exceptionInfo",
    "cancel",
    "configurationDone",
    "readMemory",
    "nonsense",
];

/// A request `val3/…` in the schema of the adapter.
#[derive(Clone)]
struct OwnRequest {
    command: String,
    arguments: BTreeSet<String>,
}

impl OwnRequest {
    fn new(command: &str, definitions: &Value) -> Self {
        let path = &definitions["DebugRequests"]["properties"][command]["properties"]["arguments"]["$ref"];
        let arguments = &definitions[path.as_str().unwrap().trim_start_matches("#/$defs/")];
        let names = arguments["properties"].as_object().into_iter().flat_map(|properties| properties.keys().cloned());
        Self { command: command.to_owned(), arguments: names.collect() }
    }
}

/// All requests `val3/…`. None of them ends the session.
fn own_requests() -> Vec<OwnRequest> {
    let schema = val3_dap::debug_requests_schema().unwrap();
    let definitions = &schema["$defs"];
    let commands = definitions["DebugRequests"]["properties"].as_object().unwrap().keys();
    commands.map(|command| OwnRequest::new(command, definitions)).collect()
}

/// Argument names.
const KEYS: &[&str] = &[
    "threadId",
    "threadId",
    "threadIds",
    "frameId",
    "variablesReference",
    "source",
    "line",
    "endLine",
    "breakpoints",
    "lines",
    "filters",
    "filterOptions",
    "name",
    "value",
    "expression",
    "context",
    "text",
    "column",
    "targetId",
    "start",
    "count",
    "singleThread",
    "levels",
    "mode",
    "link",
    "joints",
];

fn number(chance: &mut Chance) -> Value {
    chance.one(&[
        json!(0),
        json!(1),
        json!(1),
        json!(2),
        json!(3),
        json!(7),
        json!(14),
        json!(-1),
        json!(i32::MAX),
        json!(1.5),
    ])
}

fn text(chance: &mut Chance) -> Value {
    let file = |name: &str| format!("{}/{name}", application());
    let texts = [
        "nState".to_owned(),
        "nLayer=nLayer+1".to_owned(),
        "1/0".to_owned(),
        "tSlots[1,2]".to_owned(),
        "l_bOk".to_owned(),
        "nTimes[99]".to_owned(),
        "call report(\"x\")".to_owned(),
        "\"".to_owned(),
        "ä{}".to_owned(),
        String::new(),
        "repl".to_owned(),
        "hover".to_owned(),
        "all".to_owned(),
        "codes".to_owned(),
        "step".to_owned(),
        "continuous".to_owned(),
        "BasicIO-1\\%I0".to_owned(),
        "F1".to_owned(),
        ">=2".to_owned(),
        "home".to_owned(),
        "part:grip".to_owned(),
        file("home.pgx"),
        file("sensors.pgx"),
        "../..".to_owned(),
    ];
    json!(chance.one(&texts))
}

/// A value of any type.
fn value(chance: &mut Chance, depth: usize) -> Value {
    match chance.below(if depth == 0 { 6 } else { 9 }) {
        0..=2 => number(chance),
        3..=4 => text(chance),
        5 => chance.one(&[json!(true), json!(false), json!(null)]),
        6 => {
            let count = chance.below(4);
            (0..count).map(|_| value(chance, depth - 1)).collect()
        }
        _ => arguments(chance, depth - 1),
    }
}

/// Random arguments, most of which have the right type.
fn arguments(chance: &mut Chance, depth: usize) -> Value {
    let mut object = serde_json::Map::new();
    for _ in 0..chance.below(7) {
        let key = chance.one(KEYS);
        let right = match key {
            "threadIds" | "lines" => json!([number(chance), number(chance)]),
            "joints" => json!([0, number(chance), 90, 0, 0, 0]),
            "source" => json!({ "path": text(chance) }),
            "breakpoints" => {
                let one = json!({ "line": chance.below(40), "name": text(chance), "dataId": text(chance), "hitCondition": text(chance) });
                json!([one])
            }
            "filters" => json!([text(chance)]),
            "filterOptions" => json!([{ "filterId": text(chance), "condition": text(chance) }]),
            "singleThread" => json!(chance.below(2) == 0),
            "name" | "value" | "expression" | "context" | "text" | "mode" | "link" => text(chance),
            _ => number(chance),
        };
        let wrong = chance.below(12) == 0;
        object.insert(key.to_owned(), if wrong { value(chance, depth) } else { right });
    }
    Value::Object(object)
}

/// Random arguments, completed by the required arguments of the request.
fn complete(command: &str, chance: &mut Chance) -> Value {
    let mut arguments = arguments(chance, 2);
    let needed = match command {
        "continue" | "next" | "stepIn" | "stepOut" | "stepBack" | "reverseContinue" | "pause" | "stackTrace"
        | "exceptionInfo" | "val3/endCall" | "val3/stepBackInto" | "val3/stepBackOut" => {
            json!({ "threadId": chance.below(7) })
        }
        "setBreakpoints" | "breakpointLocations" | "gotoTargets" => {
            json!({ "source": { "path": format!("{}/{}", application(), chance.one(&["home.pgx", "sensors.pgx", "x"])) }, "line": chance.below(40) })
        }
        "scopes" | "restartFrame" | "stepInTargets" => json!({ "frameId": chance.below(5) }),
        "variables" | "setVariable" => {
            json!({ "variablesReference": chance.below(12), "count": chance.below(50), "name": text(chance), "value": text(chance) })
        }
        "evaluate" | "setExpression" => json!({ "expression": text(chance), "value": text(chance) }),
        "goto" => json!({ "threadId": chance.below(7), "targetId": chance.below(4) }),
        "completions" => json!({ "text": text(chance), "column": chance.below(9) }),
        _ => json!({}),
    };
    // Required arguments are sometimes omitted.
    if chance.below(10) > 0 {
        arguments.as_object_mut().unwrap().extend(needed.as_object().unwrap().clone());
    }
    arguments
}

fn random_request(session: &mut Session, chance: &mut Chance, own_requests: &[OwnRequest]) -> i64 {
    if chance.below(4) > 0 {
        let command = chance.one(COMMANDS);
        let arguments = complete(command, chance);
        return session.send_any(command, &arguments);
    }
    let OwnRequest { command, arguments: known } = chance.one(own_requests);
    let mut arguments = complete(&command, chance);
    // Requests of the adapter reject unknown arguments.
    if chance.below(10) > 0 {
        arguments.as_object_mut().unwrap().retain(|name, _| known.contains(name));
    }
    session.send_any(&command, &arguments)
}

#[test]
fn random_requests_in_random_order_are_answered() {
    let own_requests = own_requests();
    for seed in 1..=6 {
        let mut chance = Chance(seed);
        let scope = chance.one(&["all", "task"]);
        let mode = chance.one(&["continuous", "step"]);
        let options = json!({ "until": 30, "stopScope": scope, "motionMode": mode, "pastSnapshots": 10 });
        let (mut session, _) = Session::launched(options);
        let (mut executed, mut is_over) = (0, false);
        for _ in 0..60 {
            // Several requests may be in progress.
            let count = 1 + chance.below(4);
            let requests: Vec<i64> =
                (0..count).map(|_| random_request(&mut session, &mut chance, &own_requests)).collect();
            for request in requests {
                let response = session.response(request);
                executed += usize::from(response["success"] == true);
                is_over |= response["message"] == "the run is over";
            }
            if std::mem::take(&mut is_over) {
                session.ask("restart", json!({}));
            }
        }
        assert!(executed > 40, "seed {seed}: only {executed} requests were executed");
        session.end();
    }
}

#[test]
fn breakpoints_change_while_the_run_continues() {
    let (mut session, task) = Session::launched(json!({}));
    session.ask("continue", json!({ "threadId": task }));
    let mut chance = Chance(7);
    for _ in 0..40 {
        let lines: Vec<Value> = (0..chance.below(4)).map(|_| json!({ "line": 8 + chance.below(12) })).collect();
        let file = chance.one(&["sensors.pgx", "supervisor.pgx", "home.pgx"]);
        let source = json!({ "path": format!("{}/{file}", application()) });
        let count = lines.len();
        let set = session.ask("setBreakpoints", json!({ "source": source, "breakpoints": lines }));
        assert_eq!(set["breakpoints"].as_array().unwrap().len(), count);
        // The task was stopped unless it did not exist.
        let response = session.request("continue", json!({ "threadId": task }));
        assert!(response["success"] == true || response["message"] == "notStopped", "{response}");
    }
    session.end();
}

/// Sends the last bytes of a client before it disconnects.
type Farewell = fn(&mut Session, i64) -> i64;

#[test]
fn a_client_that_disappears_takes_the_run_with_it() {
    let commands: [Farewell; 4] = [
        |session, task| session.send("next", json!({ "threadId": task })),
        |session, task| session.send("reverseContinue", json!({ "threadId": task })),
        |session, _| {
            session.send("evaluate", json!({ "expression": "do\n nState=0\n until false", "context": "repl" }))
        },
        |session, _| {
            session.write_bytes(b"Content-Length: 500\r\n\r\n{\"seq\":9,");
            0
        },
    ];
    for last in commands {
        let folder = Folder::empty();
        let events = folder.path().join("events.jsonl");
        let (mut session, task) = Session::launched(json!({ "motionMode": "step", "events": events }));
        session.set_breakpoint("home.pgx", json!({ "line": 22 }));
        session.ask("continue", json!({ "threadId": task }));
        let task = session.stopped("breakpoint");
        last(&mut session, task);
        session.assert_ended();
        // The record contains every event up to the end of the run.
        let written = fs::read_to_string(&events).unwrap();
        let lines: Vec<Value> = written.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
        assert!(written.ends_with('\n') && lines.len() > 10, "{written}");
        assert_eq!(lines.last().unwrap()["kind"], "end", "{written}");
    }
}

#[test]
fn a_launched_run_ends_with_its_session_whatever_the_client_asks() {
    for arguments in [
        json!({}),
        json!({ "terminateDebuggee": false }),
        json!({ "suspendDebuggee": true }),
        json!({ "restart": true }),
    ] {
        let (mut session, task) = Session::launched(json!({}));
        session.ask("continue", json!({ "threadId": task }));
        session.ask("disconnect", arguments);
        session.assert_ended();
    }
}

#[test]
fn two_sessions_of_an_application_are_independent() {
    let ((mut one, first), (mut other, second)) = (Session::launched(json!({})), Session::launched(json!({})));
    one.set_breakpoint("home.pgx", json!({ "line": 13 }));
    other.set_breakpoint("init.pgx", json!({ "line": 10 }));
    one.send("continue", json!({ "threadId": first }));
    other.send("continue", json!({ "threadId": second }));
    let (first, second) = (one.stopped("breakpoint"), other.stopped("breakpoint"));
    assert_eq!(one.frame(first).0, "palletiser:home()");
    let (name, _, frame) = other.frame(second);
    assert_eq!(name, "palletiser:init()");
    one.end();
    assert_eq!(other.evaluate(frame, "nLayer"), "0");
    other.end();
}

#[test]
fn a_program_that_fails_while_it_is_stopped_can_be_looked_at() {
    let (mut session, task) = Session::launched(json!({}));
    let (_, _, frame) = session.frame(task);
    let fails = json!({ "expression": "nTimes[99]=1", "frameId": frame, "context": "repl" });
    assert!(session.refused("evaluate", fails).contains("error"));
    session.set_breakpoint("home.pgx", json!({ "line": 13 }));
    session.ask("continue", json!({ "threadId": task }));
    session.stopped("breakpoint");
    // An unhandled error: the index is changed outside of the program.
    let threads = session.ask("threads", json!({}));
    let all: Vec<i64> =
        threads["threads"].as_array().unwrap().iter().map(|task| task["id"].as_i64().unwrap()).collect();
    session.ask("terminateThreads", json!({ "threadIds": all }));
    assert_eq!(session.ask("threads", json!({}))["threads"], json!([]));
    assert!(session.refused("stackTrace", json!({ "threadId": all[0] })).contains("no such task"));
    session.ask("evaluate", json!({ "expression": "nLayer", "context": "watch" }));
    session.ask("continue", json!({ "threadId": all[0] }));
    session.event("exited");
    session.end();
}

/// A copy of the example, and its application.
fn copy() -> (Folder, PathBuf) {
    let folder = Folder::empty();
    copy_folder(Path::new(&example("")), folder.path());
    let application = folder.path().join("usr/usrapp/palletiser");
    (folder, application)
}

/// Files of a folder with their content.
fn contents(folder: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let files = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    files.map(|path| (path.clone(), fs::read(path).unwrap())).collect()
}

#[test]
fn sources_change_while_they_are_debugged() {
    let (_folder, application) = copy();
    let (mut session, task) = Session::launched(json!({ "program": application }));
    let start = application.join("start.pgx");
    let whole = fs::read(&start).unwrap();
    let (_, first, frame) = session.frame(task);
    // The file is truncated; the program in memory is the version that was opened.
    fs::write(&start, &whole[..whole.len() / 2]).unwrap();
    session.ask("next", json!({ "threadId": task }));
    let task = session.stopped("step");
    assert!(session.frame(task).1 > first);
    let (_, _, now) = session.frame(task);
    assert_eq!(session.evaluate(now, "nLayer+1"), "1");
    assert!(session.refused("scopes", json!({ "frameId": frame + 100 })).contains("over"));
    fs::remove_file(&start).unwrap();
    session.ask("stepBack", json!({ "threadId": task }));
    session.event("stopped");
    session.ask("restart", json!({}));
    assert_eq!(session.event("exited")["exitCode"], 1, "the application cannot be opened");
    // With the restored file, the restart succeeds.
    fs::write(&start, &whole).unwrap();
    let before = contents(&application);
    session.ask("restart", json!({}));
    let task = session.stopped("entry");
    assert_eq!(session.frame(task).1, first);
    session.end();
    assert!(contents(&application) == before, "no file has changed");
}
