//! Bindings of user pages: `interface/<page>.bindings.json`.

use serde_json::{Value, json};

use crate::cell::{Cell, place};
use crate::client::{Client, at, uri};
use crate::codes;
use crate::open_session::{START, Session};

const HTML: &str = "usrapp/main/interface/main.html";
const BINDINGS: &str = "usrapp/main/interface/main.bindings.json";

/// A second binding on the same line, after characters with two UTF-16 units.
const CELL: &str = r#"version s8.10
num nCount
program start()
begin
  userPage("main")
  userPageSet("main","lblCount","innerHTML","")
  nCount=1
  call clkReset()
end
program clkReset()
begin
  nCount=0
end

=== main/interface/main.html
<html><body><label id="lblCount">😀</label><button id="btnReset"/></body></html>
=== main/interface/main.bindings.json
{"title":"😀 é","bindings":[{"id":"lblCount","attribute":"innerHTML","data":"nCount[0]","direction":"r"}],"callbacks":[{"id":"btnReset","event":"click","data":"clkReset"}]}
"#;

/// Capabilities of a client that moves files in a rename.
fn moving() -> Value {
    json!({ "workspace": { "workspaceEdit": { "documentChanges": true, "resourceOperations": ["rename"] } } })
}

/// Applies the edits of a rename to a file.
fn renamed(client: &mut Client, mut params: Value, new_name: &str, path: &str, text: &str) -> String {
    params["newName"] = json!(new_name);
    let change = client.ask("textDocument/rename", params);
    let mut changes = change["documentChanges"].as_array().unwrap().iter();
    let of_file = changes.find(|change| change["textDocument"]["uri"] == *uri(path));
    let mut edits = of_file.unwrap_or_else(|| panic!("{change}"))["edits"].as_array().unwrap().clone();
    edits.sort_by_key(|edit| edit["range"]["start"]["character"].as_u64());
    let mut units: Vec<u16> = text.encode_utf16().collect();
    for edit in edits.iter().rev() {
        let end = |name: &str| usize::try_from(edit["range"][name]["character"].as_u64().unwrap()).unwrap();
        assert_eq!(edit["range"]["start"]["line"], 0);
        units.splice(end("start")..end("end"), edit["newText"].as_str().unwrap().encode_utf16());
    }
    String::from_utf16(&units).unwrap()
}

#[test]
fn names_are_renamed_in_the_files_of_pages() {
    let mut session = Session::of(CELL, moving());
    let (bindings, html) = (session.cell.path(BINDINGS), session.cell.path(HTML));
    let text = session.cell.text(BINDINGS).to_owned();
    for (part, new_name) in [("nCount=1", "nTotal"), ("clkReset()", "clkZero")] {
        let from = session.place(part);
        let old = part.split(['=', '(']).next().unwrap();
        let found = renamed(&mut session.client, from, new_name, &bindings, &text);
        assert_eq!(found, text.replace(old, new_name));
    }
    let id = session.place_in(HTML, "btnReset");
    assert_eq!(session.client.ask("textDocument/prepareRename", id.clone())["placeholder"], "btnReset");
    assert_eq!(
        renamed(&mut session.client, id.clone(), "btnZero", &bindings, &text),
        text.replace("btnReset", "btnZero")
    );
    let page = session.cell.text(HTML).to_owned();
    assert_eq!(renamed(&mut session.client, id, "btnZero", &html, &page), page.replace("btnReset", "btnZero"));
    assert_eq!(session.client.end(), 0);
}

#[test]
fn a_byte_order_mark_moves_no_edit() {
    let cell = Cell::new(CELL);
    let text = cell.text(BINDINGS);
    cell.write_bytes(BINDINGS, format!("\u{feff}{text}").as_bytes());
    let (start, bindings) = (cell.path(START), cell.path(BINDINGS));
    let mut client = Client::start_with(&[&cell.folder()], moving(), Value::Null);
    let (line, column) = place(cell.text(START), "nCount=1");
    let found = renamed(&mut client, at(&start, line, column), "nTotal", &bindings, text);
    assert_eq!(found, text.replace("nCount", "nTotal"));
    assert_eq!(client.end(), 0);
}

