//! Random edits while requests are pending. At the end, the server's state equals the state of a fresh server.

use serde_json::{Value, json};

use crate::cell::Cell;
use crate::client::{Client, at, uri};

/// Total number of edits.
const EDITS: usize = 20_000;

const CELL: &str = "library part \"Disk://part/part.pjx\"\npoint pA\ntool tA\nmdesc mA\nnum nA\n\
    program start()\n  num l_i\nbegin\n  // é\n  for l_i=1 to 3\n    nA=nA+power(l_i,2)\n  endFor\n  call other(nA)\n  movej(pA,tA,mA)\nend\n\
    program other(num x_n)\nbegin\n  put(x_n)\n  part:nWeight=1\nend\n\
    --- part\npublic num nWeight\nprogram pick()\nbegin\n  nWeight=2\nend";

const FILES: [&str; 5] = [
    "usrapp/main/start.pgx",
    "usrapp/main/other.pgx",
    "usrapp/main/main.dtx",
    "usrapp/main/main.pjx",
    "usrapp/part/part.dtx",
];

/// Texts inserted by the edits.
const PIECES: [&str; 16] = [
    "",
    "x",
    "\n",
    "endIf\n",
    "if nA>1\n",
    "\"",
    "//",
    "é😀",
    "]]>",
    "<",
    "</Program>",
    "call pick()\n",
    "&quot;",
    "nA=",
    "<Program file=\"pick.pgx\" />",
    "\r\n",
];

/// Requests, sent with [`parameters`]; each reads only its own parameters.
const REQUESTS: [&str; 24] = [
    "textDocument/hover",
    "textDocument/completion",
    "textDocument/definition",
    "textDocument/declaration",
    "textDocument/signatureHelp",
    "textDocument/documentHighlight",
    "textDocument/documentSymbol",
    "textDocument/semanticTokens/full",
    "textDocument/foldingRange",
    "textDocument/codeAction",
    "textDocument/codeLens",
    "textDocument/inlayHint",
    "textDocument/documentLink",
    "textDocument/linkedEditingRange",
    "textDocument/prepareCallHierarchy",
    "callHierarchy/incomingCalls",
    "callHierarchy/outgoingCalls",
    "textDocument/prepareTypeHierarchy",
    "typeHierarchy/subtypes",
    "textDocument/formatting",
    "textDocument/rangeFormatting",
    "textDocument/onTypeFormatting",
    "workspace/willRenameFiles",
    "workspace/willDeleteFiles",
];

/// Deterministic random numbers (SplitMix64).
struct Chance(u64);

impl Chance {
    fn below(&mut self, limit: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut mixed = self.0;
        mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        usize::try_from((mixed ^ (mixed >> 31)) % limit as u64).unwrap()
    }
}

/// Document in the editor.
struct Document {
    path: String,
    original: String,
    text: String,
    version: i64,
    undo: Vec<String>,
}

impl Document {
    /// Makes a random change to the text, and returns it as a protocol change.
    fn change(&mut self, chance: &mut Chance) -> Value {
        self.undo.push(self.text.clone());
        match chance.below(12) {
            0 => {
                // Restores the original text or an earlier state.
                let before = self.undo.len() - 1 - chance.below(self.undo.len());
                self.text = if chance.below(2) == 0 { self.original.clone() } else { self.undo[before].clone() };
                json!({ "text": self.text })
            }
            1 => {
                // Copies a part of the program to another position.
                let (at, _) = self.two_places(chance);
                let from = self.original.floor_char_boundary(chance.below(self.original.len()));
                let half = self.original[from..].to_owned();
                self.replace(at, at, &half)
            }
            kind => {
                let (start, end) = self.two_places(chance);
                let end = if kind < 9 { start } else { end };
                let piece = PIECES[chance.below(PIECES.len())];
                self.replace(start, end, piece)
            }
        }
    }

    fn replace(&mut self, start: usize, end: usize, piece: &str) -> Value {
        let range = json!({ "start": self.position(start), "end": self.position(end) });
        self.text.replace_range(start..end, piece);
        json!({ "range": range, "text": piece })
    }

    /// Two nearby positions in ascending order. No position is between `\r` and `\n`, because editors have none there.
    fn two_places(&self, chance: &mut Chance) -> (usize, usize) {
        let start = self.floor(chance.below(self.text.len() + 1));
        (start, self.floor((start + chance.below(30)).min(self.text.len())))
    }

    fn floor(&self, at: usize) -> usize {
        let at = self.text.floor_char_boundary(at);
        if self.text[..at].ends_with('\r') { at - 1 } else { at }
    }

    fn position(&self, at: usize) -> Value {
        let before = &self.text[..at];
        let line = before.matches('\n').count();
        let character = before.rsplit('\n').next().unwrap().encode_utf16().count();
        json!({ "line": line, "character": character })
    }
}

/// Findings that the idle server sends for every file, and its semantic tokens, which mirror its text.
fn state(client: &mut Client, documents: &[Document]) -> Vec<Value> {
    let mut state = Vec::new();
    for document in documents {
        let params = json!({ "textDocument": { "uri": uri(&document.path) } });
        state.push(client.ask("textDocument/diagnostic", params.clone())["items"].clone());
        state.push(client.ask("textDocument/semanticTokens/full", params.clone())["data"].clone());
        state.push(client.ask("textDocument/documentSymbol", params)["result"].clone());
    }
    state
}

#[test]
fn random_edits_leave_the_server_consistent() {
    for seed in 1..=2 {
        run(seed, EDITS / 4, true);
        run(seed, EDITS / 4, false);
    }
}

