//! A client over pipes in memory, with messages as plain JSON, so that tests check exactly what an editor receives.

use std::collections::VecDeque;
use std::io::{self, BufRead, BufReader, PipeReader, PipeWriter, Write};
use std::sync::mpsc::{Receiver, channel};
use std::thread::JoinHandle;
use std::time::Duration;

use serde_json::{Value, json};

/// Time limit for a message, sufficient on a busy machine.
pub const TIMEOUT: Duration = Duration::from_secs(30);

/// A client and its server.
pub struct Client {
    to_server: Option<PipeWriter>,
    from_server: Receiver<Value>,
    /// Messages received while waiting for another message.
    passed: VecDeque<Value>,
    next_id: i64,
    server: Option<JoinHandle<u8>>,
}

impl Client {
    /// Starts a server that waits for `initialize`.
    pub fn fresh() -> Self {
        Self::of(|input, output| val3_lsp::run(input, output, &val3_lsp::ServerOptions::default()).unwrap())
    }

    /// Starts the client of any server; `server` returns the exit code.
    pub fn of(server: impl FnOnce(PipeReader, PipeWriter) -> u8 + Send + 'static) -> Self {
        let (server_input, to_server) = io::pipe().unwrap();
        let (from_server, server_output) = io::pipe().unwrap();
        let server = std::thread::spawn(move || server(server_input, server_output));
        Self {
            to_server: Some(to_server),
            from_server: receive(from_server),
            passed: VecDeque::new(),
            next_id: 1,
            server: Some(server),
        }
    }

    /// Starts a server with these folders, initialized by a client with few capabilities.
    pub fn start(folders: &[&str]) -> Self {
        Self::start_with(folders, json!({}), Value::Null)
    }

    /// Like [`start`](Self::start), with these capabilities and options.
    pub fn start_with(folders: &[&str], capabilities: Value, options: Value) -> Self {
        Self::fresh().begin(folders, capabilities, options)
    }

    /// Executes the handshake.
    pub fn begin(mut self, folders: &[&str], capabilities: Value, options: Value) -> Self {
        let client = &mut self;
        let folders: Vec<Value> = folders.iter().map(|folder| json!({ "uri": uri(folder), "name": folder })).collect();
        let answer = client.ask(
            "initialize",
            json!({
                "processId": std::process::id(),
                "rootUri": null,
                "capabilities": capabilities,
                "initializationOptions": options,
                "workspaceFolders": folders,
            }),
        );
        assert!(answer.get("capabilities").is_some(), "{answer}");
        client.notify("initialized", json!({}));
        self
    }

    pub fn notify(&mut self, method: &str, params: Value) {
        self.send(&json!({ "jsonrpc": "2.0", "method": method, "params": params }));
    }

    /// Sends a request and returns its id.
    pub fn request(&mut self, method: &str, params: Value) -> i64 {
        let id = self.next_id;
        self.next_id += 1;
        let mut message = json!({ "jsonrpc": "2.0", "id": id, "method": method });
        if !params.is_null() {
            message["params"] = params;
        }
        self.send(&message);
        id
    }

    /// Complete response to a request.
    pub fn answer(&mut self, id: i64) -> Value {
        self.wait_for("an answer", |message| message.get("id") == Some(&json!(id)) && message.get("method").is_none())
    }

    /// Sends a request and returns its result.
    #[track_caller]
    pub fn ask(&mut self, method: &str, params: Value) -> Value {
        let id = self.request(method, params);
        let answer = self.answer(id);
        assert!(answer.get("error").is_none(), "{method}: {answer}");
        answer["result"].clone()
    }

    /// Sends a request and returns the error code.
    #[track_caller]
    pub fn ask_in_vain(&mut self, method: &str, params: Value) -> i64 {
        let id = self.request(method, params);
        let answer = self.answer(id);
        answer["error"]["code"].as_i64().unwrap_or_else(|| panic!("{method}: {answer}"))
    }

    /// Waits for the server's next request or notification with this method.
    pub fn told(&mut self, method: &str) -> Value {
        self.wait_for(method, |message| message["method"] == method)
    }

    /// Like [`told`](Self::told); `None` if no message arrives within a moment.
    pub fn try_told(&mut self, method: &str) -> Option<Value> {
        let at = |passed: &VecDeque<Value>| passed.iter().position(|message| message["method"] == method);
        while at(&self.passed).is_none() {
            self.passed.push_back(self.from_server.recv_timeout(Duration::from_millis(300)).ok()?);
        }
        at(&self.passed).and_then(|at| self.passed.remove(at))
    }

