//! `val3 dap` with a test: `setup`, the test and `teardown` are debugged one after the other.

use serde_json::{Value, json};

use crate::dap_client::Session;
use crate::support::Folder;
use crate::test_command::{cell, program};
use crate::test_tables::{ROW, squares};

/// Launches a test, with all exception filters that are on by default.
fn launched(folder: &Folder, options: Value) -> Session {
    let mut session = Session::new();
    let capabilities = session.ask("initialize", json!({ "adapterID": "val3" }));
    let filters = capabilities["exceptionBreakpointFilters"].as_array().unwrap();
    let filters: Vec<&Value> =
        filters.iter().filter(|filter| filter["default"] == true).map(|it| &it["filter"]).collect();
    assert!(filters.contains(&&json!("assertion")), "{capabilities}");
    let mut launch = json!({ "program": folder.path().join("usrapp/mainTest") });
    launch.as_object_mut().unwrap().extend(options.as_object().unwrap().clone());
    session.ask("launch", launch);
    session.event("initialized");
    session.ask("setExceptionBreakpoints", json!({ "filters": filters }));
    session
}

fn begin(session: &mut Session) {
    session.ask("configurationDone", json!({}));
}

fn break_at(session: &mut Session, folder: &Folder, program: &str, line: u32) {
    let source = json!({ "path": folder.path().join(format!("usrapp/mainTest/{program}.pgx")) });
    let set = session.ask("setBreakpoints", json!({ "source": source, "breakpoints": [{ "line": line }] }));
    assert_eq!(set["breakpoints"][0]["verified"], true, "{set}");
}

/// Names and lines of the stack frames, with `~` before subtle frames.
fn frames(session: &mut Session, task: i64) -> Vec<String> {
    let trace = session.ask("stackTrace", json!({ "threadId": task }));
    trace["stackFrames"].as_array().unwrap().iter().map(shown_frame).collect()
}

fn shown_frame(frame: &Value) -> String {
    let is_subtle = frame["presentationHint"] == "subtle" && frame["source"]["presentationHint"] == "deemphasize";
    format!("{}{} {}", if is_subtle { "~" } else { "" }, frame["name"].as_str().unwrap(), frame["line"])
}

#[test]
fn setup_the_test_and_teardown_are_debugged_with_the_script() {
    let programs = [("setup", "? \"setup\""), ("testKey", "? get()\n? \"after\""), ("teardown", "? \"teardown\"")];
    let folder = cell(&programs);
    folder.write("usrapp/mainTest/testKey.toml", "[[at]]\nt = 2\nkeys = \"A\"\n");
    let mut session = launched(&folder, json!({ "test": "testKey" }));
    for (program, line) in [("setup", 5), ("testKey", 6), ("teardown", 5)] {
        break_at(&mut session, &folder, program, line);
    }
    begin(&mut session);
    for expected in ["mainTest:setup() 5", "mainTest:testKey() 6", "mainTest:teardown() 5"] {
        let task = session.stopped("breakpoint");
        assert_eq!(frames(&mut session, task), [expected]);
        session.ask("continue", json!({ "threadId": task }));
    }
    let result = session.event("val3/testResult");
    assert_eq!((&result["name"], &result["passed"]), (&json!("mainTest:testKey"), &json!(true)), "{result}");
    assert_eq!(result["prints"], json!(["setup", "65", "after", "teardown"]));
    assert_eq!(session.event("exited")["exitCode"], 0);
    session.end();
}

#[test]
fn a_failed_assertion_stops_at_the_line_of_the_test() {
    let programs = [
        ("testSum", "call sum()\n? \"reached\""),
        ("sum", "call assert:equalNum(1+1,3,0.5)"),
        ("teardown", "? \"teardown\""),
    ];
    let folder = cell(&programs);
    let mut session = launched(&folder, json!({ "test": "mainTest:testSum" }));
    begin(&mut session);
    let stop = session.event("stopped");
    assert_eq!((&stop["reason"], &stop["text"]), (&json!("exception"), &json!("2 instead of 3")), "{stop}");
    assert_eq!(stop["description"], "Paused on failed assertion");
    let task = stop["threadId"].as_i64().unwrap();
    let frames = frames(&mut session, task);
    let behind: Vec<&String> = frames.iter().take_while(|frame| frame.starts_with('~')).collect();
    assert_eq!(behind.len(), 2, "{frames:?}");
    assert_eq!(&frames[2..], ["mainTest:sum() 5", "mainTest:testSum() 5"]);
    let info = session.ask("exceptionInfo", json!({ "threadId": task }));
    assert_eq!((&info["exceptionId"], &info["description"]), (&json!("failed assertion"), &json!("2 instead of 3")));
    session.ask("continue", json!({ "threadId": task }));
    let result = session.event("val3/testResult");
    assert_eq!(result["failure"]["message"], "2 instead of 3 (1 away, tolerance 0.5)", "{result}");
    assert_eq!(result["failure"]["places"][0]["line"], 5);
    assert_eq!(result["prints"], json!(["teardown"]), "the failure ends the test as without a debugger");
    assert_eq!(session.event("exited")["exitCode"], 1);
    session.end();
}

#[test]
fn one_row_of_a_table_is_debugged() {
    let folder = squares(ROW, "? x_nCase\n? nIn[x_nCase]");
    for (test, row) in [("testSum[2]", "2"), ("testSum", "0")] {
        let mut session = launched(&folder, json!({ "test": test }));
        begin(&mut session);
        let result = session.event("val3/testResult");
        assert_eq!(result["prints"][0], row, "{result}");
        session.end();
    }
}