#[test]
fn references_and_renames_begin_in_an_open_file_of_bindings() {
    let mut session = Session::of(CELL, moving());
    let bindings = session.cell.path(BINDINGS);
    let edited = session.cell.text(BINDINGS).replace("😀", "😀😀");
    session.client.open(&bindings, &edited);
    let (line, column) = place(&edited, "nCount");
    let mut params = at(&bindings, line, column);
    params["context"] = json!({ "includeDeclaration": true });
    let found = session.client.ask("textDocument/references", params.clone());
    let files: Vec<&str> = found.as_array().unwrap().iter().map(|it| it["uri"].as_str().unwrap()).collect();
    let ends = ["/clkReset.pgx", "/main.bindings.json", "/main.dtx", "/start.pgx"];
    assert!(files.len() == 4 && ends.iter().all(|end| files.iter().any(|file| file.ends_with(end))), "{files:?}");
    let to = session.client.ask("textDocument/definition", params.clone());
    assert!(to[0]["uri"].as_str().unwrap().ends_with("/main.dtx"), "{to}");
    assert_eq!(
        renamed(&mut session.client, params.clone(), "nTotal", &bindings, &edited),
        edited.replace("nCount", "nTotal")
    );
    // The file is no program, and no feature treats it as one.
    let document =
        json!({ "textDocument": { "uri": uri(&bindings) }, "options": { "tabSize": 2, "insertSpaces": true } });
    assert_eq!(session.client.ask("textDocument/formatting", document.clone()), json!([]));
    let proposed = session.client.ask("textDocument/completion", at(&bindings, line, column));
    assert!(proposed["items"].as_array().is_none_or(Vec::is_empty), "{proposed}");
    assert_eq!(session.client.ask("textDocument/documentSymbol", document.clone()), json!([]));
    assert_eq!(session.client.ask("textDocument/foldingRange", document), json!([]));
    assert_eq!(session.client.end(), 0);
}

#[test]
fn findings_follow_edits_of_open_bindings() {
    let cell = Cell::new(CELL);
    let bindings = cell.path(BINDINGS);
    let mut client = Client::start(&[&cell.folder()]);
    client.open(&bindings, cell.text(BINDINGS));
    assert_eq!(client.findings(&bindings, Some(1)), Vec::<Value>::new());
    client.change(&bindings, 2, &cell.text(BINDINGS).replace("nCount", "nCuont"));
    assert_eq!(codes(&client.findings(&bindings, Some(2))), ["V0560"]);
    client.change(&bindings, 3, cell.text(BINDINGS));
    assert_eq!(client.findings(&bindings, Some(3)), Vec::<Value>::new());
    assert_eq!(client.end(), 0);
}

/// The file on the disk is in effect, whether the client or the server watches.
#[test]
fn files_of_pages_are_watched() {
    let watches = json!({ "workspace": { "didChangeWatchedFiles": { "dynamicRegistration": true } } });
    for abilities in [watches, json!({})] {
        let is_told = abilities != json!({});
        let cell = Cell::new(CELL);
        let (start, bindings, html) = (cell.path(START), cell.path(BINDINGS), cell.path(HTML));
        let mut client = Client::start_with(&[&cell.folder()], abilities, Value::Null);
        client.open(&start, cell.text(START));
        client.findings(&start, Some(1));
        client.ask("val3/workspaceTree", Value::Null);
        let tell = |client: &mut Client, path, kind| is_told.then(|| tell_change(client, path, kind));
        cell.write(BINDINGS, &cell.text(BINDINGS).replace("nCount", "nCuont"));
        tell(&mut client, &bindings, 2);
        while codes(&client.findings(&bindings, None)) != ["V0560"] {}
        cell.write(BINDINGS, cell.text(BINDINGS));
        tell(&mut client, &bindings, 2);
        while !client.findings(&bindings, None).is_empty() {}
        // The page no longer has this element.
        cell.write(HTML, &cell.text(HTML).replace("btnReset", "btnStop"));
        tell(&mut client, &html, 2);
        while codes(&client.findings(&bindings, None)) != ["V0560"] {}
        // Without the HTML file, the elements are unknown.
        cell.remove(HTML);
        tell(&mut client, &html, 3);
        while !client.findings(&bindings, None).is_empty() {}
        cell.write(HTML, "<html/>");
        tell(&mut client, &html, 1);
        while client.findings(&bindings, None).len() != 2 {}
        assert_eq!(client.end(), 0);
    }
}

/// Reports a changed file to the server; 1 is a new, 2 a changed and 3 a deleted file.
fn tell_change(client: &mut Client, path: &str, kind: u8) {
    let changes = json!([{ "uri": uri(path), "type": kind }]);
    client.notify("workspace/didChangeWatchedFiles", json!({ "changes": changes }));
}
