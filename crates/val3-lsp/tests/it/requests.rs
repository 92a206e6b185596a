//! Each request once, as an editor sends it.

use serde_json::{Value, json};

use crate::cell::place;
use crate::client::{Client, at, uri};
use crate::open_session::{START, Session, each, find};

const CELL: &str = "library part \"Disk://part/part.pjx\"\npoint pA\nnum nA\n\
    program start()\n  num l_i\nbegin\n  // one\n  // two\n  for l_i=1 to 3\n    nA=nA+power(l_i,2)\n  endFor\n  call other(nA)\nend\n\
    program other(num x_n)\nbegin\n  put(x_n)\n  part:nWeight=1\nend\n\
    --- part\npublic num nWeight";

#[test]
fn navigation_requests_are_answered() {
    let mut session = Session::of(CELL, json!({}));
    let to_other = session.ask_at("textDocument/definition", "other(nA)");
    assert!(to_other[0]["uri"].as_str().unwrap().ends_with("/main/other.pgx"), "{to_other}");
    assert_eq!(session.ask_at("textDocument/typeDefinition", "other(nA)"), json!([]));
    assert_eq!(session.ask_at("textDocument/implementation", "other(nA)"), json!([]));
    let highlights = session.ask_at("textDocument/documentHighlight", "nA=nA");
    let kinds: Vec<&Value> = highlights.as_array().unwrap().iter().map(|found| &found["kind"]).collect();
    assert_eq!(kinds, [&json!(3), &json!(2), &json!(2)]);
    let (line, column) = place(session.cell.text(START), "nA=nA");
    let mut params = at(&session.cell.path(START), line, column);
    params["context"] = json!({ "includeDeclaration": true });
    assert_eq!(session.client.ask("textDocument/references", params).as_array().unwrap().len(), 4);
    assert_eq!(session.client.end(), 0);
}

#[test]
fn links_have_their_origin() {
    let mut session = Session::of(CELL, json!({ "textDocument": { "definition": { "linkSupport": true } } }));
    let links = session.ask_at("textDocument/definition", "other(nA)");
    let (line, column) = place(session.cell.text(START), "other(nA)");
    assert_eq!(links[0]["originSelectionRange"]["start"], json!({ "line": line, "character": column }));
    assert_eq!(session.client.end(), 0);
}

#[test]
fn completion_and_signature_help_are_answered() {
    let item = json!({ "snippetSupport": true, "documentationFormat": ["plaintext"] });
    let mut session = Session::of(CELL, json!({ "textDocument": { "completion": { "completionItem": item } } }));
    let list = session.ask_at("textDocument/completion", "power(");
    let items = list["items"].as_array().unwrap();
    let item = items.iter().find(|item| item["label"] == "nA").unwrap_or_else(|| panic!("{list}"));
    let resolved = session.client.ask("completionItem/resolve", item.clone());
    assert_eq!(resolved["documentation"]["kind"], "plaintext");
    assert!(resolved["documentation"]["value"].as_str().unwrap().contains("nA"), "{resolved}");
    let help = session.ask_at("textDocument/signatureHelp", "l_i,2");
    assert_eq!(help["signatures"][0]["label"], "num power(num nX, num nY)");
    assert_eq!(help["activeParameter"], 0);
    assert_eq!(session.client.end(), 0);
}

#[test]
fn a_client_that_names_no_format_gets_a_string() {
    let mut session = Session::of(CELL, json!({}));
    let list = session.ask_at("textDocument/completion", "power(");
    let item = find(&list["items"], "label", "nA");
    let resolved = session.client.ask("completionItem/resolve", item);
    assert!(resolved["documentation"].as_str().unwrap().contains("nA"), "{resolved}");
    let help = session.ask_at("textDocument/signatureHelp", "l_i,2");
    assert!(help["signatures"][0]["documentation"].is_string(), "{help}");
    assert_eq!(session.client.end(), 0);
}

#[test]
fn names_are_renamed() {
    let abilities =
        json!({ "workspace": { "workspaceEdit": { "documentChanges": true, "resourceOperations": ["rename"] } } });
    let mut session = Session::of(CELL, abilities);
    let prepared = session.ask_at("textDocument/prepareRename", "other(nA)");
    assert_eq!(prepared["placeholder"], "other");
    let (line, column) = place(session.cell.text(START), "other(nA)");
    let mut params = at(&session.cell.path(START), line, column);
    params["newName"] = json!("second");
    let edit = session.client.ask("textDocument/rename", params.clone());
    let changes = edit["documentChanges"].as_array().unwrap();
    let of_start = changes.iter().find(|change| change["textDocument"]["uri"] == *uri(&session.cell.path(START)));
    assert_eq!(of_start.unwrap()["textDocument"]["version"], 1);
    let moved = changes.iter().find(|change| change["kind"] == "rename").unwrap();
    assert!(moved["newUri"].as_str().unwrap().ends_with("/main/second.pgx"), "{moved}");
    params["newName"] = json!("1st");
    assert_eq!(session.client.ask_in_vain("textDocument/rename", params), -32803);
    assert_eq!(session.client.end(), 0);
}

