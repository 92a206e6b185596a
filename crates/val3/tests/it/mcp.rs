//! `val3 mcp`. The official clients test the rest (`tests/python/test_mcp.py`, `tests/editors/inspector.js`).

use std::io::{BufRead as _, BufReader, Write as _};
use std::process::Stdio;

use serde_json::{Value, json};

use crate::support::Folder;

/// Responses to tool calls: for each, whether it is an error, and its text.
fn answers(folder: &Folder, options: &[&str], calls: &[(&str, Value)]) -> Vec<(bool, String)> {
    let mut command = folder.command(&[&["mcp"], options].concat());
    let mut server = command.stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().unwrap();
    let mut input = server.stdin.take().unwrap();
    let mut lines = BufReader::new(server.stdout.take().unwrap()).lines();
    let mut request = |message: Value, has_answer: bool| {
        writeln!(input, "{message}").unwrap();
        has_answer.then(|| serde_json::from_str::<Value>(&lines.next().unwrap().unwrap()).unwrap())
    };
    let client = json!({ "name": "test", "version": "1" });
    let opening = json!({ "protocolVersion": "2025-11-25", "capabilities": {}, "clientInfo": client });
    let opened = request(json!({ "jsonrpc": "2.0", "id": 0, "method": "initialize", "params": opening }), true);
    assert_eq!(opened.unwrap()["result"]["serverInfo"]["name"], "val3");
    request(json!({ "jsonrpc": "2.0", "method": "notifications/initialized" }), false);
    let answers = calls.iter().enumerate().map(|(at, (tool, arguments))| {
        let params = json!({ "name": tool, "arguments": arguments });
        let answer = request(json!({ "jsonrpc": "2.0", "id": at + 1, "method": "tools/call", "params": params }), true);
        let result = answer.unwrap()["result"].clone();
        (result["isError"] == true, result["content"][0]["text"].as_str().unwrap().to_owned())
    });
    let answers = answers.collect();
    // The server ends with its client.
    drop(input);
    assert!(server.wait().unwrap().success());
    answers
}

#[test]
fn tools_answer_as_the_commands_do() {
    let folder = Folder::with("num nA = 2\n?nA\nwait(nA==3)");
    let calls = [
        ("check", json!({ "path": "usrapp/main" })),
        ("run", json!({ "path": "usrapp/main", "until": 2 })),
        ("eval", json!({ "path": "usrapp/main", "code": "nA*21" })),
        ("outline", json!({ "path": "usrapp/main", "program": "start" })),
    ];
    let answers = answers(&folder, &[], &calls);
    assert!(answers.iter().all(|(is_error, _)| !is_error), "{answers:?}");
    assert!(answers[0].1.starts_with("ok: 0 errors"), "{}", answers[0].1);
    assert!(answers[1].1.contains("wait(nA==3)") && answers[1].1.contains("next: "), "{}", answers[1].1);
    assert_eq!(answers[2].1, "ok:\n```text\n42\n```");
    assert!(answers[3].1.contains("begin") && !answers[3].1.contains("CDATA"), "{}", answers[3].1);
}

#[test]
fn files_change_only_on_request() {
    let folder = Folder::with("?1");
    let write = json!({ "path": "usrapp/main", "text": "program more()\nbegin\n  ?2\nend" });
    let refused = answers(&folder, &[], &[("write_program", write.clone())]);
    assert!(refused[0].0 && refused[0].1.contains("there is no tool"), "{refused:?}");
    let written = answers(&folder, &["--write"], &[("write_program", write.clone()), ("write_program", write)]);
    assert!(written[0].1.starts_with("ok: written"), "{written:?}");
    assert!(written[1].1.contains("nothing changes"), "{written:?}");
    assert!(folder.read("usrapp/main/main.pjx").contains("more.pgx"));
}

#[test]
fn wrong_roots_and_tools_are_refused() {
    for (options, reason) in
        [(["--root", "nowhere"], "no folder"), (["--tools", "format"], "there is no tool `format`")]
    {
        let refused = Folder::empty().val3(&[&["mcp"][..], &options].concat());
        assert_eq!(refused.code, 2);
        assert!(refused.stderr.contains(reason), "{}", refused.stderr);
    }
}
