//! Known defects of servers that are built on tower-lsp in the usual way. Each test first shows the defect in a usual
//! server (`naive`), then its absence in this server.

mod naive;
mod probes;
mod surplus;

use std::time::{Duration, Instant};

use serde_json::{Value, json};

use crate::client::{Client, at, uri};
use probes::probed;

const PATH: &str = "/nowhere/a.pgx";

fn ours() -> Client {
    Client::of(probed).begin(&[], json!({}), Value::Null)
}

fn naive() -> Client {
    Client::of(naive::serve).begin(&[], json!({}), Value::Null)
}

fn spin(client: &mut Client) -> i64 {
    let id = client.request("test/spin", json!({}));
    client.told("test/spinning");
    id
}

/// Sends edits, each followed by a request. Returns the requested and the returned versions, without rejected requests.
fn versions_seen(client: &mut Client, edits: i64) -> Vec<(i64, i64)> {
    client.open(PATH, "");
    let asked: Vec<(i64, i64)> = (2..2 + edits)
        .map(|version| {
            client.change(PATH, version, &format!("// {version}"));
            (version, client.request("test/version", json!({ "uri": uri(PATH) })))
        })
        .collect();
    let answers = asked.into_iter().map(|(version, id)| (version, client.answer(id)));
    let answered = answers.filter(|(_, answer)| {
        assert!(answer.get("result").is_some() || answer["error"]["code"] == -32801, "{answer}");
        answer.get("result").is_some()
    });
    answered.map(|(version, answer)| (version, answer["result"].as_i64().unwrap_or(0))).collect()
}

#[test]
fn edits_and_requests_keep_their_order() {
    let overtaken = versions_seen(&mut naive(), 300).iter().any(|(asked, seen)| asked != seen);
    assert!(overtaken, "the usual server keeps the order as well: the test shows nothing");
    let seen = versions_seen(&mut ours(), 500);
    assert!(!seen.is_empty());
    assert!(seen.iter().all(|(asked, seen)| asked == seen), "{seen:?}");
}

#[test]
fn a_panic_ends_one_request() {
    let mut client = naive();
    client.request("test/panic", json!({}));
    let ended = (0..100).any(|_| {
        std::thread::sleep(Duration::from_millis(20));
        client.has_ended()
    });
    assert!(ended, "the usual server survives as well: the test shows nothing");

    let mut client = ours();
    let id = client.request("test/panic", json!({}));
    let answer = client.answer(id);
    assert_eq!(answer["error"]["code"], -32603, "{answer}");
    let told = client.told("window/showMessage");
    assert!(told["params"]["message"].as_str().unwrap().contains("test/panic"), "{told}");
    client.notify("test/panicNow", json!({}));
    client.told("window/showMessage");
    assert_eq!(client.ask("textDocument/hover", at(PATH, 0, 0)), Value::Null);
    assert_eq!(client.end(), 0);
}

#[test]
fn a_request_can_be_cancelled_while_it_computes() {
    let mut client = naive();
    let id = client.request("test/busy", json!({}));
    client.notify("$/cancelRequest", json!({ "id": id }));
    // The notification was read after the request had ended.
    assert!(client.answer(id).get("result").is_some(), "the usual server cancels as well: the test shows nothing");

    let mut client = ours();
    let id = spin(&mut client);
    let started = Instant::now();
    client.notify("$/cancelRequest", json!({ "id": id }));
    assert_eq!(client.answer(id)["error"]["code"], -32800);
    assert!(started.elapsed() < Duration::from_secs(1));
    // The computation has ended too, otherwise a write would wait forever.
    client.open(PATH, "");
    assert_eq!(client.ask("test/version", json!({ "uri": uri(PATH) })), 1);
    assert_eq!(client.end(), 0);
}

#[test]
fn a_queued_request_can_be_cancelled() {
    let mut client = ours();
    let spinning: Vec<i64> = (0..40).map(|_| client.request("test/spin", json!({}))).collect();
    client.told("test/spinning");
    for id in spinning.iter().rev() {
        client.notify("$/cancelRequest", json!({ "id": id }));
    }
    for id in spinning {
        assert_eq!(client.answer(id)["error"]["code"], -32800);
    }
    assert_eq!(client.end(), 0);
}

#[test]
fn an_edit_cancels_outdated_requests() {
    let mut client = ours();
    client.open(PATH, "");
    let positional = spin(&mut client);
    let whole = client.request("test/spinUntilEdit", json!({ "uri": uri(PATH), "version": 2 }));
    client.change(PATH, 2, "// new");
    assert_eq!(client.answer(positional)["error"]["code"], -32801);
    // A request about the current document is computed again.
    assert_eq!(client.answer(whole)["result"], 2);
    assert_eq!(client.end(), 0);
}

#[test]
fn exit_ends_the_server_while_the_input_is_open() {
    let mut client = naive();
    client.ask("shutdown", Value::Null);
    client.notify("exit", Value::Null);
    std::thread::sleep(Duration::from_millis(500));
    assert!(!client.has_ended(), "the usual server ends as well: the test shows nothing");

    let mut client = ours();
    client.ask("shutdown", Value::Null);
    let started = Instant::now();
    client.notify("exit", Value::Null);
    assert_eq!(client.exit_code(), 0);
    assert!(started.elapsed() < Duration::from_secs(2));
    // The server also ends while all threads are busy.
    let mut client = ours();
    (0..40).for_each(|_| _ = client.request("test/spin", json!({})));
    client.told("test/spinning");
    client.notify("exit", Value::Null);
    assert_eq!(client.exit_code(), 1);
}

#[test]
fn requests_of_the_server_block_nothing() {
    // Each handler waits for a response that the client never sends. The usual server runs at most four handlers at a
    // time.
    let mut client = naive();
    (0..8).for_each(|_| _ = client.request("test/askClient", json!({})));
    let id = client.request("test/version", json!({ "uri": uri(PATH) }));
    std::thread::sleep(Duration::from_millis(500));
    let answered = client.passed().any(|message| message["id"] == id && message.get("method").is_none());
    assert!(!answered, "the usual server answers as well: the test shows nothing");

    let mut client = ours();
    (0..1_500).for_each(|_| client.notify("test/askClient", json!({})));
    assert_eq!(client.ask("textDocument/hover", at(PATH, 0, 0)), Value::Null);
    assert_eq!(client.end(), 0);
}

#[test]
fn a_client_that_does_not_read_blocks_nothing() {
    // Far more than a pipe holds, in both directions. The usual server stops reading when its output is full, so that
    // the client would block forever. The test does not show it, because it would hang itself.
    let (input, mut to_server) = std::io::pipe().unwrap();
    let (from_server, output) = std::io::pipe().unwrap();
    let server = std::thread::spawn(move || probed(input, output));
    let mut write = |message: &Value| write_message(&mut to_server, message);
    write(&json!({ "jsonrpc": "2.0", "id": 0, "method": "initialize", "params": { "capabilities": {} } }));
    for id in 1..4_000 {
        let params = json!({ "textDocument": { "uri": format!("file:///{}", "x".repeat(200)) }, "position": { "line": 0, "character": 0 } });
        write(&json!({ "jsonrpc": "2.0", "id": id, "method": "test/echo", "params": params }));
    }
    write(&json!({ "jsonrpc": "2.0", "method": "exit" }));
    assert_eq!(server.join().unwrap(), 1);
    drop(from_server);
}

fn write_message(output: &mut impl std::io::Write, message: &Value) {
    let text = message.to_string();
    output.write_all(format!("Content-Length: {}\r\n\r\n{text}", text.len()).as_bytes()).unwrap();
}