#[test]
fn symbols_and_folds_are_returned() {
    let mut session = Session::of(
        CELL,
        json!({ "textDocument": { "documentSymbol": { "hierarchicalDocumentSymbolSupport": true } } }),
    );
    let symbols = session.ask("textDocument/documentSymbol");
    assert!(symbols.to_string().contains("\"name\":\"start\""), "{symbols}");
    let folds = session.ask("textDocument/foldingRange");
    assert!(folds.as_array().unwrap().iter().any(|fold| fold["kind"] == "comment"), "{folds}");
    let (line, column) = place(session.cell.text(START), "power");
    let params = json!({
        "textDocument": { "uri": uri(&session.cell.path(START)) },
        "positions": [{ "line": line, "character": column }, { "line": 999, "character": 0 }],
    });
    let selections = session.client.ask("textDocument/selectionRange", params);
    assert_eq!(selections.as_array().unwrap().len(), 2);
    assert!(selections[0]["parent"]["parent"].is_object(), "{selections}");
    let found = session.client.ask("workspace/symbol", json!({ "query": "weight" }));
    assert_eq!(found[0]["name"], "nWeight", "{found}");
    assert_eq!(session.client.end(), 0);
}

#[test]
fn values_are_shown_up_to_the_line_of_a_stop() {
    let mut session = Session::of("num nA\nnum nB\nnA=1\nnB=nA+1\nnB=3", json!({}));
    let stop = session.place("nB=nA+1")["position"].take();
    let document = session.place("nA=1")["textDocument"].take();
    let whole = json!({ "start": { "line": 0, "character": 0 }, "end": { "line": 99, "character": 0 } });
    let context = json!({ "frameId": 1, "stoppedLocation": { "start": stop, "end": stop } });
    let params = json!({ "textDocument": document, "range": whole, "context": context });
    let found = session.client.ask("textDocument/inlineValue", params);
    let found = found.as_array().unwrap();
    let shown: Vec<&Value> = found.iter().map(|found| &found["expression"]).collect();
    assert_eq!(shown, ["nB", "nA"]);
    assert!(found.iter().all(|found| found["range"]["start"]["line"] == stop["line"]));
    assert_eq!(session.client.end(), 0);
}

#[test]
fn semantic_tokens_are_returned() {
    let mut session = Session::of(CELL, json!({}));
    let path = session.cell.path(START);
    let full = session.ask("textDocument/semanticTokens/full");
    let before: Vec<u64> = serde_json::from_value(full["data"].clone()).unwrap();
    assert!(!before.is_empty() && before.len().is_multiple_of(5));
    session.client.change(&path, 2, &session.cell.text(START).replace("// two", "// two\n  put(3)"));
    let params = json!({ "textDocument": { "uri": uri(&path) }, "previousResultId": full["resultId"] });
    let delta = session.client.ask("textDocument/semanticTokens/full/delta", params.clone());
    let mut after = before;
    for edit in delta["edits"].as_array().unwrap() {
        let start = usize::try_from(edit["start"].as_u64().unwrap()).unwrap();
        let count = usize::try_from(edit["deleteCount"].as_u64().unwrap()).unwrap();
        let data: Vec<u64> = serde_json::from_value(edit["data"].clone()).unwrap();
        after.splice(start..start + count, data);
    }
    assert_eq!(session.ask("textDocument/semanticTokens/full")["data"], json!(after));
    // No difference is available for an outdated result, so the response contains all tokens.
    let whole = session.client.ask("textDocument/semanticTokens/full/delta", params);
    assert_eq!(whole["data"], json!(after));
    let range = json!({ "start": { "line": 0, "character": 0 }, "end": { "line": 2, "character": 0 } });
    let part = session
        .client
        .ask("textDocument/semanticTokens/range", json!({ "textDocument": { "uri": uri(&path) }, "range": range }));
    assert!(part["data"].as_array().unwrap().len() < after.len());
    assert_eq!(session.client.end(), 0);
}

#[test]
fn documents_are_formatted() {
    let mut session = Session::of(CELL, json!({}));
    let path = session.cell.path(START);
    let unformatted = session.cell.text(START).replace("  for l_i", "      FOR l_i");
    session.client.change(&path, 2, &unformatted);
    let options = json!({ "tabSize": 2, "insertSpaces": true });
    let params = json!({ "textDocument": { "uri": uri(&path) }, "options": options });
    let edits = session.client.ask("textDocument/formatting", params);
    assert!(!edits.as_array().unwrap().is_empty());
    let (line, _) = place(&unformatted, "FOR");
    let range = json!({ "start": { "line": line, "character": 0 }, "end": { "line": line, "character": 99 } });
    let params = json!({ "textDocument": { "uri": uri(&path) }, "range": range, "options": options });
    assert_eq!(session.client.ask("textDocument/rangeFormatting", params), edits);
    let mut params = at(&path, line + 1, 0);
    params["ch"] = json!("\n");
    params["options"] = options;
    // The completed line, and the indentation of the new line.
    let typed = session.client.ask("textDocument/onTypeFormatting", params);
    assert_eq!(each(&typed, "newText"), ["for", "        "]);
    assert_eq!(session.client.end(), 0);
}

