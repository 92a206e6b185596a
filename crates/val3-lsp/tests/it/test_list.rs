//! Tests of the workspace.

use serde_json::{Value, json};

use crate::client::uri;
use crate::open_session::{Session, each};

const CELL: &str = "nA=1\nnum nA\n--- mainTest\nprogram testSum()\nbegin\nend\nprogram setup()\nbegin\nend\n\
    program testAll()\nbegin\nend";

const MANIFEST: &str = "usrapp/mainTest/mainTest.pjx";

fn lenses(session: &mut Session, file: &str) -> Vec<Value> {
    let params = json!({ "textDocument": { "uri": uri(&session.cell.path(file)) } });
    let lenses = session.client.ask("textDocument/codeLens", params);
    lenses.as_array().unwrap().iter().map(|lens| lens["command"].clone()).filter(|it| !it.is_null()).collect()
}

#[test]
fn tests_have_lenses_of_their_own() {
    let commands = json!({ "commands": ["val3.run", "val3.debug", "val3.runTest", "val3.debugTest"] });
    let mut session = Session::with(CELL, json!({}), commands);
    let found = lenses(&mut session, "usrapp/mainTest/testSum.pgx");
    let arguments = json!([uri(&session.cell.path(MANIFEST)), "testSum"]);
    let expected = json!([
        { "title": "Run test", "command": "val3.runTest", "arguments": arguments },
        { "title": "Debug test", "command": "val3.debugTest", "arguments": arguments },
    ]);
    assert_eq!(json!(found), expected);
    let others = json!(lenses(&mut session, "usrapp/mainTest/setup.pgx"));
    assert_eq!(each(&others, "title"), ["Run", "Debug"]);
    assert_eq!(session.client.end(), 0);
}

#[test]
fn clients_that_cannot_execute_tests_run_them_as_programs() {
    let mut session = Session::with(CELL, json!({}), json!({ "commands": ["val3.run", "val3.debug"] }));
    let found = json!(lenses(&mut session, "usrapp/mainTest/testSum.pgx"));
    assert_eq!(each(&found, "title"), ["Run", "Debug"]);
    assert_eq!(session.client.end(), 0);
    let mut session = Session::of(CELL, json!({}));
    assert!(lenses(&mut session, "usrapp/mainTest/testSum.pgx").is_empty());
    assert_eq!(session.client.end(), 0);
}

#[test]
fn a_command_lists_the_tests_and_how_to_execute_them() {
    let mut session = Session::of(CELL, json!({}));
    let all = listed(&mut session, json!([]));
    assert_eq!(each(&all, "name"), ["mainTest:testAll", "mainTest:testSum"]);
    let file = session.cell.path("usrapp/mainTest/testSum.pgx");
    let folder = session.cell.path("usrapp/mainTest");
    let start = json!({ "line": 2, "character": 17 });
    let end = json!({ "line": 2, "character": 24 });
    let test = json!({
        "name": "mainTest:testSum",
        "application": "mainTest",
        "program": "testSum",
        "manifest": uri(&format!("{folder}/mainTest.pjx")),
        "location": { "uri": uri(&file), "range": { "start": start, "end": end } },
        "command": ["val3", "test", folder, "--exact", "mainTest:testSum"],
    });
    assert_eq!(listed(&mut session, json!([uri(&file)])), json!([test]));
    assert_eq!(listed(&mut session, json!([uri(&format!("{folder}/setup.pgx"))])), json!([]));
    let wrong = json!({ "command": "val3.tests", "arguments": [1] });
    assert_eq!(session.client.ask_in_vain("workspace/executeCommand", wrong), -32803);
    assert_eq!(session.client.end(), 0);
}

fn listed(session: &mut Session, arguments: Value) -> Value {
    let params = json!({ "command": "val3.tests", "arguments": arguments });
    session.client.ask("workspace/executeCommand", params)
}