/// Messages of a failure and its further failures.
fn messages(failure: &Value) -> Vec<String> {
    let others = failure["others"].as_array().into_iter().flatten();
    std::iter::once(failure).chain(others).filter_map(|it| it["message"].as_str().map(str::to_owned)).collect()
}

#[test]
fn expectations_are_judged_as_without_a_debugger() {
    let folder = cell(&[("testTwo", "? \"one\"\ndelay(1)\n? \"two\""), ("testError", "? sqrt(-1)")]);
    folder.write(
        "usrapp/mainTest/testTwo.toml",
        "[expect]\nprint = [\"one\", \"three\"]\n[[expect.at]]\nt = 0.5\nscreen = [\"x\"]\n\
         [[expect.within]]\nevent = { print = \"two\" }\nseconds = 0.5\n\
         [[expect.order]]\nevents = [{ print = \"two\" }, { print = \"one\" }]\n",
    );
    folder.write("usrapp/mainTest/testError.toml", "[expect]\nerrors = [{ code = 11 }]\n");
    let run = folder.val3(&["test", "usrapp/mainTest", "--format", "json"]);
    let tests = serde_json::from_str::<Value>(&run.stdout).unwrap()["tests"].clone();
    for (test, name, failures) in [(&tests[0], "testError", 0), (&tests[1], "testTwo", 4)] {
        assert_eq!(messages(&test["failure"]).len(), failures, "{test}");
        let mut session = launched(&folder, json!({ "test": name }));
        session.ask("setExceptionBreakpoints", json!({ "filters": [] }));
        break_at(&mut session, &folder, name, 5);
        begin(&mut session);
        let task = session.stopped("breakpoint");
        if name == "testTwo" {
            session.ask("next", json!({ "threadId": task }));
            session.stopped("step");
        }
        session.ask("continue", json!({ "threadId": task }));
        let result = session.event("val3/testResult");
        assert_eq!(messages(&result["failure"]), messages(&test["failure"]));
        for key in ["name", "passed", "prints", "seconds"] {
            assert_eq!(result[key], test[key], "{key}");
        }
        session.end();
    }
}

#[test]
fn debugged_tests_change_files_in_memory_alone() {
    let folder = cell(&[("testDelete", "libDelete(\"Disk://gone\")")]);
    folder.write("usrapp/gone/gone.pjx", "<Project />");
    for options in [json!({ "test": "testDelete" }), json!({ "test": "testDelete", "noDebug": true })] {
        let mut session = launched(&folder, options);
        begin(&mut session);
        assert_eq!(session.event("exited")["exitCode"], 0);
        session.end();
        assert_eq!(folder.read("usrapp/gone/gone.pjx"), "<Project />");
    }
}

#[test]
fn without_the_filter_assertions_do_not_stop() {
    let folder = cell(&[("testSum", "call assert:fail(\"no\")")]);
    let mut session = launched(&folder, json!({ "test": "testSum" }));
    session.ask("setExceptionBreakpoints", json!({ "filters": [] }));
    begin(&mut session);
    assert_eq!(session.event("exited")["exitCode"], 1);
    session.end();
}

#[test]
fn a_test_goes_back_and_begins_again() {
    let folder = cell(&[("setup", "? \"setup\""), ("testTwo", "? 1\n? 2"), ("teardown", "")]);
    let mut session = launched(&folder, json!({ "test": "testTwo" }));
    break_at(&mut session, &folder, "testTwo", 6);
    begin(&mut session);
    let task = session.stopped("breakpoint");
    session.ask("stepBack", json!({ "threadId": task }));
    let task = session.stopped("entry");
    assert_eq!(frames(&mut session, task), ["mainTest:testTwo() 5"], "the past begins with the test");
    session.ask("continue", json!({ "threadId": task }));
    let task = session.stopped("breakpoint");
    session.ask("restart", json!({}));
    let again = session.stopped("breakpoint");
    assert_eq!(frames(&mut session, again), ["mainTest:testTwo() 6"]);
    session.ask("continue", json!({ "threadId": task }));
    assert_eq!(session.event("val3/testResult")["passed"], true);
    session.end();
}

#[test]
fn tests_that_cannot_be_debugged_are_refused() {
    let folder = cell(&[("testSum", "")]);
    let unknown = launch_error(&folder, &json!({ "test": "testSun" }));
    assert!(unknown.contains("has no test `testSun`") && unknown.contains("`mainTest:testSum`"), "{unknown}");
    assert!(launch_error(&folder, &json!({ "test": "testSum", "script": "x.toml" })).contains("`script` is for runs"));
    folder.write("usrapp/mainTest/start.pgx", "");
    folder.write("usrapp/mainTest/testSum.pgx", &program("testSum", "nUnknown=1"));
    assert!(launch_error(&folder, &json!({ "test": "testSum" })).contains("the compiler rejects the application"));
}

/// Reason why `launch` fails with these options.
fn launch_error(folder: &Folder, options: &Value) -> String {
    let mut session = Session::new();
    session.ask("initialize", json!({ "adapterID": "val3" }));
    let mut launch = json!({ "program": folder.path().join("usrapp/mainTest") });
    launch.as_object_mut().unwrap().extend(options.as_object().unwrap().clone());
    let reason = session.refused("launch", launch);
    session.end();
    reason
}
