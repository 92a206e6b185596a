//! Things around the arm: `cell.toml`.

use serde_json::{Value, json};

use crate::cell::{Cell, place};
use crate::client::{Client, at, uri};
use crate::open_session::{Session, each, find};

const FILE: &str = "cell.toml";
const DATA: &str = "usrapp/main/main.dtx";

const CELL: &str = "\
frame fPallet
frame fRows[2]
tool tGrip
program start()
begin
  fPallet.trsf.x=1
end

=== /val3.toml
arm = \"tx2-60l\"
=== /cell.toml
clearance = 20
[[object]]
name = \"pallet\"
in = \"fPallet\"
box = [1200, 800, 144]

[[object]]
name = \"row\"
in = \"fRows[1]\"
box = [100, 100, 10]
";

fn moving() -> Value {
    json!({ "workspace": { "workspaceEdit": { "documentChanges": true } } })
}

#[test]
fn a_carrier_leads_to_its_data() {
    let mut session = Session::of(CELL, json!({}));
    let place = session.place_in(FILE, "Pallet\"");
    let to = session.client.ask("textDocument/definition", place.clone());
    assert!(to[0]["uri"].as_str().unwrap().ends_with("/main.dtx"), "{to}");
    let hover = session.client.ask("textDocument/hover", place);
    assert!(hover["contents"].to_string().contains("frame"), "{hover}");
    assert_eq!(session.client.end(), 0);
}

#[test]
fn a_rename_of_data_changes_the_file() {
    let mut session = Session::of(CELL, moving());
    let mut params = session.place("fPallet");
    params["context"] = json!({ "includeDeclaration": true });
    let found = session.client.ask("textDocument/references", params.clone());
    let files = each(&found, "uri");
    let ends = ["/cell.toml", "/main.dtx", "/start.pgx"];
    assert!(files.len() == 3 && ends.iter().all(|end| files.iter().any(|file| file.ends_with(end))), "{files:?}");
    params["newName"] = json!("fTray");
    let change = session.client.ask("textDocument/rename", params);
    let file = uri(&session.cell.path(FILE));
    let of_file = change["documentChanges"].as_array().unwrap().iter().find(|one| one["textDocument"]["uri"] == *file);
    let (line, column) = place(session.cell.text(FILE), "fPallet");
    let end = json!({ "line": line, "character": column + 7 });
    let edit = json!({ "range": { "start": { "line": line, "character": column }, "end": end }, "newText": "fTray" });
    assert_eq!(of_file.unwrap()["edits"], json!([edit]));
    assert_eq!(session.client.end(), 0);
}

#[test]
fn a_rename_can_begin_in_the_file() {
    let mut session = Session::of(CELL, moving());
    let mut params = session.place_in(FILE, "fRows");
    params["newName"] = json!("fLines");
    let change = session.client.ask("textDocument/rename", params);
    let files: Vec<&str> = change["documentChanges"]
        .as_array()
        .unwrap()
        .iter()
        .map(|one| one["textDocument"]["uri"].as_str().unwrap())
        .collect();
    assert!(files.len() == 2 && files.iter().any(|file| file.ends_with(DATA)), "{change}");
    assert_eq!(session.client.end(), 0);
}

#[test]
fn keys_and_carriers_are_completed() {
    let cell = Cell::new(CELL);
    cell.write("cad/rack.stl", "solid rack\nendsolid rack\n");
    let file = cell.path(FILE);
    let mut client = Client::start(&[&cell.folder()]);
    let mut labels = |version: i64, text: &str| {
        if version == 1 {
            client.open(&file, text);
        } else {
            client.change(&file, version, text);
        }
        let line = u32::try_from(text.matches('\n').count()).unwrap();
        let column = u32::try_from(text.rsplit('\n').next().unwrap().len()).unwrap();
        let list = client.ask("textDocument/completion", at(&file, line, column));
        each(&list["items"], "label").into_iter().map(str::to_owned).collect::<Vec<_>>()
    };
    let carriers = labels(1, "[[object]]\nname = \"rack\"\n[[object]]\nin = \"");
    for name in ["fPallet", "fRows[1]", "tGrip", "rack", "flange", "link6"] {
        assert!(carriers.iter().any(|label| label == name), "{name} in {carriers:?}");
    }
    assert_eq!(labels(2, "[[object]]\nmesh = \""), ["cad/rack.stl"]);
    assert_eq!(labels(3, "[[object]]\nclear"), ["clearance"]);
    assert_eq!(client.end(), 0);
}

#[test]
fn faults_are_reported_while_the_file_is_edited() {
    let cell = Cell::new(CELL);
    let file = cell.path(FILE);
    let mut client = Client::start(&[&cell.folder()]);
    client.open(&file, cell.text(FILE));
    assert_eq!(client.findings(&file, Some(1)), Vec::<Value>::new());
    client.change(&file, 2, &cell.text(FILE).replace("fPallet", "fPalet"));
    let found = client.findings(&file, Some(2));
    let message = "there is no frame, tool or object `fPalet`\nhelp: did you mean `fPallet`?";
    assert_eq!(found.iter().map(|one| one["message"].as_str().unwrap()).collect::<Vec<_>>(), [message]);
    client.change(&file, 3, &cell.text(FILE).replace("clearance", "clearence"));
    assert!(client.findings(&file, Some(3))[0]["message"].as_str().unwrap().contains("no setting `clearence`"));
    client.change(&file, 4, cell.text(FILE));
    assert_eq!(client.findings(&file, Some(4)), Vec::<Value>::new());
    assert_eq!(client.end(), 0);
}

#[test]
fn no_feature_of_programs_treats_the_file_as_one() {
    let mut session = Session::of(CELL, json!({}));
    let document = json!({
        "textDocument": { "uri": uri(&session.cell.path(FILE)) },
        "options": { "tabSize": 2, "insertSpaces": true },
        "range": { "start": { "line": 0, "character": 0 }, "end": { "line": 9, "character": 0 } },
    });
    for method in ["formatting", "documentSymbol", "foldingRange", "codeLens", "inlayHint", "documentLink"] {
        let found = session.client.ask(&format!("textDocument/{method}"), document.clone());
        assert!(found.as_array().is_none_or(Vec::is_empty), "{method}: {found}");
    }
    let tokens = session.client.ask("textDocument/semanticTokens/full", document);
    assert!(tokens["data"].as_array().is_none_or(Vec::is_empty), "{tokens}");
    assert_eq!(session.client.end(), 0);
}

#[test]
fn a_new_file_is_read() {
    let cell = Cell::new("frame fPallet\ncls()\n=== /val3.toml\narm = \"tx2-60l\"\n");
    let (file, data) = (cell.path(FILE), cell.path(DATA));
    let mut client = Client::start(&[&cell.folder()]);
    client.open(&file, "[[object]]\nname = \"a\"\nin = \"fPallet\"\nbox = [1, 2, 3]\n");
    assert_eq!(client.findings(&file, Some(1)), Vec::<Value>::new());
    let mut params = at(&file, 2, 8);
    params["context"] = json!({ "includeDeclaration": true });
    let found = client.ask("textDocument/references", params);
    find(&found, "uri", &uri(&data));
    assert_eq!(client.end(), 0);
}
