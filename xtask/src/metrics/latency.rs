//! Latency of the packed binary for an editor, over real pipes: `cargo xtask metrics --lsp`.
//!
//! On two cores, p50/p95 in ms until the complete response has arrived, for a program of 2,600 lines and for a
//! workspace of 100,000 code lines:
//!
//! | | 2,600 lines | 100,000 lines |
//! |---|---|---|
//! | edit to findings | 2.8 / 4.0 | 2.2 / 3.4 |
//! | hover, definition, completion, signature help | at most 0.8 / 1.0 | at most 0.5 / 0.8 |
//! | semantic tokens of the entire program | 2.0 / 2.6 | 0.7 / 1.0 |
//! | references of a name used 1,000 times | 1.6 / 2.2 | 7.1 / 10.7 |
//! | rename of a name used 1,000 times | 1.2 / 1.5 | 8.8 / 11.8 |
//! | cancellation to response | 0.2 / 0.3 to 1.2 | 0.2 / 0.3 to 0.6 |
//! | start to first findings | 12 to 58 | 47 to 70 |
//! | exit | 3 to 20 | 3 to 6 |
//! | peak memory, MB | 39 | 91 |

use std::time::{Duration, Instant};

use anyhow::{Context, bail};
use camino::Utf8Path;
use serde_json::{Value, json};

use super::editor::{Editor, uri};
use super::long_application::{self, NAME, PROGRAM};
use super::speed::{peak_kilobytes, write_workspace};
use crate::project;

/// Number of measurements per item.
const TIMES: usize = 200;

/// Measures with a program of 2,600 lines and with a generated workspace of `lines` code lines.
pub(super) fn measure(lines: usize) -> anyhow::Result<()> {
    let folder = project::root().join("target/metrics-lsp");
    if folder.exists() {
        std::fs::remove_dir_all(&folder).with_context(|| format!("cannot clear {folder}"))?;
    }
    let (long, large) = (folder.join("long"), folder.join("large"));
    write_long(&long)?;
    let code_lines = write_workspace(&large, lines)?;
    println!("{:44} {:>9} {:>9}", "val3 lsp, milliseconds", "p50", "p95");
    println!("one program of 2,600 lines");
    session(&long, &long.join(PROGRAM))?;
    println!("a workspace of {code_lines} code lines");
    session(&large, &largest_program(&large)?)
}

fn write_long(folder: &Utf8Path) -> anyhow::Result<()> {
    for (path, text) in long_application::files() {
        let path = folder.join(path);
        std::fs::create_dir_all(path.parent().unwrap_or(folder))?;
        std::fs::write(path, text)?;
    }
    Ok(())
}

/// Returns the largest program.
fn largest_program(folder: &Utf8Path) -> anyhow::Result<camino::Utf8PathBuf> {
    let mut largest = None;
    for application in folder.join("usr/usrapp").read_dir_utf8()? {
        for file in application?.path().read_dir_utf8()? {
            let path = file?.into_path();
            let size = std::fs::metadata(&path)?.len();
            if path.extension() == Some("pgx") && largest.as_ref().is_none_or(|(most, _)| *most < size) {
                largest = Some((size, path));
            }
        }
    }
    largest.map(|(_, path)| path).context("the workspace has no program")
}

/// Runs a session in which all items are measured with one program.
fn session(folder: &Utf8Path, program: &Utf8Path) -> anyhow::Result<()> {
    let started = Instant::now();
    let mut editor = Editor::open(&project::binary(project::DIST)?, folder)?;
    let mut open = Open::new(&mut editor, program)?;
    print("start to first findings", vec![started.elapsed()]);
    open.edits("edit to findings")?;
    open.requests()?;
    open.cancel()?;
    let peak = peak_kilobytes(editor.process());
    let (exit, code) = editor.close()?;
    print("exit to the end of the process", vec![exit]);
    if code != Some(0) {
        bail!("the server ended with {code:?}");
    }
    match peak {
        Some(kilobytes) => println!("{:44} {:9.1}", "peak memory, MB", kilobytes as f64 / 1000.0),
        None => println!("peak memory unknown on this system"),
    }
    Ok(())
}

/// An open program.
struct Open<'e> {
    editor: &'e mut Editor,
    uri: String,
    text: String,
    version: i64,
}

impl<'e> Open<'e> {
    fn new(editor: &'e mut Editor, program: &Utf8Path) -> anyhow::Result<Self> {
        let text = std::fs::read_to_string(program)?.trim_start_matches('\u{feff}').to_owned();
        let uri = uri(program);
        let document = json!({ "uri": uri, "languageId": "val3", "version": 1, "text": text });
        editor.notify("textDocument/didOpen", &json!({ "textDocument": document }))?;
        editor.findings(&uri, 1)?;
        Ok(Self { editor, uri, text, version: 1 })
    }

