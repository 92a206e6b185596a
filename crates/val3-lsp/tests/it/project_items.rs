//! Libraries and types that are added to a project, and items that are deleted from it.

use serde_json::{Value, json};

use crate::client::uri;
use crate::open_session::{Session, find};

const CELL: &str = "num nA\nnum nB\nprogram start()\nbegin\n  nA=1\n  call other()\nend\n\
    program other()\nbegin\nend\n--- part\npublic num nWeight\npublic program weigh()\nbegin\nend";

const MANIFEST: &str = "usrapp/main/main.pjx";

fn session(operations: &[&str]) -> Session {
    let edit = json!({ "documentChanges": true, "resourceOperations": operations });
    Session::of(CELL, json!({ "workspace": { "workspaceEdit": edit } }))
}

fn end(session: Session) {
    assert_eq!(session.client.end(), 0);
}

#[test]
fn what_the_cell_has_can_be_added() {
    let mut session = session(&[]);
    let manifest = uri(&session.cell.path(MANIFEST));
    let list = session.client.ask("val3/libraries", json!({ "uri": manifest }));
    assert_eq!(list["hasTypes"], true);
    let part = json!({
        "uri": uri(&session.cell.path("usrapp/part/part.pjx")), "kind": "library", "name": "part",
        "path": "Disk://part/part.pjx", "libraries": [], "types": [], "publicPrograms": 1, "publicData": 1,
        "fits": [], "libraryCircle": false, "typeCircle": false,
    });
    assert_eq!(list["candidates"], json!([part]));
    let mut params = json!({ "uri": manifest, "kind": "type", "name": "Part", "path": "Disk://part/part.pjx" });
    let edit = session.client.ask("val3/addLibrary", params.clone());
    let change = &edit["documentChanges"][0];
    assert_eq!(change["textDocument"]["uri"], *manifest);
    let text = change["edits"][0]["newText"].as_str().unwrap();
    assert!(text.contains("<Type name=\"Part\" path=\"Disk://part/part.pjx\" />"), "{edit}");
    params["name"] = json!("nA");
    assert_eq!(session.client.ask_in_vain("val3/addLibrary", params), -32803);
    end(session);
}

#[test]
fn an_item_is_deleted_with_its_uses_known() {
    let mut session = session(&["delete"]);
    let tree = session.client.ask("val3/workspaceTree", Value::Null);
    let of_data = session.client.ask("val3/delete", position(&tree[0]["data"], "nA"));
    assert_eq!(of_data["edit"]["documentChanges"][0]["edits"][0]["newText"], "");
    assert_eq!(of_data["uses"][0]["range"]["start"], json!({ "line": 4, "character": 2 }), "{of_data}");
    let of_program = session.client.ask("val3/delete", position(&tree[0]["programs"], "other"));
    let changes = of_program["edit"]["documentChanges"].as_array().unwrap();
    assert_eq!(changes[0]["textDocument"]["uri"], *uri(&session.cell.path(MANIFEST)));
    assert_eq!(changes[1]["kind"], "delete");
    assert_eq!(of_program["uses"].as_array().unwrap().len(), 1);
    end(session);
}

/// Position of an item of the tree.
fn position(list: &Value, name: &str) -> Value {
    let location = find(list, "name", name)["location"].clone();
    json!({ "textDocument": { "uri": location["uri"] }, "position": location["range"]["start"] })
}

#[test]
fn a_client_that_deletes_no_files_keeps_its_programs() {
    let mut session = session(&[]);
    let path = session.cell.path("usrapp/main/other.pgx");
    let position = json!({ "line": 2, "character": 19 });
    let params = json!({ "textDocument": { "uri": uri(&path) }, "position": position });
    assert_eq!(session.client.ask_in_vain("val3/delete", params), -32803);
    end(session);
}
