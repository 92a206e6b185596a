//! Completions that are taken: snippets or not, Markdown or not, and declarations in other files.

use serde_json::{Value, json};

use crate::asking::{Session, each, find};
use crate::client::uri;

const CELL: &str = "num nA\nnA=power(nA,1)\nnNewOne=1";

fn able(item: Value) -> Value {
    let completion = json!({ "completionItem": item });
    json!({ "textDocument": { "completion": completion }, "workspace": { "applyEdit": true } })
}

#[test]
fn with_and_without_snippets() {
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
fn documentation() {
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
fn hovers_for_clients_without_markdown() {
    let mut session = Session::of(CELL, json!({ "textDocument": { "hover": { "contentFormat": ["plaintext"] } } }));
    let hover = session.ask_at("textDocument/hover", "nA=power");
    assert_eq!(hover["contents"]["kind"], "plaintext");
    assert!(!hover["contents"]["value"].as_str().unwrap().contains('`'), "{hover}");
    assert_eq!(session.client.end(), 0);
}

#[test]
fn a_declaration_in_another_file() {
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
    // Whoever makes no edits for the server is not offered what would be declared nowhere.
    let mut session = Session::of(CELL, json!({}));
    place["textDocument"] = session.place("nA")["textDocument"].clone();
    let items = session.client.ask("textDocument/completion", place)["items"].clone();
    assert!(!each(&items, "label").contains(&"nNewOne"), "{items}");
    assert_eq!(session.client.end(), 0);
}
