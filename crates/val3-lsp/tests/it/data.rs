//! Data files as tables, and their edits.

use serde_json::{Value, json};

use crate::client::uri;
use crate::open_session::{Session, each};

const DATA: &str = "usrapp/main/main.dtx";

const CELL: &str = r#"
nA=nA+1
=== main/main.dtx
<?xml version="1.0" encoding="utf-8"?>
<Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
  <Datas>
    <Data name="nA" access="private" xsi:type="array" type="num" size="2">
      <Value key="0" value="wrong" />
    </Data>
    <Data name="pA" access="public" xsi:type="array" type="pointRx" size="1">
      <Value key="0" x="10" fatherId="world[0]" />
    </Data>
  </Datas>
</Database>
"#;

fn start(listing: &str) -> Session {
    let edits = json!({ "workspace": { "workspaceEdit": { "documentChanges": true } } });
    let mut session = Session::of(listing, edits);
    session.client.open(&session.cell.path(DATA), session.cell.text(DATA));
    session
}

fn ask(session: &mut Session, method: &str, mut params: Value) -> Value {
    params["uri"] = json!(uri(&session.cell.path(DATA)));
    session.client.ask(method, params)
}

#[test]
fn a_data_file_is_shown_as_tables() {
    let mut session = start(CELL);
    let tables = ask(&mut session, "val3/data", json!({}));
    assert_eq!((&tables["dialect"], &tables["problem"]), (&json!("new"), &Value::Null));
    assert_eq!(tables["version"], 1);
    let types = tables["types"].as_array().unwrap();
    let point = types.iter().find(|ty| ty["name"] == "pointRx").unwrap();
    let ids = ["x", "y", "z", "rx", "ry", "rz", "shoulder", "elbow", "wrist", "fatherId"];
    assert_eq!(each(&point["columns"], "id"), ids);
    let units: Vec<&Value> = point["columns"].as_array().unwrap().iter().map(|column| &column["unit"]).collect();
    assert_eq!((units[0], units[3], units[6]), (&json!("mm"), &json!("°"), &Value::Null));
    let father = &point["columns"][9];
    assert_eq!((&father["kind"], &father["choices"]), (&json!("father"), &json!(["world[0]"])));
    assert_eq!(point["columns"][7]["choices"][0], "esame");
    assert_eq!(point["containers"], json!(["array", "collection"]));
    assert_eq!(each(&tables["data"], "name"), ["nA", "pA"]);
    let number = &tables["data"][0];
    assert_eq!(
        (&number["access"], &number["container"], &number["size"]),
        (&json!("private"), &json!("array"), &json!([2]))
    );
    assert_eq!(number["range"]["start"], json!({ "line": 3, "character": 16 }));
    let expected = json!([{ "key": "0", "texts": ["10", null, null, null, null, null, null, null, null, "world[0]"] }]);
    assert_eq!(tables["data"][1]["values"], expected);
    let finding = &tables["findings"][0];
    assert_eq!((&finding["place"], &finding["column"]), (&json!({ "name": "nA", "key": "0" }), &json!("value")));
    assert_eq!((&finding["severity"], &finding["code"]), (&json!("error"), &json!("V0510")));
    assert_eq!(session.client.end(), 0);
}

#[test]
fn other_files_have_no_tables() {
    let mut session = start(CELL);
    let program = json!({ "uri": uri(&session.cell.path(crate::open_session::START)) });
    assert_eq!(session.client.ask("val3/data", program), Value::Null);
    assert_eq!(session.client.end(), 0);
}

/// Result after a change of the text.
fn after_change(session: &mut Session, text: &str, version: i64, params: Value) -> Value {
    session.client.change(&session.cell.path(DATA), version, text);
    ask(session, "val3/data", params)
}

