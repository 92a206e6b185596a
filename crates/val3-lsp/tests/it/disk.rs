//! Files and folders that change beside the editor.

use serde_json::{Value, json};

use crate::cell::Cell;
use crate::client::{Client, uri};
use crate::codes;

fn changed(client: &mut Client, path: &str) {
    let change = json!({ "uri": uri(path), "type": 2 });
    client.notify("workspace/didChangeWatchedFiles", json!({ "changes": [change] }));
}

fn watching() -> Value {
    json!({ "workspace": { "didChangeWatchedFiles": { "dynamicRegistration": true } } })
}

const CELL: &str = "num nA\nnA=1\nput(nA)\ncall other()\nprogram other()\nbegin\n  put(nA)\nend";

#[test]
fn the_client_tells() {
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
    // What the editor has open counts, whatever is stored.
    client.open(&start, &text);
    client.findings(&start, Some(1));
    cell.write("usrapp/main/start.pgx", "");
    changed(&mut client, &start);
    let hover = client.ask("textDocument/documentSymbol", json!({ "textDocument": { "uri": uri(&start) } }));
    assert!(!hover.as_array().unwrap().is_empty());
    assert_eq!(client.end(), 0);
}

#[test]
fn the_server_looks_itself() {
    let cell = Cell::new(CELL);
    let start = cell.path("usrapp/main/start.pgx");
    let mut client = Client::start(&[&cell.folder()]);
    client.open(&start, cell.text("usrapp/main/start.pgx"));
    assert_eq!(client.findings(&start, Some(1)), Vec::<Value>::new());
    // The watch begins with `initialized`; a hover behind it shows that it was taken.
    client.ask("val3/workspaceTree", Value::Null);
    cell.write("usrapp/main/other.pgx", &cell.text("usrapp/main/other.pgx").replace("nA", "nB"));
    // The file may be seen half written first.
    while !codes(&client.findings(&cell.path("usrapp/main/other.pgx"), None)).contains(&"V0101") {}
    assert_eq!(client.end(), 0);
}

#[test]
fn files_come_and_go() {
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
fn the_project_file_is_edited() {
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
fn the_configuration_is_edited() {
    let cell = Cell::new("nA=1");
    let start = cell.path("usrapp/main/start.pgx");
    let config = cell.path("val3.toml");
    let mut client = Client::start(&[&cell.folder()]);
    assert_eq!(codes(&client.findings(&start, None)), ["V0101"]);
    client.open(&config, "[rules]\nV0101 = \"off\"\n");
    assert_eq!(client.findings(&start, None), Vec::<Value>::new());
    // While it is at fault it counts as it was.
    client.change(&config, 2, "[rules]\nV0101 = \"of\"\n");
    let found = client.findings(&config, None);
    assert_eq!(found[0]["range"]["start"]["line"], 1, "{found:?}");
    client.change(&config, 3, "[rules]\n");
    assert_eq!(client.findings(&config, None), Vec::<Value>::new());
    assert_eq!(codes(&client.findings(&start, None)), ["V0101"]);
    assert_eq!(client.end(), 0);
}

#[test]
fn folders_come_and_go() {
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
