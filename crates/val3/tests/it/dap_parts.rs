//! Going back over a grip, and replays of runs with parts, in the debug adapter.

use serde_json::{Value, json};

use crate::dap_client::Session;
use crate::support::Folder;
use crate::{run_conveyors, run_parts};

fn path(folder: &Folder, name: &str) -> String {
    folder.path().join(name).to_str().unwrap().to_owned()
}

/// Sets breakpoints at the lines of `start` that contain these texts.
fn set_breakpoints(session: &mut Session, folder: &Folder, texts: &[&str]) {
    let program = folder.read("usrapp/main/start.pgx");
    let line = |text: &&str| program.lines().position(|line| line.contains(*text)).unwrap() + 1;
    let lines: Vec<Value> = texts.iter().map(|text| json!({ "line": line(text) })).collect();
    let source = json!({ "path": path(folder, "usrapp/main/start.pgx") });
    session.ask("setBreakpoints", json!({ "source": source, "breakpoints": lines }));
}

/// Continues to the next breakpoint, and returns the input that the gripper sets.
fn go(session: &mut Session, task: i64, request: &str) -> String {
    session.ask(request, json!({ "threadId": task }));
    let task = session.stopped("breakpoint");
    let (_, _, frame) = session.frame(task);
    let value = session.evaluate(frame, "diPart");
    value.split(' ').next().unwrap().to_owned()
}

#[test]
fn going_back_over_a_grip_opens_the_gripper_again() {
    let folder = run_parts::folder(1.0);
    // The input follows the grip in the next cycle.
    let program = folder.read("usrapp/main/start.pgx").replace("  pEnd=here", "  delay(0.1)\n  pEnd=here");
    folder.write("usrapp/main/start.pgx", &program);
    let (mut session, task) = Session::launched(json!({ "program": path(&folder, "usrapp/main"), "script": null }));
    set_breakpoints(&mut session, &folder, &["close(tGrip)", "open(tGrip)"]);
    assert_eq!(go(&mut session, task, "continue"), "false");
    let held = go(&mut session, task, "continue");
    assert_eq!(held, "true");
    assert_eq!(go(&mut session, task, "reverseContinue"), "false");
    assert_eq!(go(&mut session, task, "continue"), held);
    session.ask("continue", json!({ "threadId": task }));
    assert_eq!(session.event("exited")["exitCode"], 0);
}

/// Replays a recorded run to its end. A difference would stop it before.
fn replayed(folder: &Folder) {
    folder.val3(&["run", "--events", "run.jsonl"]);
    let mut session = Session::new();
    session.ask("initialize", json!({ "adapterID": "val3" }));
    let launch = json!({
        "program": path(folder, "usrapp/main"), "replay": path(folder, "run.jsonl"), "stopOnExit": true, "time": "virtual",
    });
    session.ask("launch", launch);
    session.event("initialized");
    session.ask("configurationDone", json!({}));
    assert_eq!(session.event("stopped")["description"], "Paused before the end of the application");
    session.end();
}

#[test]
fn a_replay_with_parts_has_the_same_events() {
    replayed(&run_parts::folder(1.0));
}

#[test]
fn a_replay_with_a_conveyor_has_the_same_events() {
    replayed(&run_conveyors::folder());
}
