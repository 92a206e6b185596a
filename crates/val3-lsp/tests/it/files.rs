//! Files that the user renames, creates and deletes in the editor.

use serde_json::{Value, json};

use crate::client::uri;
use crate::codes;
use crate::open_session::{Session, each};

const CELL: &str = "call other()\nprogram other()\nbegin\n  cls()\nend";

const OTHER: &str = "usrapp/main/other.pgx";
const MANIFEST: &str = "usrapp/main/main.pjx";

fn texts(edit: &Value, path: &str) -> Vec<String> {
    let of_file = &edit["changes"][&uri(path)];
    if of_file.is_null() { Vec::new() } else { each(of_file, "newText").into_iter().map(str::to_owned).collect() }
}

#[test]
fn edits_for_renamed_files_are_returned_before_the_rename() {
    let mut session = Session::of(CELL, json!({}));
    let (other, manifest) = (session.cell.path(OTHER), session.cell.path(MANIFEST));
    let renamed = json!({ "oldUri": uri(&other), "newUri": uri(&session.cell.path("usrapp/main/second.pgx")) });
    let edit = session.client.ask("workspace/willRenameFiles", json!({ "files": [renamed] }));
    assert_eq!(texts(&edit, &manifest), ["second.pgx"]);
    assert_eq!(texts(&edit, &other), ["second"]);
    assert_eq!(texts(&edit, &session.cell.path(crate::open_session::START)), ["second"]);
    let created = json!({ "uri": uri(&session.cell.path("usrapp/main/third.pgx")) });
    let edit = session.client.ask("workspace/willCreateFiles", json!({ "files": [created] }));
    assert!(texts(&edit, &manifest)[0].contains("third.pgx"), "{edit}");
    let edit = session.client.ask("workspace/willDeleteFiles", json!({ "files": [{ "uri": uri(&other) }] }));
    assert_eq!(texts(&edit, &manifest), [""]);
    let unknown = json!({ "uri": "file:///nowhere/other.txt" });
    assert!(session.client.ask("workspace/willDeleteFiles", json!({ "files": [unknown] })).is_null());
    assert!(session.client.ask("workspace/willDeleteFiles", json!({ "files": [{ "uri": "%" }] })).is_null());
    assert_eq!(session.client.end(), 0);
}

#[test]
fn renamed_files_are_read_again() {
    // This client announces file watching but reports no changes: its notifications about renamed files must suffice.
    let watching = json!({ "workspace": { "didChangeWatchedFiles": { "dynamicRegistration": true } } });
    let mut session = Session::of(CELL, watching);
    let (other, manifest) = (session.cell.path(OTHER), session.cell.path(MANIFEST));
    session.client.findings(&session.cell.path(crate::open_session::START), Some(1));
    let other_text = session.cell.text(OTHER).to_owned();
    session.cell.remove(OTHER);
    session.client.notify("workspace/didDeleteFiles", json!({ "files": [{ "uri": uri(&other) }] }));
    assert!(!session.client.findings(&manifest, None).is_empty());
    session.cell.write(OTHER, &other_text);
    session.client.notify("workspace/didCreateFiles", json!({ "files": [{ "uri": uri(&other) }] }));
    assert_eq!(session.client.findings(&manifest, None), Vec::<Value>::new());
    session.cell.remove(OTHER);
    session.cell.write("usrapp/main/second.pgx", &other_text);
    let renamed = json!({ "oldUri": uri(&other), "newUri": uri(&session.cell.path("usrapp/main/second.pgx")) });
    session.client.notify("workspace/didRenameFiles", json!({ "files": [renamed] }));
    assert!(!codes(&session.client.findings(&manifest, None)).is_empty());
    assert_eq!(session.client.end(), 0);
}
