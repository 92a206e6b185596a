//! An editor for measurements: it communicates with a language server over its standard input and output.

use std::io::{BufRead, BufReader, Read as _, Write as _};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};
use std::time::{Duration, Instant};

use anyhow::{Context, bail};
use camino::Utf8Path;
use serde_json::{Value, json};

/// A server and the pipes to it.
pub(super) struct Editor {
    server: Child,
    to: ChildStdin,
    from: BufReader<ChildStdout>,
    next: i64,
    /// Time at which the last message was complete. Parsing it is not measured, because it is the client's work.
    arrived: Instant,
}

impl Editor {
    /// Starts `val3 lsp` in a folder and opens the session.
    pub(super) fn open(binary: &Utf8Path, folder: &Utf8Path) -> anyhow::Result<Self> {
        let mut server = Command::new(binary)
            .args(["lsp", "--stdio"])
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .context("cannot start val3 lsp")?;
        let to = server.stdin.take().context("no input")?;
        let from = BufReader::new(server.stdout.take().context("no output")?);
        let mut editor = Self { server, to, from, next: 1, arrived: Instant::now() };
        let folders = json!([{ "uri": uri(folder), "name": "measured" }]);
        let capabilities = json!({ "general": { "positionEncodings": ["utf-16"] } });
        editor.ask(
            "initialize",
            &json!({ "processId": null, "capabilities": capabilities, "workspaceFolders": folders }),
        )?;
        editor.notify("initialized", &json!({}))?;
        Ok(editor)
    }

    /// Sends a notification.
    pub(super) fn notify(&mut self, method: &str, params: &Value) -> anyhow::Result<()> {
        self.send(&json!({ "jsonrpc": "2.0", "method": method, "params": params }))
    }

    /// Sends a request and returns its id.
    pub(super) fn request(&mut self, method: &str, params: &Value) -> anyhow::Result<i64> {
        self.next += 1;
        self.send(&json!({ "jsonrpc": "2.0", "id": self.next, "method": method, "params": params }))?;
        Ok(self.next)
    }

    /// Sends a request and waits for the complete response.
    pub(super) fn ask(&mut self, method: &str, params: &Value) -> anyhow::Result<Value> {
        let id = self.request(method, params)?;
        self.wait_for(|message| message.get("id").is_some_and(|found| *found == id) && message.get("method").is_none())
    }

    /// Sends a request and returns the time until the response; a response without a result is an error.
    pub(super) fn time(&mut self, method: &str, params: &Value) -> anyhow::Result<Duration> {
        let started = Instant::now();
        let answer = self.ask(method, params)?;
        if answer.get("result").is_none_or(Value::is_null) {
            bail!("{method} has no result: {answer}");
        }
        Ok(self.since(started))
    }

    /// Returns the time from `started` until the last message was complete.
    pub(super) fn since(&self, started: Instant) -> Duration {
        self.arrived.duration_since(started)
    }

    /// Waits for the findings of a document version.
    pub(super) fn findings(&mut self, uri: &str, version: i64) -> anyhow::Result<Value> {
        let found = self.wait_for(|message| {
            message.get("method").is_some_and(|found| found == "textDocument/publishDiagnostics")
                && message.pointer("/params/uri").is_some_and(|found| found == uri)
                && message.pointer("/params/version").is_some_and(|found| *found == version)
        })?;
        found.pointer("/params/diagnostics").cloned().context("no findings")
    }

    /// Reads messages until one matches.
    pub(super) fn wait_for(&mut self, is_meant: impl Fn(&Value) -> bool) -> anyhow::Result<Value> {
        loop {
            let message = self.read()?;
            if is_meant(&message) {
                return Ok(message);
            }
        }
    }

    /// Returns the process id of the server.
    pub(super) fn process(&self) -> u32 {
        self.server.id()
    }

    /// Ends the session, and returns the time from `exit` to the end of the process, and its exit code.
    pub(super) fn close(mut self) -> anyhow::Result<(Duration, Option<i32>)> {
        self.ask("shutdown", &Value::Null)?;
        let started = Instant::now();
        self.notify("exit", &Value::Null)?;
        // The input stays open, because the server has to end after `exit` even so.
        let status = self.server.wait()?;
        Ok((started.elapsed(), status.code()))
    }

    fn send(&mut self, message: &Value) -> anyhow::Result<()> {
        let text = message.to_string();
        write!(self.to, "Content-Length: {}\r\n\r\n{text}", text.len())?;
        Ok(self.to.flush()?)
    }

    fn read(&mut self) -> anyhow::Result<Value> {
        let mut length = 0;
        loop {
            let mut line = String::new();
            if self.from.read_line(&mut line)? == 0 {
                bail!("the server ended");
            }
            match line.trim().strip_prefix("Content-Length:") {
                Some(value) => length = value.trim().parse()?,
                None if line.trim().is_empty() => break,
                None => {}
            }
        }
        let mut body = vec![0; length];
        self.from.read_exact(&mut body)?;
        self.arrived = Instant::now();
        Ok(serde_json::from_slice(&body)?)
    }
}

/// Returns the URI for an absolute path without special characters.
pub(super) fn uri(path: &Utf8Path) -> String {
    format!("file://{path}")
}
