//! Accepted completions: with and without snippets and Markdown, and declarations in other files.

use serde_json::{Value, json};

use crate::client::{Client, at, uri};
use crate::open_session::{START, Session, each, find};

const CELL: &str = "num nA\nnA=power(nA,1)\nnNewOne=1";

fn able(item: Value) -> Value {
    let completion = json!({ "completionItem": item });
    json!({ "textDocument": { "completion": completion }, "workspace": { "applyEdit": true } })
}

#[test]
fn completions_suit_clients_without_snippets() {
    let mut session = Session::of(CELL, able(json!({ "snippetSupport": true })));
    let item = find(&session.ask_at("textDocument/completion", "nA=power")["items"], "label", "for");
    assert_eq!(item["insertTextFormat"], 2);
    assert!(item["textEdit"]["newText"].as_str().unwrap().contains("$0"), "{item}");
    assert_eq!(session.client.end(), 0);
    let mut session = Session::of(CELL, json!({}));
    let item = find(&session.ask_at("textDocument/completion", "nA=power")["items"], "label", "for");
    assert_eq!((&item["insertTextFormat"], &item["textEdit"]["newText"]), (&json!(1), &json!("for")));
    assert_eq!(session.client.end(), 0);
}

#[test]
fn what_can_follow_a_name_takes_it() {
    let listing = "point pA\nnum nA\nnum nList[3]\nnA=power(nA,1)";
    let mut session = Session::of(listing, able(json!({ "commitCharactersSupport": true })));
    let items = session.ask_at("textDocument/completion", "nA=power")["items"].clone();
    let characters = |label: &str| find(&items, "label", label)["commitCharacters"].clone();
    assert_eq!(characters("pA"), json!(["."]));
    assert_eq!(characters("nList"), json!(["["]));
    // A name, and a call that inserts its parentheses.
    assert_eq!(characters("nA"), Value::Null);
    assert_eq!(characters("movej"), Value::Null);
    assert_eq!(session.client.end(), 0);
    let mut session = Session::of(listing, able(json!({})));
    let items = session.ask_at("textDocument/completion", "nA=power")["items"].clone();
    assert_eq!(find(&items, "label", "pA")["commitCharacters"], Value::Null);
    assert_eq!(session.client.end(), 0);
}

#[test]
fn completions_have_documentation() {
    for (formats, kind) in [(json!(["markdown", "plaintext"]), "markdown"), (json!(["plaintext"]), "plaintext")] {
        let mut session = Session::of(CELL, able(json!({ "documentationFormat": formats })));
        let items = session.ask_at("textDocument/completion", "nA=power")["items"].clone();
        for label in ["for", "nA"] {
            let resolved = session.client.ask("completionItem/resolve", find(&items, "label", label));
            let text = resolved["documentation"]["value"].as_str().unwrap_or("");
            assert!(text.contains(label), "{label}: {resolved}");
            assert_eq!(resolved["documentation"]["kind"], kind);
            assert_eq!(text.contains("```"), kind == "markdown", "{text}");
        }
        assert_eq!(session.client.end(), 0);
    }
}

#[test]
fn hovers_suit_clients_without_markdown() {
    let mut session = Session::of(CELL, json!({ "textDocument": { "hover": { "contentFormat": ["plaintext"] } } }));
    let hover = session.ask_at("textDocument/hover", "nA=power");
    assert_eq!(hover["contents"]["kind"], "plaintext");
    assert!(!hover["contents"]["value"].as_str().unwrap().contains('`'), "{hover}");
    assert_eq!(session.client.end(), 0);
}

#[test]
fn a_completion_can_declare_in_another_file() {
    let mut session = Session::of(CELL, able(json!({})));
    let mut place = session.place("nNewOne=1");
    place["position"]["character"] = json!(place["position"]["character"].as_u64().unwrap() + 7);
    let items = session.client.ask("textDocument/completion", place.clone())["items"].clone();
    let item = find(&items, "label", "nNewOne");
    assert_eq!(item["additionalTextEdits"], Value::Null);
    let params = json!({ "command": item["command"]["command"], "arguments": item["command"]["arguments"] });
    session.client.ask("workspace/executeCommand", params);
    let asked = session.client.told("workspace/applyEdit");
    let edits = &asked["params"]["edit"]["changes"][&uri(&session.cell.path("usrapp/main/main.dtx"))];
    assert!(each(edits, "newText")[0].contains("nNewOne"), "{asked}");
    assert_eq!(session.client.end(), 0);
    // A client that does not apply edits of the server gets no completion that requires a declaration in another file.
    let mut session = Session::of(CELL, json!({}));
    place["textDocument"] = session.place("nA")["textDocument"].clone();
    let items = session.client.ask("textDocument/completion", place)["items"].clone();
    assert!(!each(&items, "label").contains(&"nNewOne"), "{items}");
    assert_eq!(session.client.end(), 0);
}

