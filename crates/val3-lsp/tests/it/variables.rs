//! Table of parameters and locals.

use serde_json::{Value, json};

use crate::client::uri;
use crate::open_session::{Session, each};

const CELL: &str = "program start()\nbegin\n  call other(1,2)\nend\n\
    program other(num x_nA,num& x_nB[])\n  num l_nSum[2,3]\nbegin\n  put(x_nA)\nend";

const OTHER: &str = "usrapp/main/other.pgx";

fn ask(session: &mut Session, program: &Value) -> Value {
    let params = json!({ "uri": uri(&session.cell.path(OTHER)), "program": program });
    session.client.ask("val3/variables", params)
}

fn parameter(from: Option<u64>, name: &str, argument: &str) -> Value {
    let shape = json!({ "type": "num", "container": "element", "dimensions": 1, "passing": "value" });
    let mut parameter = shape;
    parameter["from"] = json!(from);
    parameter["name"] = json!(name);
    parameter["argument"] = json!(argument);
    parameter
}

fn params(session: &Session, version: Option<i32>, parameters: &Value) -> Value {
    let uri = uri(&session.cell.path(OTHER));
    json!({ "uri": uri, "version": version, "program": "other", "edits": { "parameters": parameters } })
}

#[test]
fn variables_are_listed() {
    let mut session = Session::of(CELL, json!({}));
    let found = ask(&mut session, &Value::Null);
    assert_eq!((&found["program"], &found["version"], &found["fixed"]), (&json!("other"), &Value::Null, &Value::Null));
    assert_eq!(each(&found["parameters"], "name"), ["x_nA", "x_nB"]);
    assert_eq!(each(&found["parameters"], "container"), ["element", "array"]);
    assert_eq!(each(&found["parameters"], "passing"), ["value", "reference"]);
    let local = json!({
        "name": "l_nSum", "type": "num", "container": "array", "size": [2, 3], "uses": 0,
        "range": { "start": { "line": 8, "character": 19 }, "end": { "line": 8, "character": 25 } },
    });
    assert_eq!(found["locals"], json!([local]));
    assert!(found["types"].as_array().unwrap().contains(&json!("frame")), "{found}");
    assert_eq!(ask(&mut session, &json!("other"))["program"], "other");
    assert_eq!(ask(&mut session, &json!("else")), Value::Null);
    let start = json!({ "uri": uri(&session.cell.path("usrapp/main/start.pgx")) });
    let fixed = session.client.ask("val3/variables", start)["fixed"].clone();
    assert_eq!(fixed, "the controller itself calls `start`, without arguments");
    assert_eq!(session.client.end(), 0);
}

#[test]
fn callers_follow_new_parameters() {
    let mut session = Session::of(&CELL.replace("num& x_nB[]", "num x_nB"), json!({}));
    let wanted = json!([parameter(Some(1), "x_nB", ""), parameter(None, "x_nC", "3"), parameter(Some(0), "x_nA", "")]);
    let params = params(&session, None, &wanted);
    let answer = session.client.ask("val3/editVariables", params);
    assert_eq!(answer["refused"], Value::Null, "{answer}");
    let changes = &answer["edit"]["changes"];
    let texts = |file: &str| each(&changes[uri(&session.cell.path(file)).as_str()], "newText").concat();
    assert_eq!(texts("usrapp/main/start.pgx"), "2,31");
    assert!(texts(OTHER).contains("x_nC"), "{changes}");
    assert_eq!(session.client.end(), 0);
}

#[test]
fn refusals_have_a_reason() {
    let mut session = Session::of(&CELL.replace("num& x_nB[]", "num x_nB"), json!({}));
    let mut refused = |wanted: Value| refusal(&mut session, &wanted);
    let (first, second) = (parameter(Some(0), "x_nA", ""), parameter(Some(1), "x_nB", ""));
    assert_eq!(refused(json!([second])), "the parameter `x_nA` is used once in `other`");
    let double = refused(json!([first, second, parameter(None, "x_nA", "1")]));
    assert_eq!(double, "two variables of the program would be called `x_nA`");
    let unknown = refused(json!([first, second, parameter(None, "x_nC", "zUnknown")]));
    assert!(unknown.starts_with("it would add an error in `start.pgx`"), "{unknown}");
    assert_eq!(session.client.end(), 0);
}

/// Reason why the parameters cannot be changed.
fn refusal(session: &mut Session, parameters: &Value) -> String {
    let params = params(session, None, parameters);
    let answer = session.client.ask("val3/editVariables", params);
    assert_eq!(answer["edit"], Value::Null, "{answer}");
    answer["refused"].as_str().unwrap().to_owned()
}

#[test]
fn edits_of_an_older_version_are_refused() {
    let mut session = Session::of(CELL, json!({}));
    let path = session.cell.path(OTHER);
    session.client.open(&path, session.cell.text(OTHER));
    let version = ask(&mut session, &Value::Null)["version"].as_i64().unwrap();
    assert_eq!(version, 1);
    session.client.change(&path, 2, &session.cell.text(OTHER).replace("put(", "putln("));
    let params = params(&session, Some(1), &json!([]));
    assert_eq!(session.client.ask_in_vain("val3/editVariables", params), -32801);
    assert_eq!(session.client.end(), 0);
}