    /// Next findings in a file, with at least this version.
    pub fn findings(&mut self, path: &str, version: Option<i64>) -> Vec<Value> {
        let uri = uri(path);
        let message = self.wait_for(&format!("findings in {path}"), |message| {
            message["method"] == "textDocument/publishDiagnostics"
                && message["params"]["uri"] == *uri
                && message["params"]["version"].as_i64() >= version
        });
        message["params"]["diagnostics"].as_array().unwrap().clone()
    }

    /// Last findings sent for a version of a file.
    pub fn latest_findings(&mut self, path: &str, version: i64) -> Vec<Value> {
        let mut latest = self.findings(path, Some(version));
        let uri = uri(path);
        loop {
            // Responses keep their order; published diagnostics do not.
            while let Ok(message) = self.from_server.recv_timeout(Duration::from_millis(400)) {
                self.passed.push_back(message);
            }
            let mut passed = self.passed.iter();
            let Some(at) = passed.position(|message| has_findings_of(message, &uri, version)) else { return latest };
            let message = self.passed.remove(at).unwrap();
            latest.clone_from(message["params"]["diagnostics"].as_array().unwrap());
        }
    }

    pub fn open(&mut self, path: &str, text: &str) {
        let language = if path.ends_with("dtx") { "val3-data" } else { "val3" };
        let document = json!({ "uri": uri(path), "languageId": language, "version": 1, "text": text });
        self.notify("textDocument/didOpen", json!({ "textDocument": document }));
    }

    /// Replaces the entire text.
    pub fn change(&mut self, path: &str, version: i64, text: &str) {
        let document = json!({ "uri": uri(path), "version": version });
        self.notify(
            "textDocument/didChange",
            json!({ "textDocument": document, "contentChanges": [{ "text": text }] }),
        );
    }

    /// Ends the session as the protocol requires, and returns the exit code.
    pub fn end(mut self) -> u8 {
        self.ask("shutdown", Value::Null);
        self.notify("exit", Value::Null);
        self.exit_code()
    }

    /// Waits for the end of the server and returns the exit code; the input stays open.
    pub fn exit_code(&mut self) -> u8 {
        self.server.take().unwrap().join().unwrap()
    }

    /// Whether the server has ended.
    pub fn has_ended(&self) -> bool {
        self.server.as_ref().is_none_or(JoinHandle::is_finished)
    }

    /// Closes the input.
    pub fn hang_up(&mut self) {
        self.to_server = None;
    }

    pub fn send(&mut self, message: &Value) {
        let text = message.to_string();
        self.send_bytes(format!("Content-Length: {}\r\n\r\n{text}", text.len()).as_bytes());
    }

    pub fn send_bytes(&mut self, bytes: &[u8]) {
        self.to_server.as_mut().unwrap().write_all(bytes).unwrap();
    }

    pub fn wait_for(&mut self, what: &str, is_meant: impl Fn(&Value) -> bool) -> Value {
        if let Some(at) = self.passed.iter().position(&is_meant) {
            return self.passed.remove(at).unwrap();
        }
        loop {
            let message = self.from_server.recv_timeout(TIMEOUT).unwrap_or_else(|_| panic!("no {what} came"));
            if is_meant(&message) {
                return message;
            }
            self.passed.push_back(message);
        }
    }

    /// Messages that have arrived and were not read yet.
    pub fn passed(&mut self) -> impl Iterator<Item = Value> {
        self.passed.extend(self.from_server.try_iter());
        self.passed.drain(..)
    }
}

fn receive(pipe: PipeReader) -> Receiver<Value> {
    let (sender, receiver) = channel();
    std::thread::spawn(move || {
        let mut input = BufReader::new(pipe);
        while let Some(message) = read(&mut input) {
            if sender.send(message).is_err() {
                return;
            }
        }
    });
    receiver
}

fn read(input: &mut impl BufRead) -> Option<Value> {
    let mut length = 0;
    loop {
        let mut line = String::new();
        if input.read_line(&mut line).ok()? == 0 {
            return None;
        }
        match line.trim().split_once(':') {
            Some(("Content-Length", value)) => length = value.trim().parse().unwrap(),
            Some(_) => {}
            None => break,
        }
    }
    let mut body = vec![0; length];
    input.read_exact(&mut body).ok()?;
    Some(serde_json::from_slice(&body).unwrap())
}

/// Whether the message publishes the findings of this version of a file.
fn has_findings_of(message: &Value, uri: &str, version: i64) -> bool {
    message["method"] == "textDocument/publishDiagnostics"
        && message["params"]["uri"] == *uri
        && message["params"]["version"] == version
}

/// URI of a path; a URI is returned unchanged.
pub fn uri(path: &str) -> String {
    if path.starts_with('/') { format!("file://{path}") } else { path.to_owned() }
}

/// `textDocument` and `position`.
pub fn at(path: &str, line: u32, character: u32) -> Value {
    json!({ "textDocument": { "uri": uri(path) }, "position": { "line": line, "character": character } })
}
