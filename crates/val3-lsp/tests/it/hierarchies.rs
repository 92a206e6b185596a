//! Call and type hierarchies, links, and linked editing of names.

use serde_json::json;

use crate::cell::place;
use crate::client::{at, uri};
use crate::open_session::{START, Session, each, find};

const CELL: &str = "num nA\ncall other(nA)\ntaskCreate \"t\",10,other(1)\nlibrary part \"Disk://part/part.pjx\"\npart:libLoad(\"Disk://part/part.pjx\")\n\
    program other(num x_n)\nbegin\n  put(x_n)\nend\n\
    --- part\npublic num nWeight";

#[test]
fn calls_are_listed() {
    let mut session = Session::of(CELL, json!({}));
    let prepared = session.ask_at("textDocument/prepareCallHierarchy", "other(nA)");
    assert_eq!(each(&prepared, "name"), ["other"]);
    assert_eq!(prepared[0]["uri"], uri(&session.cell.path("usrapp/main/other.pgx")));
    let incoming = session.client.ask("callHierarchy/incomingCalls", json!({ "item": prepared[0] }));
    assert_eq!(incoming[0]["from"]["name"], "start");
    assert_eq!(incoming[0]["from"]["detail"], "main, in a task of its own");
    let (line, character) = place(session.cell.text(START), "other(nA)");
    assert_eq!(incoming[0]["fromRanges"][0]["start"], json!({ "line": line, "character": character }));
    assert_eq!(incoming[0]["fromRanges"].as_array().unwrap().len(), 2);
    let outgoing = session.client.ask("callHierarchy/outgoingCalls", json!({ "item": incoming[0]["from"] }));
    assert_eq!(outgoing[0]["to"]["name"], "other");
    assert_eq!(outgoing[0]["fromRanges"], incoming[0]["fromRanges"]);
    assert_eq!(session.client.end(), 0);
}

#[test]
fn types_are_listed() {
    let listing = "type Tray \"Disk://Tray/Tray.pjx\"\nTray tA\ntA.nX=1\n\
        --- Tray\ntype Slot \"Disk://Slot/Slot.pjx\"\npublic Slot sA\npublic num nX\n--- Slot\npublic num nY";
    let mut session = Session::of(listing, json!({}));
    let prepared = session.ask_at("textDocument/prepareTypeHierarchy", "tA.nX");
    assert_eq!(each(&prepared, "name"), ["Tray"]);
    let inner = session.client.ask("typeHierarchy/subtypes", json!({ "item": prepared[0] }));
    assert_eq!(each(&inner, "name"), ["Slot"]);
    let outer = session.client.ask("typeHierarchy/supertypes", json!({ "item": inner[0] }));
    assert_eq!(outer, prepared);
    assert_eq!(session.client.end(), 0);
}

#[test]
fn links_are_listed() {
    let mut session = Session::of(CELL, json!({}));
    let part = uri(&session.cell.path("usrapp/part/part.pjx"));
    assert_eq!(each(&session.ask("textDocument/documentLink"), "target"), [part.as_str()]);
    let manifest = json!({ "textDocument": { "uri": uri(&session.cell.path("usrapp/main/main.pjx")) } });
    let links = session.client.ask("textDocument/documentLink", manifest);
    find(&links, "target", &part);
    find(&links, "target", &uri(&session.cell.path(START)));
    assert_eq!(session.client.end(), 0);
}

#[test]
fn linked_names_are_edited_together() {
    let mut session = Session::of(CELL, json!({}));
    let together = session.ask_at("textDocument/linkedEditingRange", "Programs");
    let (line, character) = place(session.cell.text(START), "/Programs>");
    assert_eq!(together["ranges"][1]["start"], json!({ "line": line, "character": character + 1 }));
    assert!(session.ask_at("textDocument/linkedEditingRange", "other(nA)").is_null());
    assert_eq!(session.client.end(), 0);
}

#[test]
fn the_project_entry_of_a_program_declares_it() {
    let mut session = Session::of(CELL, json!({}));
    let entry = session.ask_at("textDocument/declaration", "other(nA)");
    assert!(entry[0]["uri"].as_str().unwrap().ends_with("/main.pjx"), "{entry}");
    assert_eq!(session.client.end(), 0);
}

#[test]
fn the_position_of_a_workspace_symbol_is_resolved_later() {
    let lazy = json!({ "workspace": { "symbol": { "resolveSupport": { "properties": ["location.range"] } } } });
    let mut session = Session::of(CELL, lazy);
    let found = session.client.ask("workspace/symbol", json!({ "query": "weight" }));
    assert_eq!(found[0]["location"], json!({ "uri": uri(&session.cell.path("usrapp/part/part.dtx")) }));
    let resolved = session.client.ask("workspaceSymbol/resolve", found[0].clone());
    let (line, character) = place(session.cell.text("usrapp/part/part.dtx"), "nWeight");
    assert_eq!(resolved["location"]["range"]["start"], json!({ "line": line, "character": character }));
    let nowhere = json!({ "item": { "name": "", "kind": 5, "uri": uri(&session.cell.path("none.pjx")),
        "range": { "start": { "line": 0, "character": 0 }, "end": { "line": 0, "character": 0 } },
        "selectionRange": { "start": { "line": 0, "character": 0 }, "end": { "line": 0, "character": 0 } } } });
    assert!(session.client.ask("typeHierarchy/subtypes", nowhere).is_null());
    let beyond = at(&session.cell.path(START), 9999, 0);
    session.client.ask("textDocument/prepareCallHierarchy", beyond);
    assert_eq!(session.client.end(), 0);
}
