//! Sessions from the first message to the last.

use std::time::{Duration, Instant};

use serde_json::{Value, json};

use crate::cell::{Cell, place};
use crate::client::{Client, at, uri};
use crate::codes;

const CELL: &str = "num nCount\nnCount=nCuont+1";

#[test]
fn a_session_has_findings_and_hover() {
    let cell = Cell::new(CELL);
    let mut client = Client::start(&[&cell.folder()]);
    let start = cell.path("usrapp/main/start.pgx");
    assert_eq!(codes(&client.findings(&start, None)), ["V0101"]);
    let text = cell.text("usrapp/main/start.pgx");
    client.open(&start, text);
    assert_eq!(codes(&client.findings(&start, Some(1))), ["V0101"]);
    let (line, column) = place(text, "nCount=");
    let hover = client.ask("textDocument/hover", at(&start, line, column));
    assert!(hover["contents"]["value"].as_str().unwrap().contains("num nCount"), "{hover}");
    client.change(&start, 2, &text.replace("nCuont", "nCount"));
    assert_eq!(client.findings(&start, Some(2)), Vec::<Value>::new());
    assert_eq!(client.end(), 0);
}

#[test]
fn capabilities_are_announced() {
    let mut client = Client::fresh();
    let answer = client.ask("initialize", json!({ "capabilities": {} }));
    let capabilities = &answer["capabilities"];
    // The types of lsp-types have no field for this capability.
    assert_eq!(capabilities["typeHierarchyProvider"], true);
    assert_eq!(capabilities["executeCommandProvider"]["commands"], json!(["val3.applyEdit", "val3.tests"]));
    assert_eq!(capabilities["workspace"]["textDocumentContent"]["schemes"], json!(["val-text"]));
    let files = &capabilities["workspace"]["fileOperations"];
    assert_eq!(files["willRename"]["filters"][0]["pattern"]["glob"], "**/*.{pgx,dtx,pjx}");
    assert_eq!(files["willRename"]["filters"][1]["pattern"]["matches"], "folder");
    let kinds = capabilities["codeActionProvider"]["codeActionKinds"].as_array().unwrap();
    assert!(kinds.contains(&json!("source.fixAll")), "{kinds:?}");
    assert_eq!(client.end(), 0);
}

#[test]
fn changed_settings_are_registered_for() {
    let registers = json!({ "workspace": { "didChangeConfiguration": { "dynamicRegistration": true } } });
    let mut client = Client::start_with(&[], registers, Value::Null);
    let asked = client.told("client/registerCapability");
    let registration = &asked["params"]["registrations"][0];
    assert_eq!(registration["method"], "workspace/didChangeConfiguration");
    assert_eq!(registration["registerOptions"], json!({ "section": "val3" }));
    assert_eq!(client.end(), 0);
}

#[test]
fn the_exit_code_says_whether_the_session_was_shut_down() {
    let mut client = Client::start(&[]);
    client.notify("exit", Value::Null);
    let started = Instant::now();
    // The input is still open.
    assert_eq!(client.exit_code(), 1);
    assert!(started.elapsed() < Duration::from_secs(5));
    assert_eq!(Client::start(&[]).end(), 0);
}

#[test]
fn the_end_of_the_input_ends_the_server() {
    let mut client = Client::start(&[]);
    client.hang_up();
    assert_eq!(client.exit_code(), 1);
    let mut client = Client::fresh();
    client.hang_up();
    assert_eq!(client.exit_code(), 1);
}

#[test]
fn requests_before_initialize_and_after_shutdown_are_refused() {
    let mut client = Client::fresh();
    client.open("/a/b.pgx", "");
    assert_eq!(client.ask_in_vain("textDocument/hover", at("/a/b.pgx", 0, 0)), -32002);
    assert_eq!(client.ask_in_vain("shutdown", Value::Null), -32002);
    client.ask("initialize", json!({ "capabilities": {} }));
    assert_eq!(client.ask_in_vain("initialize", json!({ "capabilities": {} })), -32600);
    assert_eq!(client.ask_in_vain("val3/nothing", json!({})), -32601);
    assert_eq!(client.ask_in_vain("textDocument/hover", json!({ "position": 3 })), -32602);
    // Many clients send `null` parameters.
    client.send(&json!({ "jsonrpc": "2.0", "id": "down", "method": "shutdown", "params": null }));
    let down = client.wait_for("an answer", |message| message["id"] == "down");
    assert_eq!(down, json!({ "jsonrpc": "2.0", "id": "down", "result": null }));
    assert_eq!(client.ask_in_vain("textDocument/hover", at("/a/b.pgx", 0, 0)), -32600);
    client.notify("exit", Value::Null);
    assert_eq!(client.exit_code(), 0);
}

#[test]
fn parameters_of_shutdown_make_no_difference() {
    for params in [json!({}), json!([]), json!(null), json!({ "a": 1 })] {
        let mut client = Client::start(&[]);
        client.send(&json!({ "jsonrpc": "2.0", "id": "down", "method": "shutdown", "params": params }));
        let down = client.wait_for("an answer", |message| message["id"] == "down");
        assert_eq!(down, json!({ "jsonrpc": "2.0", "id": "down", "result": null }));
        client.notify("exit", Value::Null);
        assert_eq!(client.exit_code(), 0);
    }
}

#[test]
fn a_length_that_is_no_number_ends_the_session() {
    let mut client = Client::start(&[]);
    client.send_bytes(b"Content-Length: abc\r\n\r\n{}");
    let refused = client.wait_for("a refusal", |message| message.get("error").is_some());
    assert_eq!(refused["error"]["code"], -32700, "{refused}");
    assert_eq!(client.exit_code(), 1);
}

