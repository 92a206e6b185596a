//! `val3 dap` as a process: a client debugs the shipped example.

use std::time::Duration;

use serde_json::json;

use crate::dap_client::{Session, application};
use crate::support::Folder;

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
    // The first line of the run.
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
fn a_line_leads_into_a_program_or_a_task() {
    let (mut session, task) = Session::launched(json!({}));
    let (_, _, frame) = session.frame(task);
    let targets = session.ask("stepInTargets", json!({ "frameId": frame }));
    assert_eq!(targets["targets"][0]["label"], "palletiser:init()");
    for _ in 0..2 {
        session.ask("next", json!({ "threadId": task }));
        session.stopped("step");
    }
    let (_, _, frame) = session.frame(task);
    let targets = session.ask("stepInTargets", json!({ "frameId": frame }));
    assert_eq!(targets["targets"][0]["label"], "the task of palletiser:supervisor()");
    session.ask("stepIn", json!({ "threadId": task, "targetId": targets["targets"][0]["id"] }));
    let created = session.stopped("step");
    assert_ne!(created, task);
    assert_eq!(session.frame(created).0, "palletiser:supervisor()");
    session.end();
}

#[test]
fn motion_is_stepped_piece_by_piece() {
    let (mut session, task) = Session::launched(json!({ "motionMode": "step" }));
    session.set_breakpoint("home.pgx", json!({ "line": 22 }));
    session.ask("continue", json!({ "threadId": task }));
    // In step mode, each line that changes the motion is a stop.
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
    let refusal = session.refused("val3/ioForce", json!({ "link": "BasicIO-2\\%I2", "value": true }));
    assert!(refusal.contains("did you mean"), "{refusal}");
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
fn a_long_search_shows_its_progress_and_is_cancelled() {
    let endless =
        "num nRound\nprogram start()\nbegin\n  while true\n    nRound=nRound+1\n    delay(0.004)\n  endWhile\nend\n";
    let folder = Folder::with(endless);
    let (mut session, task) = Session::launched(json!({ "program": folder.path(), "script": null }));
    session.ask("continue", json!({ "threadId": task }));
    std::thread::sleep(Duration::from_secs(2));
    session.ask("pause", json!({ "threadId": task }));
    session.stopped("pause");
    let (_, _, frame) = session.frame(task);
    let rounds = session.evaluate(frame, "nRound");
    let search = session.send("reverseContinue", json!({ "threadId": task }));
    assert_eq!(session.response(search)["success"], true, "the response does not wait for the search");
    let progress = session.event("progressStart");
    assert_eq!((&progress["requestId"], &progress["cancellable"]), (&json!(search), &json!(true)));
    session.ask("cancel", json!({ "progressId": progress["progressId"] }));
    session.event("progressEnd");
    assert_eq!(session.event("stopped")["text"], "the search was cancelled");
    let (_, _, frame) = session.frame(task);
    assert_eq!(session.evaluate(frame, "nRound"), rounds, "the run is where it was");
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
    assert!(reason.contains("--debug-port"), "{reason}");
    let reason = session.refused("launch", json!({ "program": application(), "debugPort": 0 }));
    assert!(reason.contains("debugPort"), "{reason}");
    assert!(session.refused("threads", json!({})).contains("launch"));
    assert!(session.refused("val3/unknown", json!({})).contains("unknown"));
    session.end();
}

#[test]
fn findings_are_coloured_for_clients_that_show_colours() {
    let folder = Folder::with("program start()\nbegin\n  nUnknown=1\nend\n");
    for styling in [false, true] {
        let mut session = Session::new();
        session.ask("initialize", json!({ "adapterID": "val3", "supportsANSIStyling": styling }));
        session.refused("launch", json!({ "program": folder.path() }));
        let shown = session.event("output")["output"].as_str().unwrap().to_owned();
        assert!(shown.contains("nUnknown") && shown.contains("\u{1b}[") == styling, "{shown}");
        session.end();
    }
}

#[test]
fn an_adapter_whose_client_disappears_ends() {
    let (mut session, task) = Session::launched(json!({}));
    session.ask("continue", json!({ "threadId": task }));
    session.assert_ended();
}

#[test]
fn an_application_without_stop_is_refused() {
    let folder = Folder::with("program start()\nbegin\n  ? \"hello\"\nend\n");
    let mut session = Session::new();
    session.ask("initialize", json!({ "adapterID": "val3" }));
    let refused = session.refused("launch", json!({ "program": folder.path().join("usrapp/main") }));
    assert!(refused.contains("the program `start` but no program `stop`"), "{refused}");
}
