//! The filter *Contacts* of the debug adapter.

use serde_json::json;

use crate::dap_client::Session;
use crate::run_cell::folder_with_wall;

/// Launches the application with a rod that moves into a wall, with these filters.
fn launched(filters: &[&str]) -> (Session, i64) {
    let folder = folder_with_wall(150.0);
    let (mut session, task) = Session::launched(json!({ "program": folder.path(), "script": null }));
    let set = session.ask("setExceptionBreakpoints", json!({ "filters": filters }));
    assert!(set["breakpoints"].as_array().unwrap().iter().all(|filter| filter["verified"] == true), "{set}");
    session.ask("continue", json!({ "threadId": task }));
    (session, task)
}

#[test]
fn a_contact_stops_the_run_with_its_pair_and_move() {
    let (mut session, task) = launched(&["contacts"]);
    let texts: Vec<String> = (0..3)
        .map(|_| {
            let stop = session.event("stopped");
            assert_eq!((&stop["reason"], &stop["description"]), (&json!("exception"), &json!("Paused on contact")));
            session.ask("continue", json!({ "threadId": task }));
            stop["text"].as_str().unwrap().to_owned()
        })
        .collect();
    assert!(texts[0].contains("`wall`") && texts[0].contains(" in move 1 (movel, start() line 15)"), "{texts:?}");
    assert!(texts.iter().any(|text| text.contains("`rod` ")), "{texts:?}");
    assert_eq!(session.event("exited")["exitCode"], 1);
}

#[test]
fn going_back_stops_at_a_contact() {
    let (mut session, task) = launched(&["contacts"]);
    let first = session.event("stopped")["text"].clone();
    session.ask("continue", json!({ "threadId": task }));
    let second = session.event("stopped")["text"].clone();
    assert_ne!(first, second);
    session.ask("reverseContinue", json!({ "threadId": task }));
    assert_eq!(session.event("stopped")["text"], first);
    session.end();
}

#[test]
fn contacts_do_not_stop_a_run_without_the_filter() {
    let (mut session, _) = launched(&["unhandled", "assertion", "motion"]);
    assert_eq!(session.event("exited")["exitCode"], 1);
}
