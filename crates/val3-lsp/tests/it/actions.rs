//! Code actions: offers, edits, and differences between clients.

use serde_json::{Value, json};

use crate::cell::Cell;
use crate::client::{Client, uri};
use crate::open_session::{START, Session, each, find};

const CELL: &str = "num nCount\nIF nCount==1\nnCuont=2\nENDIF\nnNew=3\ncall missing(nCount)";

/// Capabilities for an editor that supports everything.
fn able() -> Value {
    let action = json!({
        "codeActionLiteralSupport": { "codeActionKind": { "valueSet": [] } },
        "dataSupport": true,
        "resolveSupport": { "properties": ["edit"] },
    });
    let edit = json!({ "documentChanges": true, "resourceOperations": ["create", "rename", "delete"] });
    json!({ "textDocument": { "codeAction": action }, "workspace": { "workspaceEdit": edit, "applyEdit": true } })
}

/// Capabilities for an editor that supports only code actions and text edits.
fn modest() -> Value {
    let action = json!({ "codeActionLiteralSupport": { "codeActionKind": { "valueSet": [] } } });
    json!({ "textDocument": { "codeAction": action } })
}

#[test]
fn fixes_of_findings_are_offered() {
    let mut session = Session::of(CELL, able());
    let fixes = session.actions_at("nCuont", json!(["quickfix"]));
    let fix = find(&fixes, "title", "Write `nCount`");
    assert_eq!((&fix["kind"], &fix["isPreferred"]), (&json!("quickfix"), &Value::Null));
    assert_eq!(fix["diagnostics"][0]["code"], "V0101");
    let change = &fix["edit"]["documentChanges"][0];
    assert_eq!(change["textDocument"], json!({ "uri": uri(&session.cell.path(START)), "version": 1 }));
    assert_eq!(change["edits"][0]["newText"], "nCount");
    let safe = session.actions_at("IF nCount", json!(["quickfix"]));
    assert_eq!(find(&safe, "title", "Write `if`")["isPreferred"], true);
    let all = session.actions_at("nCuont", json!(["source.fixAll"]));
    assert_eq!(each(&all, "kind"), ["source.fixAll"]);
    let texts = each(&all[0]["edit"]["documentChanges"][0]["edits"], "newText");
    assert_eq!(texts, ["if", "endIf"]);
    // If other actions are offered too, the edit is computed only after the action is chosen.
    let among = find(&session.actions_at("nCuont", Value::Null), "kind", "source.fixAll");
    assert_eq!(among["edit"], Value::Null);
    assert_eq!(session.client.ask("codeAction/resolve", among)["edit"], all[0]["edit"]);
    assert_eq!(session.actions_at("missing", json!(["source.fixAll.other"])), json!([]));
    assert_eq!(session.client.end(), 0);
}

#[test]
fn only_requested_kinds_are_offered() {
    let mut session = Session::of(CELL, able());
    let every = session.actions_at("nNew", Value::Null);
    for (asked, rest) in [("refactor", false), ("refactor.extract", false), ("source", true), ("quickfix", true)] {
        let found = session.actions_at("nNew", json!([asked]));
        let covered = |kind: &&str| **kind == *asked || kind.starts_with(&format!("{asked}."));
        let wanted: Vec<&str> = each(&every, "kind").into_iter().filter(covered).collect();
        assert_eq!(each(&found, "kind"), wanted, "{asked}");
        assert_eq!(!wanted.is_empty(), rest, "{asked}: {every}");
    }
    assert_eq!(session.actions_at("nNew", json!(["ref"])), json!([]));
    assert_eq!(session.client.end(), 0);
}

#[test]
fn the_edit_is_computed_when_an_action_is_chosen() {
    let mut session = Session::of(CELL, able());
    let offered = session.actions_at("missing", Value::Null);
    let create = find(&offered, "title", "Create program `missing`");
    assert_eq!(create["edit"], Value::Null);
    let resolved = session.client.ask("codeAction/resolve", create.clone());
    let changes = resolved["edit"]["documentChanges"].as_array().unwrap();
    let path = uri(&session.cell.path("usrapp/main/missing.pgx"));
    assert_eq!((&changes[0]["kind"], &changes[0]["uri"]), (&json!("create"), &json!(path)));
    assert_eq!(changes[1]["textDocument"], json!({ "uri": path, "version": null }));
    assert!(changes[1]["edits"][0]["newText"].as_str().unwrap().contains("<Program name=\"missing\""));
    assert!(changes[2]["textDocument"]["uri"].as_str().unwrap().ends_with("/main.pjx"));
    // After an edit, the range is no longer valid.
    session.client.change(&session.cell.path(START), 2, "");
    assert_eq!(session.client.ask_in_vain("codeAction/resolve", create), -32801);
    assert_eq!(session.client.end(), 0);
}

