//! Files and folders that change outside the editor.

use serde_json::{Value, json};

use crate::cell::{Cell, place};
use crate::client::{Client, at, uri};
use crate::codes;

fn changed(client: &mut Client, path: &str) {
    happened(client, &[(path, 2)]);
}

/// Reports changed paths: 1 created, 2 changed, 3 deleted.
fn happened(client: &mut Client, events: &[(&str, u8)]) {
    let changes: Vec<Value> = events.iter().map(|(path, kind)| json!({ "uri": uri(path), "type": kind })).collect();
    client.notify("workspace/didChangeWatchedFiles", json!({ "changes": changes }));
}

fn watching() -> Value {
    json!({ "workspace": { "didChangeWatchedFiles": { "dynamicRegistration": true } } })
}

const CELL: &str = "num nA\nnA=1\nput(nA)\ncall other()\nprogram other()\nbegin\n  put(nA)\nend";

#[test]
fn changes_reported_by_the_client_are_read() {
    let cell = Cell::new(CELL);
    let start = cell.path("usrapp/main/start.pgx");
    let mut client = Client::start_with(&[&cell.folder()], watching(), Value::Null);
    let registered = client.told("client/registerCapability");
    assert_eq!(registered["params"]["registrations"][0]["method"], "workspace/didChangeWatchedFiles");
    client.send(&json!({ "jsonrpc": "2.0", "id": registered["id"], "result": null }));
    let text = cell.text("usrapp/main/start.pgx").to_owned();
    cell.write("usrapp/main/start.pgx", &text.replace("nA=1", "nB=1"));
    changed(&mut client, &start);
    assert!(codes(&client.findings(&start, None)).contains(&"V0101"));
    cell.write("usrapp/main/start.pgx", &text);
    changed(&mut client, &start);
    assert_eq!(client.findings(&start, None), Vec::<Value>::new());
    // An open document has priority over the stored file.
    client.open(&start, &text);
    client.findings(&start, Some(1));
    cell.write("usrapp/main/start.pgx", "");
    changed(&mut client, &start);
    let hover = client.ask("textDocument/documentSymbol", json!({ "textDocument": { "uri": uri(&start) } }));
    assert!(!hover.as_array().unwrap().is_empty());
    assert_eq!(client.end(), 0);
}

#[test]
fn the_server_watches_the_disk_itself() {
    let cell = Cell::new(CELL);
    let start = cell.path("usrapp/main/start.pgx");
    let mut client = Client::start(&[&cell.folder()]);
    client.open(&start, cell.text("usrapp/main/start.pgx"));
    assert_eq!(client.findings(&start, Some(1)), Vec::<Value>::new());
    // Watching starts with `initialized`; the response to a later request shows that it was handled.
    client.ask("val3/workspaceTree", Value::Null);
    cell.write("usrapp/main/other.pgx", &cell.text("usrapp/main/other.pgx").replace("nA", "nB"));
    // The watcher may report the file half written first.
    while !codes(&client.findings(&cell.path("usrapp/main/other.pgx"), None)).contains(&"V0101") {}
    assert_eq!(client.end(), 0);
}

#[test]
fn created_and_deleted_files_are_noticed() {
    let cell = Cell::new(CELL);
    let (start, other) = (cell.path("usrapp/main/start.pgx"), cell.path("usrapp/main/other.pgx"));
    let manifest = cell.path("usrapp/main/main.pjx");
    let mut client = Client::start_with(&[&cell.folder()], watching(), Value::Null);
    client.open(&start, cell.text("usrapp/main/start.pgx"));
    assert_eq!(client.findings(&start, Some(1)), Vec::<Value>::new());
    cell.remove("usrapp/main/other.pgx");
    changed(&mut client, &other);
    assert!(!client.findings(&manifest, None).is_empty());
    cell.write("usrapp/main/other.pgx", cell.text("usrapp/main/other.pgx"));
    changed(&mut client, &other);
    assert_eq!(client.findings(&manifest, None), Vec::<Value>::new());
    assert_eq!(client.end(), 0);
}