#[test]
fn changes_are_sent_instead_of_the_tables() {
    let mut session = start(CELL);
    let text = session.cell.text(DATA).to_owned();
    let tables = ask(&mut session, "val3/data", json!({}));
    let unchanged = ask(&mut session, "val3/data", json!({ "previousResultId": tables["resultId"] }));
    assert_eq!(unchanged["data"], json!({ "start": 2, "deleteCount": 0, "items": [] }));
    assert_eq!((&unchanged["lineShift"], &unchanged["resultId"]), (&json!(0), &tables["resultId"]));
    assert_eq!(unchanged["findings"], json!({ "start": 1, "deleteCount": 0, "items": [] }));

    let changed = text.replace(" value=\"wrong\" />", "\n        value=\"5\" />");
    let params = json!({ "previousResultId": tables["resultId"], "withoutFindings": true });
    let changes = after_change(&mut session, &changed, 2, params);
    assert_eq!(
        (&changes["version"], &changes["problem"], &changes["findings"]),
        (&json!(2), &Value::Null, &Value::Null)
    );
    assert_eq!((&changes["data"]["start"], &changes["data"]["deleteCount"]), (&json!(0), &json!(2)));
    assert_eq!(changes["data"]["items"][0]["values"], json!([{ "key": "0", "texts": ["5"] }]));
    let params = json!({ "previousResultId": changes["resultId"] });
    let changes = ask(&mut session, "val3/data", params);
    assert_eq!(changes["data"]["items"], json!([]));
    assert_eq!(changes["findings"], json!({ "start": 0, "deleteCount": 1, "items": [] }));

    // A line before the data shifts them; an unknown result id, or another list of types, requires all data.
    let params = json!({ "previousResultId": changes["resultId"] });
    let moved = after_change(&mut session, &changed.replace("<Datas>", "\n<Datas>\n"), 3, params);
    assert_eq!((&moved["data"]["items"].as_array().unwrap().len(), &moved["lineShift"]), (&1, &json!(2)));
    let all = ask(&mut session, "val3/data", json!({ "previousResultId": "other" }));
    assert_eq!(each(&all["data"], "name"), ["nA", "pA"]);
    let params = json!({ "previousResultId": all["resultId"] });
    let renamed = changed.replace("pointRx", "unknown");
    let other_types = after_change(&mut session, &renamed, 4, params);
    assert_eq!(other_types["dialect"], "new");
    assert_eq!(session.client.end(), 0);
}

#[test]
fn changed_values_of_an_array_are_sent_alone() {
    let values: String = (0..100).map(|key| format!("<Value key=\"{key}\" value=\"{key}\" />\n")).collect();
    let cell = format!(
        "put(nMany[1])\n=== main/main.dtx\n<Database><Datas>\n<Data name=\"nMany\" access=\"private\" xsi:type=\"array\" type=\"num\" size=\"100\">\n{values}</Data>\n</Datas></Database>"
    );
    let mut session = start(&cell);
    let text = session.cell.text(DATA).to_owned();
    let tables = ask(&mut session, "val3/data", json!({}));
    let since = |result: &Value| json!({ "previousResultId": result["resultId"], "withoutFindings": true });
    let one = text.replace("value=\"50\"", "value=\"7\"");
    let changed = after_change(&mut session, &one, 2, since(&tables));
    assert_eq!(changed["values"], json!({ "start": 50, "deleteCount": 1 }));
    assert_eq!(changed["data"]["items"][0]["values"], json!([{ "key": "50", "texts": ["7"] }]));
    let without = one.replace("<Value key=\"51\" value=\"51\" />\n", "");
    let changed = after_change(&mut session, &without, 3, since(&changed));
    assert_eq!(changed["values"], json!({ "start": 51, "deleteCount": 1 }));
    assert_eq!(changed["data"]["items"][0]["values"], json!([]));
    let added = without.replace("<Value key=\"90\"", "<Value key=\"51\" />\n<Value key=\"90\"");
    let changed = after_change(&mut session, &added, 4, since(&changed));
    assert_eq!(changed["values"], json!({ "start": 89, "deleteCount": 0 }));
    assert_eq!(changed["data"]["items"][0]["values"], json!([{ "key": "51", "texts": [null] }]));
    // A different head requires all values.
    let public = added.replace("private", "public");
    let changed = after_change(&mut session, &public, 5, since(&changed));
    assert_eq!(changed["values"], Value::Null);
    assert_eq!(changed["data"]["items"][0]["values"].as_array().unwrap().len(), 100);
    assert_eq!(session.client.end(), 0);
}