#[test]
fn elements_and_attributes_are_completed() {
    let mut session = Session::of(CELL, able(json!({ "snippetSupport": true, "documentationFormat": ["markdown"] })));
    let local = "<Locals>\n      <Local name=\"l_n\" ";
    let program = session.cell.text(START).replacen("<Code>", &format!("{local}\n    </Locals>\n    <Code>"), 1);
    session.client.change(&session.cell.path(START), 2, &program);
    let (line, column) = crate::cell::place(&program, "<Local name=\"l_n\" ");
    let mut place = at(&session.cell.path(START), line, column + 18);
    place["context"] = json!({ "triggerKind": 2, "triggerCharacter": " " });
    let items = session.client.ask("textDocument/completion", place.clone())["items"].clone();
    let ty = find(&items, "label", "type");
    assert_eq!((&ty["insertTextFormat"], &ty["textEdit"]["newText"]), (&json!(2), &json!("type=\"${1:type}\"")));
    let resolved = session.client.ask("completionItem/resolve", ty);
    assert!(resolved["documentation"]["value"].as_str().unwrap().contains("built-in type"), "{resolved}");
    // A space in code ends a word.
    let (line, column) = crate::cell::place(&program, "nA=power");
    let mut code = at(&session.cell.path(START), line, column);
    code["context"] = place["context"].clone();
    assert_eq!(session.client.ask("textDocument/completion", code.clone()), Value::Null);
    code["context"] = json!({ "triggerKind": 1 });
    assert_ne!(session.client.ask("textDocument/completion", code), Value::Null);
    assert_eq!(session.client.end(), 0);
}

#[test]
fn a_completion_can_declare_a_library() {
    let mut session = Session::of("num nA\nnA=nWei\n--- part\npublic num nWeight", able(json!({})));
    let mut place = session.place("nA=nWei");
    place["position"]["character"] = json!(place["position"]["character"].as_u64().unwrap() + 7);
    let items = session.client.ask("textDocument/completion", place)["items"].clone();
    let item = find(&items, "label", "part:nWeight");
    assert_eq!(item["textEdit"]["newText"], "part:nWeight");
    let params = json!({ "command": item["command"]["command"], "arguments": item["command"]["arguments"] });
    session.client.ask("workspace/executeCommand", params);
    let asked = session.client.told("workspace/applyEdit");
    let edits = &asked["params"]["edit"]["changes"][&uri(&session.cell.path("usrapp/main/main.pjx"))];
    assert!(each(edits, "newText")[0].contains("<Library alias=\"part\" path=\"Disk://part/part.pjx\" />"), "{asked}");
    assert_eq!(session.client.end(), 0);
}

#[test]
fn trigger_characters_are_announced() {
    let mut client = Client::fresh();
    let capabilities = client.ask("initialize", json!({ "capabilities": {} }))["capabilities"].clone();
    client.notify("initialized", json!({}));
    assert_eq!(client.end(), 0);
    let triggers = &capabilities["completionProvider"]["triggerCharacters"];
    for wanted in ["<", "\"", " ", "[", "{"] {
        assert!(triggers.as_array().unwrap().contains(&json!(wanted)), "{wanted}: {triggers}");
    }
    let triggers = &capabilities["signatureHelpProvider"]["triggerCharacters"];
    for wanted in ["(", ",", "{", "["] {
        assert!(triggers.as_array().unwrap().contains(&json!(wanted)), "{wanted}: {triggers}");
    }
    let mut session = Session::of("trsf trA\ntrA={1,2}", json!({}));
    let help = session.ask_at("textDocument/signatureHelp", "2}");
    assert_eq!(
        (&help["signatures"][0]["label"], &help["activeParameter"]),
        (&json!("trsf {num x, num y, num z, num rx, num ry, num rz}"), &json!(1))
    );
    assert_eq!(session.client.end(), 0);
}