#[test]
fn an_edit_of_the_project_file_is_noticed() {
    let cell = Cell::new(CELL);
    let (start, manifest) = (cell.path("usrapp/main/start.pgx"), cell.path("usrapp/main/main.pjx"));
    let mut client = Client::start(&[&cell.folder()]);
    let text = cell.text("usrapp/main/main.pjx");
    client.open(&manifest, text);
    assert_eq!(client.findings(&manifest, Some(1)), Vec::<Value>::new());
    let without: String =
        text.lines().filter(|line| !line.contains("other.pgx")).map(|line| line.to_owned() + "\n").collect();
    client.change(&manifest, 2, &without);
    assert!(!client.findings(&start, None).is_empty());
    client.change(&manifest, 3, text);
    assert_eq!(client.findings(&start, None), Vec::<Value>::new());
    assert_eq!(client.end(), 0);
}

#[test]
fn an_edit_of_the_configuration_is_noticed() {
    let cell = Cell::new("nA=1");
    let start = cell.path("usrapp/main/start.pgx");
    let config = cell.path("val3.toml");
    let mut client = Client::start(&[&cell.folder()]);
    assert_eq!(codes(&client.findings(&start, None)), ["V0101"]);
    client.open(&config, "[rules]\nV0101 = \"off\"\n");
    assert_eq!(client.findings(&start, None), Vec::<Value>::new());
    // While the configuration is faulty, its last valid state is in effect.
    client.change(&config, 2, "[rules]\nV0101 = \"of\"\n");
    let found = client.findings(&config, None);
    assert_eq!(found[0]["range"]["start"]["line"], 1, "{found:?}");
    client.change(&config, 3, "[rules]\n");
    assert_eq!(client.findings(&config, None), Vec::<Value>::new());
    assert_eq!(codes(&client.findings(&start, None)), ["V0101"]);
    assert_eq!(client.end(), 0);
}

#[test]
fn added_and_removed_folders_are_noticed() {
    let (one, two) = (Cell::new("nA=1"), Cell::new("nB=1"));
    let mut client = Client::start_with(&[&one.folder()], watching(), Value::Null);
    client.findings(&one.path("usrapp/main/start.pgx"), None);
    let folder = |cell: &Cell| json!({ "uri": uri(&cell.folder()), "name": "cell" });
    let event = json!({ "event": { "added": [folder(&two)], "removed": [folder(&one)] } });
    client.notify("workspace/didChangeWorkspaceFolders", event);
    assert_eq!(client.findings(&one.path("usrapp/main/start.pgx"), None), Vec::<Value>::new());
    assert_eq!(codes(&client.findings(&two.path("usrapp/main/start.pgx"), None)), ["V0101"]);
    assert_eq!(client.end(), 0);
}

#[test]
fn a_single_file_finds_its_project() {
    let cell = Cell::new(CELL);
    let start = cell.path("usrapp/main/start.pgx");
    let mut client = Client::start(&[]);
    client.open(&start, &cell.text("usrapp/main/start.pgx").replace("call other", "call ohter"));
    let found = client.findings(&start, Some(1));
    assert!(found[0]["message"].as_str().unwrap().contains("other"), "{found:?}");
    assert_eq!(client.end(), 0);
}

const MANIFEST: &str = "usrapp/main/main.pjx";
const OTHER: &str = "usrapp/main/other.pgx";

/// A cell that lists `OTHER.PGX`, which is `other.pgx` on the disk, and a client with or without file watchers.
fn spelt_otherwise(watches: bool) -> (Cell, Client) {
    let cell = Cell::new(CELL);
    cell.write(MANIFEST, &cell.text(MANIFEST).replace("other.pgx", "OTHER.PGX"));
    let abilities = if watches { watching() } else { json!({}) };
    let mut client = Client::start_with(&[&cell.folder()], abilities, Value::Null);
    client.ask("val3/workspaceTree", Value::Null);
    (cell, client)
}