#[test]
fn a_closed_output_ends_the_server() {
    let (input, mut to_server) = std::io::pipe().unwrap();
    let (from_server, output) = std::io::pipe().unwrap();
    drop(from_server);
    let server = std::thread::spawn(move || val3_lsp::run(input, output, &val3_lsp::ServerOptions::default()).unwrap());
    let message = json!({ "jsonrpc": "2.0", "id": 0, "method": "initialize", "params": { "capabilities": {} } });
    let message = message.to_string();
    std::io::Write::write_all(&mut to_server, format!("Content-Length: {}\r\n\r\n{message}", message.len()).as_bytes())
        .unwrap();
    // The input is still open.
    assert_eq!(server.join().unwrap(), 1);
    drop(to_server);
}

#[test]
fn garbage_is_refused_and_the_session_continues() {
    let mut client = Client::start(&[]);
    client.send_bytes(b"what is this\r\n\r\n");
    client.send_bytes(b"Content-Length: 5\r\n\r\n{\"a\":");
    client.send_bytes(b"Content-Length: 2\r\n\r\n[]");
    client.send_bytes(b"Content-Length: 4\r\nContent-Type: text/plain; charset=latin1\r\n\r\nnull");
    for code in [-32700, -32700, -32600, -32600] {
        let refused = client.wait_for("a refusal", |message| message.get("error").is_some());
        assert_eq!(refused["error"]["code"], code, "{refused}");
        assert_eq!(refused["id"], Value::Null);
    }
    // A response to no request, and an unknown notification.
    client.send(&json!({ "jsonrpc": "2.0", "id": 99, "result": null }));
    client.notify("$/whatever", json!({}));
    client.notify("val3/whatever", json!([1]));
    assert_eq!(client.ask("textDocument/hover", at("/a/b.pgx", 0, 0)), Value::Null);
    assert_eq!(client.end(), 0);
}

#[test]
fn a_message_that_is_too_large_ends_the_session() {
    let mut client = Client::start(&[]);
    client.send_bytes(b"Content-Length: 99999999999999\r\n\r\n");
    assert_eq!(client.exit_code(), 1);
    let mut client = Client::fresh();
    client.send_bytes(&[b'x'; 20_000]);
    assert_eq!(client.exit_code(), 1);
}

#[test]
fn documents_without_a_project_have_findings() {
    let cell = Cell::new("call anything()\nnSomething=1+\"a\"");
    let text = cell.text("usrapp/main/start.pgx").to_owned();
    let mut client = Client::start_with(&[], json!({}), json!({ "commands": ["val3.run", "val3.debug"] }));
    client.open("untitled:Untitled-1", &text);
    // A string is added to a number; the names may be declared elsewhere.
    let untitled = client.findings("untitled:Untitled-1", Some(1));
    assert!(!codes(&untitled).iter().any(|code| code.starts_with("V01")), "{untitled:?}");
    assert!(codes(&untitled).iter().any(|code| code.starts_with("V02")), "{untitled:?}");
    let folder = tempfile::tempdir().unwrap();
    let loose = folder.path().canonicalize().unwrap().join("loose.pgx").to_str().unwrap().to_owned();
    client.open(&loose, &text);
    assert_eq!(codes(&client.findings(&loose, Some(1))), codes(&untitled));
    let (line, column) = place(&text, "call");
    let hover = client.ask("textDocument/hover", at(&loose, line, column));
    assert!(hover["contents"]["value"].as_str().unwrap().contains("call"), "{hover}");
    // No definition resolves to the generated project file, which does not exist on the disk.
    let (line, column) = place(&text, "start");
    let mut start = at(&loose, line, column);
    start["context"] = json!({ "includeDeclaration": true });
    for method in ["textDocument/declaration", "textDocument/references", "textDocument/documentLink"] {
        let answer = client.ask(method, start.clone()).to_string();
        assert!(!answer.contains("loose.pjx"), "{method}: {answer}");
    }
    let symbols = client.ask("workspace/symbol", json!({ "query": "loose" }));
    assert_eq!(symbols, json!([]));
    assert_eq!(client.ask("textDocument/codeLens", start).as_array().map(Vec::len), Some(1));
    client.notify("textDocument/didClose", json!({ "textDocument": { "uri": uri(&loose) } }));
    assert_eq!(client.findings(&loose, None), Vec::<Value>::new());
    assert_eq!(client.end(), 0);
}

#[test]
fn tracing_can_be_switched_on() {
    let mut client = Client::start(&[]);
    client.notify("$/setTrace", json!({ "value": "messages" }));
    client.ask("textDocument/hover", at("/a/b.pgx", 0, 0));
    let told = client.told("$/logTrace");
    assert!(told["params"]["message"].as_str().unwrap().contains("textDocument/hover"), "{told}");
    assert_eq!(client.end(), 0);
}

#[test]
fn an_outdated_version_changes_nothing() {
    let cell = Cell::new("num nA\nnA=1\nput(nA)");
    let start = cell.path("usrapp/main/start.pgx");
    let mut client = Client::start(&[&cell.folder()]);
    client.open(&start, cell.text("usrapp/main/start.pgx"));
    client.change(&start, 1, "");
    let symbols = client.ask("textDocument/documentSymbol", json!({ "textDocument": { "uri": uri(&start) } }));
    assert!(!symbols.as_array().unwrap().is_empty());
    assert_eq!(client.end(), 0);
}

#[test]
fn the_server_runs_if_the_client_process_is_invisible() {
    // A process that has already ended looks like an invisible process, so the server does not watch it.
    let mut gone = std::process::Command::new("true").spawn().unwrap();
    let process = gone.id();
    gone.wait().unwrap();
    let mut client = Client::fresh();
    client.ask("initialize", json!({ "processId": process, "capabilities": {} }));
    assert_eq!(client.end(), 0);
}
