//! Code lenses and inlay hints.

use serde_json::{Value, json};

use crate::cell::place;
use crate::client::uri;
use crate::open_session::{START, Session, each};

const CELL: &str = "point pA\ntool tA\nmdesc mA\nnum nA\nnA=power(2,3)\nmovej(pA,tA,mA)\ncall other(7)\n\
    program other(num x_n)\nbegin\n  nA=x_n\nend";

const OTHER: &str = "usrapp/main/other.pgx";

#[test]
fn programs_have_lenses_above_them() {
    let commands = json!({ "commands": ["val3.run", "val3.debug", "val3.showReferences"] });
    let mut session = Session::with(CELL, json!({}), commands);
    let lenses = session.ask("textDocument/codeLens");
    let titles: Vec<&Value> = lenses.as_array().unwrap().iter().map(|lens| &lens["command"]["title"]).collect();
    assert_eq!(titles, [&json!("Run"), &json!("Debug"), &Value::Null]);
    assert_eq!(lenses[0]["command"]["command"], "val3.run");
    assert_eq!(lenses[0]["command"]["arguments"], json!([uri(&session.cell.path("usrapp/main/main.pjx")), "start"]));
    let params = json!({ "textDocument": { "uri": uri(&session.cell.path(OTHER)) } });
    let of_other = session.client.ask("textDocument/codeLens", params);
    let resolved = session.client.ask("codeLens/resolve", of_other[0].clone());
    assert_eq!(resolved["command"]["title"], "1 reference");
    assert_eq!(resolved["command"]["command"], "val3.showReferences");
    let places = &resolved["command"]["arguments"][2];
    assert_eq!(each(places, "uri"), [uri(&session.cell.path(START))]);
    // The same number as the references without the declaration and its element in the project file.
    let mut params = session.place("other");
    params["context"] = json!({ "includeDeclaration": false });
    assert_eq!(&session.client.ask("textDocument/references", params), places);
    let unused = session.client.ask("codeLens/resolve", lenses[2].clone());
    assert_eq!(unused["command"], json!({ "title": "0 references", "command": "" }));
    session.client.change(&session.cell.path(START), 2, "");
    assert_eq!(session.client.ask_in_vain("codeLens/resolve", lenses[2].clone()), -32801);
    assert_eq!(session.client.end(), 0);
}

#[test]
fn clients_without_commands_get_lenses_without_commands() {
    let mut session = Session::of(CELL, json!({}));
    let lenses = session.ask("textDocument/codeLens");
    assert_eq!(lenses.as_array().unwrap().len(), 1, "{lenses}");
    let params = json!({ "textDocument": { "uri": uri(&session.cell.path(OTHER)) } });
    let of_other = session.client.ask("textDocument/codeLens", params);
    let resolved = session.client.ask("codeLens/resolve", of_other[0].clone());
    assert_eq!(resolved["command"], json!({ "title": "1 reference", "command": "" }));
    assert_eq!(session.client.end(), 0);
}

#[test]
fn settings_choose_the_counted_references() {
    let mut session = Session::of(CELL, json!({ "workspace": { "codeLens": { "refreshSupport": true } } }));
    let counts = |session: &mut Session| {
        ["usrapp/main/main.dtx", OTHER].map(|path| {
            let params = json!({ "textDocument": { "uri": uri(&session.cell.path(path)) } });
            session.client.ask("textDocument/codeLens", params).as_array().unwrap().len()
        })
    };
    assert_eq!(counts(&mut session), [0, 1]);
    let settings = json!({ "val3": { "codeLens": { "dataReferences": true, "programReferences": false } } });
    session.client.notify("workspace/didChangeConfiguration", json!({ "settings": settings }));
    session.client.told("workspace/codeLens/refresh");
    assert_eq!(counts(&mut session), [4, 0]);
    assert_eq!(session.client.end(), 0);
}

fn hints(session: &mut Session) -> Vec<String> {
    each(&raw_hints(session), "label").into_iter().map(str::to_owned).collect()
}

fn raw_hints(session: &mut Session) -> Value {
    let everything = json!({ "start": { "line": 0, "character": 0 }, "end": { "line": 999, "character": 0 } });
    let params = json!({ "textDocument": { "uri": uri(&session.cell.path(START)) }, "range": everything });
    session.client.ask("textDocument/inlayHint", params)
}