#[test]
fn a_name_that_was_made_up_can_be_replaced_at_once() {
    const CELL: &str = "num nCount\nnCount=nCount*2";
    let mut session = Session::with(CELL, able(), json!({ "commands": ["val3.rename"] }));
    let resolved = extracted(&mut session);
    let [path, range] = resolved["command"]["arguments"].as_array().unwrap().as_slice() else { panic!("{resolved}") };
    assert_eq!(resolved["command"]["command"], "val3.rename");
    assert_eq!(path, &uri(&session.cell.path(START)));
    // The declaration is inserted before the code, so the name is below the original expression.
    let edits = resolved["edit"]["documentChanges"][0]["edits"].as_array().unwrap();
    let declaration = edits[0]["newText"].as_str().unwrap();
    assert!(declaration.contains("l_nValue"), "{resolved}");
    let added = declaration.matches('\n').count() as u64;
    let at = &edits[1]["range"]["start"];
    assert_eq!(range["start"]["line"].as_u64(), at["line"].as_u64().map(|line| line + added));
    assert_eq!(range["start"]["character"], at["character"]);
    assert_eq!(session.client.end(), 0);
    let mut session = Session::of(CELL, able());
    assert_eq!(extracted(&mut session)["command"], Value::Null);
    assert_eq!(session.client.end(), 0);
}

/// Resolved action that extracts `nCount*2` into a local.
fn extracted(session: &mut Session) -> Value {
    let mut place = session.place("nCount*2");
    let start = place["position"].take();
    let end = json!({ "line": start["line"], "character": start["character"].as_u64().unwrap() + 8 });
    place["range"] = json!({ "start": start, "end": end });
    place["context"] = json!({ "diagnostics": [], "only": ["refactor.extract"] });
    let offered = session.client.ask("textDocument/codeAction", place);
    let extract = find(&offered, "title", "Extract into a local variable");
    session.client.ask("codeAction/resolve", extract)
}

#[test]
fn the_condition_of_a_new_block_is_selected() {
    let mut session = Session::with("num nCount\nnCount=1", able(), json!({ "commands": ["val3.select"] }));
    let mut place = session.place("nCount=1");
    let start = place["position"].take();
    let end = json!({ "line": start["line"], "character": start["character"].as_u64().unwrap() + 8 });
    place["range"] = json!({ "start": start, "end": end });
    place["context"] = json!({ "diagnostics": [], "only": ["refactor.rewrite"] });
    let offered = session.client.ask("textDocument/codeAction", place);
    let surround = find(&offered, "title", "Surround with `if`");
    let command = session.client.ask("codeAction/resolve", surround)["command"].take();
    assert_eq!(command["command"], "val3.select");
    let range = &command["arguments"][1];
    let columns = ["start", "end"].map(|end| range[end]["character"].as_u64().unwrap());
    let first = start["character"].as_u64().unwrap();
    assert_eq!((&range["start"]["line"], columns), (&start["line"], [first + 3, first + 7]));
    assert_eq!(session.client.end(), 0);
}

#[test]
fn harmful_actions_are_disabled_with_a_reason() {
    const CELL: &str = "call other()\nprogram other()\nbegin\n  x_nOut=1\nend";
    const OTHER: &str = "usrapp/main/other.pgx";
    const TITLE: &str = "Create parameter `num x_nOut`";
    let mut session = Session::of(CELL, showing_disabled());
    let found = titled(&session.actions_in(OTHER, "x_nOut", Value::Null), TITLE).unwrap();
    assert_eq!(found["disabled"]["reason"], "the caller `start` has no value to pass");
    assert_eq!((&found["edit"], &found["data"]), (&Value::Null, &Value::Null));
    assert_eq!(session.client.end(), 0);
    let mut session = Session::of(CELL, able());
    assert_eq!(titled(&session.actions_in(OTHER, "x_nOut", Value::Null), TITLE), None);
    assert_eq!(session.client.end(), 0);
}

/// Abilities of a client that shows disabled actions with their reason.
fn showing_disabled() -> Value {
    let mut abilities = able();
    abilities["textDocument"]["codeAction"]["disabledSupport"] = json!(true);
    abilities
}

/// Offered action with this title.
fn titled(offered: &Value, title: &str) -> Option<Value> {
    offered.as_array().unwrap().iter().find(|action| action["title"] == title).cloned()
}

#[test]
fn clients_with_few_abilities_get_fewer_actions() {
    let mut session = Session::of(CELL, modest());
    let offered = session.actions_at("missing", Value::Null);
    assert!(!each(&offered, "title").contains(&"Create program `missing`"), "{offered}");
    let local = find(&session.actions_at("nNew", Value::Null), "kind", "quickfix");
    let changes = local["edit"]["changes"].as_object().unwrap();
    assert_eq!(changes.len(), 1, "{local}");
    assert_eq!(session.client.end(), 0);
    let mut session = Session::of(CELL, json!({}));
    assert_eq!(session.actions_at("nCuont", Value::Null), json!([]));
    assert_eq!(session.client.end(), 0);
}