#[test]
fn cells_are_set() {
    let mut session = start(CELL);
    let cell = json!({ "place": { "name": "nA", "key": "1" }, "column": "value", "text": "5" });
    let edits = json!({ "version": 1, "edits": [{ "kind": "set", "cells": [cell] }] });
    let answer = ask(&mut session, "val3/editData", edits);
    assert_eq!((&answer["refused"], &answer["findings"]), (&Value::Null, &json!([])));
    let edit = &answer["edit"]["documentChanges"][0]["edits"][0];
    assert_eq!(edit["newText"], "\n      <Value key=\"1\" value=\"5\" />");
    let end = json!({ "line": 4, "character": 37 });
    assert_eq!(edit["range"], json!({ "start": end, "end": end }));
    assert_eq!(session.client.end(), 0);
}

#[test]
fn every_kind_of_edit_is_understood() {
    let mut session = start(CELL);
    let place = json!({ "name": "dC" });
    let edits = json!({ "version": 1, "check": true, "edits": [
        { "kind": "add", "name": "dC", "type": "dio", "access": "private", "container": "collection", "size": [] },
        { "kind": "addKey", "place": place, "key": "a" },
        { "kind": "addKey", "place": place, "key": "b" },
        { "kind": "renameKey", "place": place, "key": "a", "as": "c" },
        { "kind": "removeKey", "place": place, "keys": ["b"] },
        { "kind": "duplicate", "name": "nA", "as": "nB" },
        { "kind": "delete", "names": ["pA"] },
        { "kind": "access", "names": ["nB"], "access": "public" },
        { "kind": "resize", "place": { "name": "nB" }, "size": [3] },
    ] });
    let answer = ask(&mut session, "val3/editData", edits);
    assert_eq!(answer["refused"], Value::Null);
    let edits = answer["edit"]["documentChanges"][0]["edits"].as_array().unwrap();
    let text: String = edits.iter().map(|edit| edit["newText"].as_str().unwrap()).collect();
    assert!(text.contains("<Value key=\"c\" />") && !text.contains("\"b\""), "{text}");
    assert!(text.contains("<Data name=\"nB\" access=\"public\" xsi:type=\"array\" type=\"num\" size=\"3\">"), "{text}");
    // The copy has the same fault as the original.
    assert_eq!(answer["findings"][0]["place"], json!({ "name": "nB", "key": "0" }), "{answer}");
    assert_eq!(session.client.end(), 0);
}

#[test]
fn impossible_edits_are_refused_in_words() {
    let mut session = start(CELL);
    let copy = json!({ "version": 1, "edits": [{ "kind": "duplicate", "name": "nA", "as": "pA" }] });
    let answer = ask(&mut session, "val3/editData", copy);
    assert_eq!((&answer["edit"], &answer["refused"]), (&Value::Null, &json!("there is already data called `pA`")));
    assert_eq!(session.client.end(), 0);
}

#[test]
fn edits_of_another_version_are_outdated() {
    let mut session = start(CELL);
    let params = json!({ "uri": uri(&session.cell.path(DATA)), "version": 7, "edits": [] });
    assert_eq!(session.client.ask_in_vain("val3/editData", params), -32801);
    assert_eq!(session.client.end(), 0);
}

#[test]
fn a_broken_file_is_shown_and_not_edited() {
    let mut session = start(&CELL.replace("  </Datas>\n", ""));
    let problem = json!("the file has a syntax error; correct it in the text first (line 3)");
    let tables = ask(&mut session, "val3/data", json!({}));
    assert_eq!(tables["problem"], problem);
    assert_eq!(each(&tables["data"], "name"), ["nA", "pA"]);
    let edits = json!({ "version": 1, "edits": [{ "kind": "delete", "names": ["nA"] }] });
    assert_eq!(ask(&mut session, "val3/editData", edits)["refused"], problem);
    assert_eq!(session.client.end(), 0);
}

#[test]
fn points_have_places() {
    let mut session =
        start(&format!("{CELL}=== /configs/arm.cfx\n<arm><String name=\"arm\" value=\"tx2_90-S1\"/></arm>\n"));
    let poses = ask(&mut session, "val3/dataPoses", json!({ "names": ["pA"] }));
    let pose = &poses[0];
    assert_eq!((&pose["name"], &pose["key"], &pose["chain"]), (&json!("pA"), &json!("0"), &json!("pA")));
    assert_eq!(pose["world"], json!([10.0, 0.0, 0.0, 0.0, 0.0, 0.0]));
    assert_eq!(pose["reach"], "outOfReach");
    assert!(pose["why"].as_str().unwrap().starts_with("TX2-90 with `flange`: "), "{pose}");
    assert_eq!(session.client.end(), 0);
}