/// Capabilities for an editor that resolves action edits, and pulls findings if `pulls`.
fn abilities(pulls: bool) -> Value {
    let action = json!({
        "codeActionLiteralSupport": { "codeActionKind": { "valueSet": [] } },
        "dataSupport": true,
        "resolveSupport": { "properties": ["edit"] },
    });
    let edit = json!({ "documentChanges": true, "resourceOperations": ["create", "rename", "delete"] });
    let mut abilities = json!({ "textDocument": { "codeAction": action }, "workspace": { "workspaceEdit": edit } });
    if pulls {
        abilities["textDocument"]["diagnostic"] = json!({});
        abilities["workspace"]["diagnostics"] = json!({ "refreshSupport": true });
    }
    abilities
}

/// Parameters at a random position that suit any of the requests.
fn parameters(document: &Document, chance: &mut Chance) -> Value {
    let mut number = |limit| u32::try_from(chance.below(limit)).unwrap();
    let (line, column) = (number(30), number(40));
    let mut params = at(&document.path, line, column);
    let (start, end) = (params["position"].clone(), json!({ "line": line + number(4), "character": number(40) }));
    let range = json!({ "start": start, "end": end });
    let uri = uri(&document.path);
    params["range"] = range.clone();
    params["context"] = json!({ "diagnostics": [], "triggerKind": 1, "isRetrigger": false });
    params["options"] = json!({ "tabSize": 2, "insertSpaces": true });
    params["ch"] = json!("\n");
    params["item"] = json!({ "name": "", "kind": 12, "uri": uri, "range": range, "selectionRange": range });
    params["files"] =
        json!([{ "uri": uri, "oldUri": uri, "newUri": uri.replace("/usrapp/main/", "/usrapp/part/new") }]);
    params
}

fn run(seed: u64, edits: usize, pulls: bool) {
    let abilities = &abilities(pulls);
    let cell = Cell::new(CELL);
    let mut chance = Chance(seed);
    let mut client = Client::start_with(&[&cell.folder()], abilities.clone(), Value::Null);
    let mut documents: Vec<Document> = FILES
        .iter()
        .map(|file| {
            let (path, text) = (cell.path(file), cell.text(file).to_owned());
            client.open(&path, &text);
            Document { path, original: text.clone(), text, version: 1, undo: Vec::new() }
        })
        .collect();
    let mut asked = Vec::new();
    for _ in 0..edits {
        // Programs are edited most often.
        let which = if chance.below(8) == 0 { chance.below(FILES.len()) } else { chance.below(2) };
        let document = &mut documents[which];
        let changes: Vec<Value> = (0..=chance.below(2)).map(|_| document.change(&mut chance)).collect();
        document.version += 1;
        let identifier = json!({ "uri": uri(&document.path), "version": document.version });
        client.notify("textDocument/didChange", json!({ "textDocument": identifier, "contentChanges": changes }));
        document.undo.truncate(20);
        if document.text.len() > 20_000 {
            document.text.clone_from(&document.original);
            document.version += 1;
            client.change(&document.path, document.version, &document.text);
        }
        let id = client.request(REQUESTS[chance.below(REQUESTS.len())], parameters(document, &mut chance));
        if chance.below(5) == 0 {
            client.notify("$/cancelRequest", json!({ "id": id }));
        }
        asked.push(id);
        // From time to time the client waits, so that some responses arrive before the next edit.
        if asked.len() > 50 || chance.below(6) == 0 {
            let answers: Vec<Value> = asked.drain(..).map(|id| answered(&mut client, id)).collect();
            asked.extend(answers.iter().filter_map(|answer| choose(&mut client, answer, &mut chance)));
        }
    }
    asked.into_iter().for_each(|id| drop(answered(&mut client, id)));
    compare(client, &cell, &documents, pulls);
}

/// Waits for the response to a request: a result, an error after an edit or a cancellation, or a reason why the server
/// rejects the request (for example an action that would add an error).
fn answered(client: &mut Client, id: i64) -> Value {
    let mut answer = client.answer(id);
    let code = answer["error"]["code"].as_i64();
    assert!(code.is_none_or(|code| [-32800, -32801, -32803].contains(&code)), "{answer}");
    answer["result"].take()
}

/// Chooses one of several actions or lenses, and resolves it.
fn choose(client: &mut Client, answer: &Value, chance: &mut Chance) -> Option<i64> {
    let unresolved = |found: &&Value| found.get("data").is_some();
    let found: Vec<&Value> = answer.as_array()?.iter().filter(unresolved).collect();
    let chosen = *found.get(chance.below(found.len().max(1)))?;
    let method = if chosen.get("title").is_some() { "codeAction/resolve" } else { "codeLens/resolve" };
    Some(client.request(method, chosen.clone()))
}

/// Checks that a fresh server with the current documents reports the same findings.
fn compare(mut client: Client, cell: &Cell, documents: &[Document], pulls: bool) {
    let mut fresh = Client::start_with(&[&cell.folder()], abilities(pulls), Value::Null);
    for document in documents {
        fresh.open(&document.path, &document.text);
    }
    assert_eq!(state(&mut client, documents), state(&mut fresh, documents));
    if !pulls {
        for document in documents {
            let sent = client.latest_findings(&document.path, document.version);
            assert_eq!(sent, fresh.latest_findings(&document.path, 1), "{}", document.path);
        }
    }
    assert!(client.passed().all(|message| message["method"] != "window/showMessage"));
    assert_eq!(client.end(), 0);
    assert_eq!(fresh.end(), 0);
}