    /// Types a faulty line and removes it, at the beginning of the code.
    fn edits(&mut self, what: &str) -> anyhow::Result<()> {
        // Wait until the first check of the other files has ended.
        std::thread::sleep(Duration::from_secs(2));
        let line = self.text.lines().position(|line| line.contains("begin")).context("no code")? + 1;
        let mut times = Vec::new();
        for round in 0..TIMES {
            let (end, text) = if round % 2 == 0 { (line, "  nUnknown=1\n") } else { (line + 1, "") };
            let range = json!({ "start": { "line": line, "character": 0 }, "end": { "line": end, "character": 0 } });
            self.version += 1;
            let document = json!({ "uri": self.uri, "version": self.version });
            let changes = json!([{ "range": range, "text": text }]);
            let started = Instant::now();
            self.editor
                .notify("textDocument/didChange", &json!({ "textDocument": document, "contentChanges": changes }))?;
            let found = self.editor.findings(&self.uri, self.version)?;
            times.push(self.editor.since(started));
            if found.to_string().contains("nUnknown") != (round % 2 == 0) {
                bail!("version {} has the findings of another: {found}", self.version);
            }
            // Faster than any user types.
            std::thread::sleep(Duration::from_millis(30));
        }
        print(what, times);
        Ok(())
    }

    fn requests(&mut self) -> anyhow::Result<()> {
        let document = json!({ "textDocument": { "uri": self.uri } });
        let on_name = self.place(&[NAME, "movej", "call ", "("])?;
        let in_call = self.place(&["movej(", "movel(", "put(", "("])?;
        self.repeat("hover", "textDocument/hover", &on_name, TIMES)?;
        self.repeat("definition", "textDocument/definition", &self.place(&[NAME, "nCount", "n"])?, TIMES)?;
        self.repeat("completion", "textDocument/completion", &on_name, TIMES)?;
        self.repeat("signature help", "textDocument/signatureHelp", &in_call, TIMES)?;
        self.repeat("semantic tokens of the whole program", "textDocument/semanticTokens/full", &document, TIMES)?;
        if self.text.contains(NAME) {
            let references = with(self.place(&[NAME])?, "context", json!({ "includeDeclaration": true }));
            self.repeat("references of a name used 1,000 times", "textDocument/references", &references, TIMES / 10)?;
            let rename = with(self.place(&[NAME])?, "newName", json!("nOther"));
            self.repeat("rename of a name used 1,000 times", "textDocument/rename", &rename, TIMES / 10)?;
        }
        Ok(())
    }

    /// Measures requests, each after an edit, so that no result is cached.
    fn repeat(&mut self, what: &str, method: &str, params: &Value, times: usize) -> anyhow::Result<()> {
        let end = self.text.lines().count() - 1;
        let mut durations = Vec::new();
        for round in 0..times {
            let column = self.text.lines().last().unwrap_or("").len() + round;
            let place = json!({ "line": end, "character": column });
            self.version += 1;
            let document = json!({ "uri": self.uri, "version": self.version });
            let changes = json!([{ "range": { "start": place, "end": place }, "text": " " }]);
            self.editor
                .notify("textDocument/didChange", &json!({ "textDocument": document, "contentChanges": changes }))?;
            self.editor.findings(&self.uri, self.version)?;
            durations.push(self.editor.time(method, params)?);
        }
        print(what, durations);
        let text = &self.text;
        self.version += 1;
        let document = json!({ "uri": self.uri, "version": self.version });
        self.editor.notify(
            "textDocument/didChange",
            &json!({ "textDocument": document, "contentChanges": [{ "text": text }] }),
        )
    }

    /// Returns the position after the first of these texts that occurs in the code.
    fn place(&self, parts: &[&str]) -> anyhow::Result<Value> {
        let begin = self.text.find("begin").context("no code")? + "begin".len();
        let code = self.text.get(begin..).unwrap_or("");
        let found = parts.iter().find_map(|part| Some(code.find(part)? + part.len()));
        let before = self.text.get(..begin + found.context("nothing to ask about")?).unwrap_or("");
        let line = before.matches('\n').count();
        let character = before.rsplit('\n').next().unwrap_or("").len();
        Ok(json!({ "textDocument": { "uri": self.uri }, "position": { "line": line, "character": character } }))
    }

    /// Measures the time from the cancellation of a workspace search to its response.
    fn cancel(&mut self) -> anyhow::Result<()> {
        let mut times = Vec::new();
        for round in 0..TIMES / 2 {
            self.version += 1;
            let document = json!({ "uri": self.uri, "version": self.version });
            // An unchanged text would not be searched again.
            let changes = json!([{ "text": self.text.clone() + "\n".repeat(round % 2).as_str() }]);
            self.editor
                .notify("textDocument/didChange", &json!({ "textDocument": document, "contentChanges": changes }))?;
            let references = with(self.place(&[NAME, "n"])?, "context", json!({ "includeDeclaration": true }));
            let id = self.editor.request("textDocument/references", &references)?;
            let started = Instant::now();
            self.editor.notify("$/cancelRequest", &json!({ "id": id }))?;
            self.editor.wait_for(|message| {
                message.get("id").is_some_and(|found| *found == id) && message.get("method").is_none()
            })?;
            times.push(started.elapsed());
        }
        print("cancel to answer", times);
        Ok(())
    }
}

/// Adds an entry to an object.
fn with(mut object: Value, key: &str, value: Value) -> Value {
    if let Some(entries) = object.as_object_mut() {
        entries.insert(key.to_owned(), value);
    }
    object
}

fn print(what: &str, mut times: Vec<Duration>) {
    times.sort_unstable();
    let at = |percent: usize| times.get((times.len() - 1) * percent / 100).map_or(0.0, |time| time.as_secs_f64() * 1e3);
    println!("  {what:42} {:9.2} {:9.2}", at(50), at(95));
}