#[test]
fn a_hint_leads_to_the_declaration() {
    let resolves = json!({ "resolveSupport": { "properties": ["tooltip", "label.location"] } });
    let mut session = Session::of(CELL, json!({ "textDocument": { "inlayHint": resolves } }));
    let hints = raw_hints(&mut session);
    let own = resolved(&mut session, &hints, "x_n:");
    let foreign = resolved(&mut session, &hints, "nX:");
    let location = &own["label"][0]["location"];
    assert_eq!(location["uri"], uri(&session.cell.path(OTHER)));
    let (line, column) = place(session.cell.text(OTHER), "x_n");
    assert_eq!(location["range"]["start"], json!({ "line": line, "character": column }));
    assert_eq!(foreign["label"][0]["location"], Value::Null, "instructions have no file");
    assert_eq!(session.client.end(), 0);
}

/// Resolves the hint with this label, whose location is computed on request.
fn resolved(session: &mut Session, hints: &Value, label: &str) -> Value {
    let hint = hints.as_array().unwrap().iter().find(|hint| hint["label"][0]["value"] == label).unwrap();
    assert_eq!(hint["label"][0]["location"], Value::Null);
    session.client.ask("inlayHint/resolve", hint.clone())
}

#[test]
fn inlay_hints_are_returned() {
    let abilities = json!({ "workspace": { "inlayHint": { "refreshSupport": true } } });
    let mut session = Session::of(CELL, abilities);
    let before = hints(&mut session);
    for label in ["nX:", "nY:", "x_n:", "in world[0]"] {
        assert!(before.iter().any(|found| found == label), "{label}: {before:?}");
    }
    let settings = json!({ "val3": { "inlayHints": { "parameterNames": false } } });
    session.client.notify("workspace/didChangeConfiguration", json!({ "settings": settings }));
    session.client.told("workspace/inlayHint/refresh");
    let after = hints(&mut session);
    assert_eq!(after, before.into_iter().filter(|label| !label.ends_with(':')).collect::<Vec<_>>());
    assert_eq!(session.client.end(), 0);
}

#[test]
fn edits_of_other_files_refresh_the_hints() {
    let abilities = json!({ "workspace": { "inlayHint": { "refreshSupport": true } } });
    let mut session = Session::of(CELL, abilities);
    assert!(hints(&mut session).iter().any(|label| label == "x_n:"));
    let (path, text) = (session.cell.path(OTHER), session.cell.text(OTHER).to_owned());
    session.client.open(&path, &text);
    session.client.change(&path, 2, &text.replace("nA=x_n", "nA=x_n+1"));
    assert_eq!(session.client.try_told("workspace/inlayHint/refresh"), None, "no hint tells of this");
    session.client.change(&path, 3, &text.replace("x_n", "x_nTimes"));
    session.client.told("workspace/inlayHint/refresh");
    assert_eq!(session.client.try_told("workspace/inlayHint/refresh"), None, "once is enough");
    assert!(hints(&mut session).iter().any(|label| label == "x_nTimes:"));
    assert_eq!(session.client.end(), 0);
}

#[test]
fn edits_of_other_files_refresh_the_counts() {
    let abilities = json!({ "workspace": { "codeLens": { "refreshSupport": true } } });
    let mut session = Session::of(CELL, abilities);
    let other = session.cell.path(OTHER);
    session.client.open(&other, session.cell.text(OTHER));
    let params = json!({ "textDocument": { "uri": uri(&other) } });
    let lenses = session.client.ask("textDocument/codeLens", params);
    session.client.ask("codeLens/resolve", lenses[0].clone());
    let (path, text) = (session.cell.path(START), session.cell.text(START).to_owned());
    session.client.change(&path, 2, &text.replace("power(2,3)", "power(2,4)"));
    assert_eq!(session.client.try_told("workspace/codeLens/refresh"), None, "the uses are as many as before");
    session.client.change(&path, 3, &text.replace("call other(7)", "call other(7)\n  call other(8)"));
    session.client.told("workspace/codeLens/refresh");
    let resolved = session.client.ask("codeLens/resolve", lenses[0].clone());
    assert_eq!(resolved["command"]["title"], "2 references");
    // A client requests the lenses of a document that it has edited itself.
    session.client.change(&other, 2, session.cell.text(OTHER));
    assert_eq!(session.client.try_told("workspace/codeLens/refresh"), None);
    assert_eq!(session.client.end(), 0);
}