#[test]
fn editor_options_do_not_change_the_layout() {
    let mut session = Session::of(CELL, json!({}));
    session.cell.write("usrapp/.editorconfig", "root=true\n[*.pgx]\nindent_style=tab\n");
    let options = json!({ "tabSize": 8, "insertSpaces": true });
    let params = json!({ "textDocument": { "uri": uri(&session.cell.path(START)) }, "options": options });
    let edits = session.client.ask("textDocument/formatting", params.clone());
    assert!(!edits.as_array().unwrap().is_empty());
    assert!(each(&edits, "newText").iter().all(|text| text.ends_with('\t')), "{edits}");
    session.cell.write("val3.toml", "[format]\nindent-style = \"space\"\nindent-size = 2\n");
    let changed = json!({ "uri": uri(&session.cell.path("val3.toml")), "type": 1 });
    session.client.notify("workspace/didChangeWatchedFiles", json!({ "changes": [changed] }));
    assert_eq!(session.client.ask("textDocument/formatting", params), json!([]));
    assert_eq!(session.client.end(), 0);
}

#[test]
fn the_code_without_xml_is_returned() {
    let mut session = Session::of(CELL, json!({}));
    let path = session.cell.path(START);
    let address = uri(&path).replace("file:", "val-text:");
    let before = code_view(&mut session.client, &address);
    assert!(before.starts_with("begin\n") && before.ends_with("\nend"), "{before}");
    // The client is notified once when the code changes, and never for other changes.
    let file = session.cell.text(START).to_owned();
    let edited = file.replace("begin\n", "begin\n  // first\n");
    session.client.change(&path, 2, &edited);
    let told = session.client.told("workspace/textDocumentContent/refresh");
    assert_eq!(told["params"]["uri"], address);
    assert_eq!(code_view(&mut session.client, &address), before.replace("begin\n", "begin\n  // first\n"));
    session.client.change(&path, 3, &edited.replace("<Code>", "<Locals />\n<Code>"));
    assert_eq!(session.client.try_told("workspace/textDocumentContent/refresh"), None);
    for (wrong, reason) in [
        (uri(&path), "the scheme of code without XML is `val-text`"),
        (address.replace("start", "missing"), "no file of the workspace has this path"),
        (address.replace("start.pgx", "main.dtx"), "the file has no element `<Code>`"),
    ] {
        let id = session.client.request("workspace/textDocumentContent", json!({ "uri": wrong }));
        let answer = session.client.answer(id);
        assert_eq!(answer["error"]["code"], -32803);
        assert!(answer["error"]["message"].as_str().unwrap().ends_with(reason), "{answer}");
    }
    assert_eq!(session.client.end(), 0);
}

fn code_view(client: &mut Client, address: &str) -> String {
    let content = client.ask("workspace/textDocumentContent", json!({ "uri": address }));
    content["text"].as_str().unwrap().to_owned()
}

#[test]
fn the_workspace_tree_and_pages_are_returned() {
    let mut session = Session::of(CELL, json!({}));
    let tree = session.client.ask("val3/workspaceTree", Value::Null);
    let projects = tree.as_array().unwrap();
    assert_eq!(projects.iter().map(|project| &project["name"]).collect::<Vec<_>>(), ["main", "part"]);
    assert_eq!(each(&projects[0]["programs"], "name"), ["other", "start", "stop"]);
    assert_eq!(each(&projects[0]["data"], "name"), ["pA", "nA"]);
    assert_eq!(each(&projects[0]["libraries"], "name"), ["part"]);
    assert_eq!(projects.iter().map(|project| &project["kind"]).collect::<Vec<_>>(), ["application", "library"]);
    assert_eq!(projects[0]["libraries"][0]["project"], projects[1]["uri"]);
    let count = find(&projects[0]["data"], "name", "nA");
    assert_eq!(
        json!([count["type"], count["value"], count["public"], count["sizes"]]),
        json!(["num", "0", false, [1]])
    );
    let other = find(&projects[0]["programs"], "name", "other");
    assert_eq!(json!([other["public"], other["runs"]]), json!([false, false]));
    assert!(other["range"]["end"]["line"].as_u64() > other["location"]["range"]["end"]["line"].as_u64(), "{other}");
    let page = session.client.ask("val3/page", json!({ "topic": "v0203" }));
    assert_eq!(page["title"], "V0203");
    assert!(page["markdown"].as_str().unwrap().starts_with("# "), "{page}");
    assert_eq!(session.client.ask("val3/page", json!({ "topic": "nothing" })), Value::Null);
    assert_eq!(session.client.end(), 0);
}
