//! Edit of a cell in a table of 10,000 points, as from an editor: `cargo build --profile dist -p val3 && cargo
//! bench --profile dist --bench data`.
//!
//! Target: the edit, its text and the changed rows need less than 100 ms together.

#![allow(clippy::expect_used, clippy::indexing_slicing, reason = "a session that fails measures nothing")]
#![allow(clippy::disallowed_methods, reason = "it measures the time of a process")]

use std::fmt::Write as _;
use std::io::{BufRead, BufReader, Read, Write};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};
use std::time::{Duration, Instant};

use serde_json::{Value, json};
use val3_test::Fixture;

const POINTS: usize = 10_000;

const DATA: &str = "usrapp/main/main.dtx";

/// Number of edited cells, of which the slowest counts.
const EDITS: i64 = 10;

/// A client of `val3 lsp`.
struct Client {
    server: Child,
    input: ChildStdin,
    output: BufReader<ChildStdout>,
    id: i64,
}

impl Client {
    fn start(root: &str) -> Self {
        // Benches are in a folder next to the profile's binaries.
        let mut binary = std::env::current_exe().expect("the bench has a path");
        binary.pop();
        binary.pop();
        let mut command = Command::new(binary.join("val3"));
        let started = command.arg("lsp").stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::null()).spawn();
        let mut server = started.expect("build it first: cargo build --profile dist -p val3");
        let input = server.stdin.take().expect("a pipe");
        let output = BufReader::new(server.stdout.take().expect("a pipe"));
        let mut client = Self { server, input, output, id: 0 };
        let capabilities = json!({ "workspace": { "workspaceEdit": { "documentChanges": true } } });
        client.ask("initialize", &json!({ "processId": null, "rootUri": root, "capabilities": capabilities }));
        client.send(&json!({ "method": "initialized", "params": {} }));
        client
    }

    fn send(&mut self, message: &Value) {
        let mut message = message.clone();
        message["jsonrpc"] = json!("2.0");
        let body = message.to_string();
        write!(self.input, "Content-Length: {}\r\n\r\n{body}", body.len()).expect("the server reads");
        self.input.flush().expect("the server reads");
    }

    fn message(&mut self) -> Value {
        let mut length = 0;
        loop {
            let mut line = String::new();
            self.output.read_line(&mut line).expect("the server writes");
            match line.trim().strip_prefix("Content-Length: ") {
                Some(number) => length = number.parse().expect("a number"),
                None => break,
            }
        }
        let mut body = vec![0; length];
        self.output.read_exact(&mut body).expect("the server writes");
        serde_json::from_slice(&body).expect("a message")
    }

    fn ask(&mut self, method: &str, params: &Value) -> Value {
        self.id += 1;
        self.send(&json!({ "id": self.id, "method": method, "params": params }));
        loop {
            let mut message = self.message();
            if message["id"] == self.id && message["method"].is_null() {
                assert!(message["error"].is_null(), "{message}");
                return message["result"].take();
            }
            if !message["id"].is_null() {
                self.send(&json!({ "id": message["id"], "result": null }));
            }
        }
    }
}

impl Drop for Client {
    fn drop(&mut self) {
        // The process ends with the bench.
        let _ = self.server.kill();
        let _ = self.server.wait();
    }
}

/// Returns a listing with points that no program uses, points that programs use, or an array of points.
fn listing(kind: &str) -> String {
    let mut listing = "mdesc mNom\n".to_owned();
    let mut code = String::new();
    match kind {
        "array" => {
            _ = writeln!(listing, "point pMany[{POINTS}]");
            code += "movej(pMany[1],flange,mNom)\n";
        }
        _ => (0..POINTS).for_each(|number| {
            _ = writeln!(listing, "point pMany{number}");
            if kind == "used" {
                _ = writeln!(code, "movej(pMany{number},flange,mNom)");
            }
        }),
    }
    listing + &code
}

fn main() {
    for kind in ["unused", "used", "array"] {
        let slowest = slowest(kind);
        println!("{kind:6} {:>5.1} ms", slowest.as_secs_f64() * 1e3);
    }
}

/// Returns the longest time from an edit of a cell to its new row.
fn slowest(kind: &str) -> Duration {
    let folder = tempfile::tempdir().expect("a folder");
    for (path, text) in Fixture::parse(&listing(kind)).files {
        let path = folder.path().join(path);
        std::fs::create_dir_all(path.parent().expect("a file lies in a folder")).expect("a folder");
        std::fs::write(path, text).expect("a file");
    }
    let uri = |path: &str| format!("file://{}", folder.path().join(path).display());
    let mut client = Client::start(&uri(""));
    let text = std::fs::read_to_string(folder.path().join(DATA)).expect("the data");
    let uri = uri(DATA);
    let document = json!({ "uri": uri, "languageId": "val3-data", "version": 0, "text": text });
    client.send(&json!({ "method": "textDocument/didOpen", "params": { "textDocument": document } }));
    let mut result = client.ask("val3/data", &json!({ "uri": uri }))["resultId"].take();
    let place = match kind {
        "array" => json!({ "name": "pMany", "key": "5000" }),
        _ => json!({ "name": "pMany5000", "key": "0" }),
    };
    let times = (0..EDITS).map(|version| {
        let started = Instant::now();
        let cell = json!({ "place": place, "column": "x", "text": (version + 1).to_string() });
        let edits = json!([{ "kind": "set", "cells": [cell] }]);
        let params = json!({ "uri": uri, "version": version, "edits": edits });
        let answer = client.ask("val3/editData", &params);
        let edit = answer["edit"]["documentChanges"][0]["edits"].clone();
        assert!(edit.is_array(), "{answer}");
        let edits = edit.as_array().into_iter().flatten().rev();
        let changes: Vec<Value> =
            edits.map(|edit| json!({ "range": edit["range"], "text": edit["newText"] })).collect();
        let document = json!({ "uri": uri, "version": version + 1 });
        let params = json!({ "textDocument": document, "contentChanges": changes });
        client.send(&json!({ "method": "textDocument/didChange", "params": params }));
        let params = json!({ "uri": uri, "previousResultId": result, "withoutFindings": true });
        let mut changes = client.ask("val3/data", &params);
        assert_eq!(changes["data"]["items"].as_array().map(Vec::len), Some(1), "{changes}");
        // One value of any datum.
        assert_eq!(changes["data"]["items"][0]["values"].as_array().map(Vec::len), Some(1), "{changes}");
        result = changes["resultId"].take();
        let time = started.elapsed();
        // The findings follow.
        let params = json!({ "uri": uri, "previousResultId": result });
        result = client.ask("val3/data", &params)["resultId"].take();
        time
    });
    times.max().expect("some edits")
}