/// Writes a file like a program outside the editor.
fn write(cell: &Cell, client: &mut Client, file: &str, text: &str, watches: bool) {
    cell.write(file, text);
    if watches {
        changed(client, &cell.path(file));
    }
}

/// Waits for findings that satisfy the condition.
fn wait_for_codes(client: &mut Client, path: &str, wanted: impl Fn(&[&str]) -> bool) {
    while !wanted(&codes(&client.findings(path, None))) {}
}

#[test]
fn a_change_of_a_file_in_another_letter_case_is_noticed() {
    for watches in [true, false] {
        let (cell, mut client) = spelt_otherwise(watches);
        let (other, text) = (cell.path(OTHER), cell.text(OTHER).to_owned());
        write(&cell, &mut client, OTHER, &text.replace("nA", "nB"), watches);
        wait_for_codes(&mut client, &other, |codes| codes.contains(&"V0101"));
        write(&cell, &mut client, OTHER, &text, watches);
        wait_for_codes(&mut client, &other, |codes| codes.is_empty());
        assert_eq!(client.end(), 0);
    }
}

#[test]
fn a_file_in_another_letter_case_is_closed_without_saving() {
    for watches in [true, false] {
        let (cell, mut client) = spelt_otherwise(watches);
        let (other, text) = (cell.path(OTHER), cell.text(OTHER).to_owned());
        client.open(&other, &text.replace("nA", "nB"));
        assert!(codes(&client.latest_findings(&other, 1)).contains(&"V0101"));
        client.notify("textDocument/didClose", json!({ "textDocument": { "uri": uri(&other) } }));
        assert_eq!(client.findings(&other, None), Vec::<Value>::new());
        assert_eq!(client.end(), 0);
    }
}

#[test]
fn a_rename_reaches_a_file_in_another_letter_case_where_it_is_now() {
    for watches in [true, false] {
        let (cell, mut client) = spelt_otherwise(watches);
        let (start, other) = (cell.path("usrapp/main/start.pgx"), cell.path(OTHER));
        client.open(&start, cell.text("usrapp/main/start.pgx"));
        client.findings(&start, Some(1));
        let text = cell.text(OTHER).replace("  put(nA)", "  cls()\n  // é\n    put(1+nA+nB)");
        write(&cell, &mut client, OTHER, &text, watches);
        wait_for_codes(&mut client, &other, |codes| codes.contains(&"V0101"));
        let (line, column) = place(cell.text("usrapp/main/start.pgx"), "nA");
        let mut params = at(&start, line, column);
        params["newName"] = json!("nNew");
        let edit = client.ask("textDocument/rename", params);
        let (line, column) = place(&text, "nA");
        let start = json!({ "line": line, "character": column });
        assert_eq!(edit["changes"][uri(&other)][0]["range"]["start"], start, "{edit}");
        assert_eq!(client.end(), 0);
    }
}

#[test]
fn a_file_in_another_spelling_is_the_same() {
    let cell = Cell::new(CELL);
    let other = cell.path("usrapp/main/OTHER.pgx");
    let mut client = Client::start_with(&[&cell.folder()], watching(), Value::Null);
    client.ask("val3/workspaceTree", Value::Null);
    let text = cell.text(OTHER).replace("nA", "nB");
    client.open(&other, &text);
    assert!(codes(&client.latest_findings(&other, 1)).contains(&"V0101"));
    client.change(&other, 2, &text.replace("nB", "nC"));
    let found = client.latest_findings(&other, 2);
    assert!(found.iter().any(|found| found["message"].as_str().unwrap().contains("nC")), "{found:?}");
    // If another file of the project is read again, the document stays in effect.
    changed(&mut client, &cell.path(MANIFEST));
    client.ask("val3/workspaceTree", Value::Null);
    assert_eq!(client.try_told("textDocument/publishDiagnostics"), None);
    client.notify("textDocument/didClose", json!({ "textDocument": { "uri": uri(&other) } }));
    assert_eq!(client.findings(&other, None), Vec::<Value>::new());
    assert_eq!(client.end(), 0);
}