#[test]
fn clients_that_only_know_commands_get_commands() {
    let mut session = Session::of(CELL, json!({ "workspace": { "applyEdit": true } }));
    let command = find(&session.actions_at("nCuont", Value::Null), "title", "Write `nCount`");
    let params = json!({ "command": command["command"], "arguments": command["arguments"] });
    assert_eq!(session.client.ask("workspace/executeCommand", params), Value::Null);
    let asked = session.client.told("workspace/applyEdit");
    let changes = asked["params"]["edit"]["changes"].as_object().unwrap();
    assert_eq!(changes[&uri(&session.cell.path(START))][0]["newText"], "nCount");
    session.client.send(&json!({ "jsonrpc": "2.0", "id": asked["id"], "result": { "applied": true } }));
    let wrong = json!({ "command": "val3.applyEdit", "arguments": [3] });
    assert_eq!(session.client.ask_in_vain("workspace/executeCommand", wrong), -32803);
    assert_eq!(session.client.end(), 0);
}

#[test]
fn actions_that_need_a_project_are_not_offered_without_one() {
    let folder = tempfile::tempdir().unwrap();
    let loose = folder.path().canonicalize().unwrap().join("loose.pgx").to_str().unwrap().to_owned();
    let mut session = Session::of(CELL, able());
    session.client.open(&loose, session.cell.text(START));
    let mut params = session.place("missing");
    let place = params["position"].take();
    params["textDocument"]["uri"] = json!(uri(&loose));
    params["range"] = json!({ "start": place, "end": place });
    params["context"] = json!({ "diagnostics": [] });
    let offered = session.client.ask("textDocument/codeAction", params);
    assert!(!offered.to_string().contains("loose.pjx"), "{offered}");
    assert!(!each(&offered, "title").contains(&"Create program `missing`"), "{offered}");
    assert_eq!(session.client.end(), 0);
}

const PROJECT: &str = "usrapp/main/main.pjx";
const STRAY: &str = "usrapp/main/stray.pgx";

/// Program `stray` with this line, in a file that no project lists.
fn stray(line: &str) -> String {
    format!(
        "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<Programs xmlns=\"http://www.staubli.com/robotics/VAL3/Program/2\">\n  \
         <Program name=\"stray\">\n    <Code><![CDATA[begin\n{line}\nend]]></Code>\n  </Program>\n</Programs>\n"
    )
}

#[test]
fn a_fix_that_would_add_an_error_is_disabled() {
    let mut shows_disabled = with_stray(showing_disabled(), "nMissing=1");
    let fix = listing_fix(&mut shows_disabled).unwrap();
    let reason = fix["disabled"]["reason"].as_str().unwrap();
    assert!(reason.starts_with("it would add an error in `stray.pgx`: ") && reason.contains("`nMissing`"), "{reason}");
    assert_eq!((&fix["edit"], &fix["isPreferred"]), (&Value::Null, &Value::Null));
    assert_eq!(shows_disabled.client.end(), 0);
    let mut hides_disabled = with_stray(able(), "nMissing=1");
    assert_eq!(listing_fix(&mut hides_disabled), None);
    assert_eq!(hides_disabled.client.end(), 0);
    let mut harmless = with_stray(able(), "nA=2");
    assert!(listing_fix(&mut harmless).unwrap()["edit"].is_object());
    assert_eq!(harmless.client.end(), 0);
}

/// Session with a program file of this code that the project does not list.
fn with_stray(abilities: Value, line: &str) -> Session {
    let cell = Cell::new("num nA\nnA=1\nput(nA)");
    cell.write(STRAY, &stray(line));
    let mut client = Client::start_with(&[&cell.folder()], abilities, Value::Null);
    client.open(&cell.path(PROJECT), cell.text(PROJECT));
    Session { cell, client }
}

fn listing_fix(session: &mut Session) -> Option<Value> {
    titled(&session.actions_in(PROJECT, "Programs>", json!(["quickfix"])), "List `stray.pgx`")
}

#[test]
fn a_fix_that_would_add_an_error_in_another_application_is_disabled() {
    assert_eq!(reason_against_renaming("weigh"), None);
    let reason = reason_against_renaming("wiegh").unwrap();
    assert!(reason.starts_with("it would add an error in `") && reason.contains("`wiegh`"), "{reason}");
}

/// Reason why a fix that renames the program in the file of `weigh` is disabled, if an application calls `called`.
fn reason_against_renaming(called: &str) -> Option<String> {
    const LIBRARY: &str = "usrapp/part/weigh.pgx";
    let cell = Cell::new(&format!(
        "library part \"Disk://part/part.pjx\"\ncall part:{called}()\n--- part\npublic program weigh()\nbegin\nend"
    ));
    let mut client = Client::start_with(&[&cell.folder()], showing_disabled(), Value::Null);
    client.open(&cell.path(LIBRARY), &cell.text(LIBRARY).replace("name=\"weigh\"", "name=\"wiegh\""));
    let mut session = Session { cell, client };
    let offered = session.actions_in(LIBRARY, "weigh\"", json!(["quickfix"]));
    assert_eq!(session.client.end(), 0);
    find(&offered, "title", "Write `weigh`")["disabled"]["reason"].as_str().map(str::to_owned)
}
