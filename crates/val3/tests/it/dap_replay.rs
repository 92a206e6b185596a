//! A recorded run as a debug session.

use serde_json::{Value, json};

use crate::dap_client::Session;
use crate::support::Folder;

const COUNTS: &str = "num nCount\nprogram start()\nbegin\n  while true\n    nCount=nCount+1\n    ? nCount\n    \
                      delay(1)\n  endWhile\nend\nprogram stop()\nbegin\nend\n";

const OPERATED: &str = "num nCount\nprogram start()\nbegin\n  wait(nCount==7)\n  ? nCount\n  delay(1)\nend\nprogram stop()\n\
                        begin\nend\n";

const OPERATOR: &str = "[[at]]\nt = 0.5\nset = { nCount = 7 }\n";

/// A recording of 2.5 s, `run.jsonl`.
fn recorded() -> Folder {
    let folder = Folder::with(COUNTS);
    assert_eq!(folder.val3(&["run", "--until", "2.5", "--until-ok", "--events", "run.jsonl"]).code, 0);
    folder
}

/// Launches a replay of the recording, with a breakpoint at the line of `delay`.
fn replay(folder: &Folder, options: &Value) -> Session {
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let mut session = Session::new();
    session.ask("initialize", json!({ "adapterID": "val3" }));
    let mut launch = json!({ "program": path("usrapp/main"), "replay": path("run.jsonl"), "time": "real" });
    launch.as_object_mut().unwrap().extend(options.as_object().unwrap().clone());
    session.ask("launch", launch);
    session.event("initialized");
    let program = folder.read("usrapp/main/start.pgx");
    let line = program.lines().position(|line| line.contains("delay(1)")).unwrap() + 1;
    let source = json!({ "path": path("usrapp/main/start.pgx") });
    session.ask("setBreakpoints", json!({ "source": source, "breakpoints": [{ "line": line }] }));
    session.ask("configurationDone", json!({}));
    session
}

#[test]
fn a_recording_opens_at_its_end() {
    let folder = recorded();
    let mut session = replay(&folder, &json!({ "startAtEnd": true }));
    let stop = session.event("stopped");
    assert_eq!(stop["description"], "Paused at the end of the recording");
    let task = stop["threadId"].clone();
    let (_, _, frame) = session.frame(task.as_i64().unwrap());
    assert_eq!(session.evaluate(frame, "nCount"), "3");
    assert_eq!(session.ask("val3/past", json!({}))["time"], json!(2.5));
    session.ask("reverseContinue", json!({ "threadId": task }));
    let (_, _, frame) = {
        let task = session.stopped("breakpoint");
        session.frame(task)
    };
    assert_eq!(session.evaluate(frame, "nCount"), "3");
    session.ask("reverseContinue", json!({ "threadId": task }));
    session.stopped("breakpoint");
    session.ask("continue", json!({ "threadId": task }));
    session.stopped("breakpoint");
    session.ask("continue", json!({ "threadId": task }));
    let again = session.event("stopped");
    assert_eq!(again["description"], "Paused at the end of the recording", "it has been somewhere else");
    session.ask("continue", json!({ "threadId": task }));
    assert_eq!(session.event("exited")["exitCode"], 0);
    session.end();
}

#[test]
fn a_run_that_differs_from_its_recording_stops_there() {
    let folder = recorded();
    let program = folder.read("usrapp/main/start.pgx");
    folder.write("usrapp/main/start.pgx", &program.replace("? nCount", "? nCount*nCount"));
    let mut session = replay(&folder, &json!({ "startAtEnd": true }));
    let task = session.stopped("pause");
    let (_, _, frame) = session.frame(task);
    assert_eq!(session.evaluate(frame, "nCount"), "2");
    let said = loop {
        let output = session.event("output")["output"].as_str().unwrap().to_owned();
        if output.contains("differs") {
            break output;
        }
    };
    assert!(said.contains("at line 4") && said.contains("this run: {"), "{said}");
    session.end();
}

#[test]
fn a_run_that_was_operated_opens_at_its_end() {
    let folder = Folder::with(OPERATED);
    folder.write("operator.toml", OPERATOR);
    let run = folder.val3(&["run", "--script", "operator.toml", "--events", "run.jsonl"]);
    assert_eq!((run.code, run.stdout.as_str()), (0, "7\n"));
    let mut session = replay(&folder, &json!({ "startAtEnd": true }));
    let stop = session.event("stopped");
    assert_eq!(stop["description"], "Paused before the end of the application");
    let (_, _, frame) = session.frame(stop["threadId"].as_i64().unwrap());
    assert_eq!(session.evaluate(frame, "nCount"), "7");
    session.end();
}

#[test]
fn a_run_that_waits_for_an_action_that_cannot_be_repeated_differs() {
    let folder = Folder::with(OPERATED);
    folder.write("operator.toml", OPERATOR);
    folder.val3(&["run", "--script", "operator.toml", "--events", "run.jsonl"]);
    let events = folder.read("run.jsonl");
    folder.write("run.jsonl", &events.replace("\"set\"", "\"somethingNew\""));
    let mut session = replay(&folder, &json!({ "startAtEnd": true }));
    assert!(session.event("output")["output"].as_str().unwrap().contains("a replay cannot repeat, at 0.5 s"));
    let said = session.event("output")["output"].as_str().unwrap().to_owned();
    assert!(said.contains("differs") && said.contains("this run has no further event"), "{said}");
    session.stopped("pause");
    session.end();
}

#[test]
fn a_file_without_events_is_refused() {
    let folder = Folder::with(COUNTS);
    folder.write("run.jsonl", "");
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let mut session = Session::new();
    session.ask("initialize", json!({ "adapterID": "val3" }));
    let launch = json!({ "program": path("usrapp/main"), "replay": path("run.jsonl") });
    assert!(session.refused("launch", launch).contains("the file has no events"));
}

#[test]
fn a_replay_stops_at_breakpoints_and_at_its_end() {
    let folder = recorded();
    let mut session = replay(&folder, &json!({ "stopOnExit": true, "time": "virtual" }));
    for _ in 0..3 {
        let task = session.stopped("breakpoint");
        session.ask("continue", json!({ "threadId": task }));
    }
    assert_eq!(session.event("stopped")["description"], "Paused at the end of the recording");
    session.end();
}

#[test]
fn an_end_needs_a_recording() {
    let folder = Folder::with(COUNTS);
    let mut session = Session::new();
    session.ask("initialize", json!({ "adapterID": "val3" }));
    let launch = json!({ "program": folder.path().join("usrapp/main").to_str().unwrap(), "startAtEnd": true });
    let refusal = session.refused("launch", launch);
    assert_eq!(refusal, "`startAtEnd` needs `replay`, the recording of a run");
}