#[test]
fn the_later_of_two_documents_of_one_file_counts() {
    let cell = Cell::new(CELL);
    let (one, two) = (cell.path(OTHER), cell.path("usrapp/main/Other.pgx"));
    let mut client = Client::start(&[&cell.folder()]);
    client.open(&one, cell.text(OTHER));
    client.open(&two, &cell.text(OTHER).replace("nA", "nB"));
    assert!(codes(&client.latest_findings(&two, 1)).contains(&"V0101"));
    // Positions in the other document would belong to another text.
    client.change(&one, 2, "");
    assert_eq!(client.ask("textDocument/documentSymbol", json!({ "textDocument": { "uri": uri(&one) } })), Value::Null);
    client.notify("textDocument/didClose", json!({ "textDocument": { "uri": uri(&two) } }));
    assert!(!client.findings(&one, Some(2)).is_empty());
    assert_eq!(client.end(), 0);
}

/// A program of the application, a library and its folder are in folders whose names have an extension.
const FOLDERS: &str = "call other()\n\
    === main/main.pjx\n<?xml version=\"1.0\" encoding=\"utf-8\"?>\n\
    <Project xmlns=\"http://www.staubli.com/robotics/VAL3/Project/3\">\n\
    <Parameters version=\"s8.20\" stackSize=\"5000\" millimeterUnit=\"true\" />\n\
    <Programs><Program file=\"start.pgx\" /><Program file=\"more.v1/other.pgx\" /></Programs>\n\
    <Database><Data file=\"main.dtx\" /></Database>\n<Libraries /><Types />\n</Project>\n\
    === main/more.v1/other.pgx\n<?xml version=\"1.0\" encoding=\"utf-8\"?>\n\
    <Programs xmlns=\"http://www.staubli.com/robotics/VAL3/Program/2\">\n\
    <Program name=\"other\" access=\"private\"><Code><![CDATA[begin\n  cls()\nend]]></Code></Program></Programs>\n";

/// Moves a folder like a program outside the editor. Clients report only the folder.
fn move_folder(cell: &Cell, client: &mut Client, from: &str, to: &str, watches: bool) {
    cell.rename(from, to);
    if watches {
        happened(client, &[(&cell.path(from), 3), (&cell.path(to), 1)]);
    }
}

#[test]
fn moved_and_deleted_folders_are_noticed() {
    for watches in [true, false] {
        let cell = Cell::new(FOLDERS);
        let manifest = cell.path(MANIFEST);
        let abilities = if watches { watching() } else { json!({}) };
        let mut client = Client::start_with(&[&cell.folder()], abilities, Value::Null);
        client.open(&manifest, cell.text(MANIFEST));
        assert_eq!(client.latest_findings(&manifest, 1), Vec::<Value>::new());
        let (folder, away) = ("usrapp/main/more.v1", "more.v1");
        move_folder(&cell, &mut client, folder, away, watches);
        wait_for_codes(&mut client, &manifest, |codes| codes.contains(&"V0501"));
        move_folder(&cell, &mut client, away, folder, watches);
        wait_for_codes(&mut client, &manifest, |codes| codes.is_empty());
        cell.remove_folder(folder);
        if watches {
            happened(&mut client, &[(&cell.path(folder), 3)]);
        }
        wait_for_codes(&mut client, &manifest, |codes| codes.contains(&"V0501"));
        assert_eq!(client.end(), 0);
    }
}

#[test]
fn a_changed_folder_does_not_reread_its_files() {
    let cell = Cell::new(CELL);
    let other = cell.path(OTHER);
    let mut client = Client::start_with(&[&cell.folder()], watching(), Value::Null);
    client.open(&other, cell.text(OTHER));
    assert_eq!(client.latest_findings(&other, 1), Vec::<Value>::new());
    // Clients that report every change also report folders and unrelated files.
    happened(&mut client, &[(&cell.path("usrapp/main"), 2), (&cell.path("usrapp/main/notes.txt"), 1)]);
    assert_eq!(client.try_told("textDocument/publishDiagnostics"), None);
    assert_eq!(client.end(), 0);
}
