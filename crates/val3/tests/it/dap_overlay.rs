//! Files that a debugged program writes: they are on the disk after the session, without writes that stepping back has
//! undone.

use std::fs;

use serde_json::{Value, json};

use crate::dap_client::Session;
use crate::support::Folder;

/// Writes one line, then another line that depends on `nWay`.
const LISTING: &str = "
num nWay=1
num nFile
string sLines[1]
program note(string x_sText)
begin
  nFile=$fileOpen(\"./log.txt\",\"a\")
  sLines[0]=x_sText
  ? $fileSet(nFile,sLines,1)
  ? $fileClose(nFile)
end
program start()
begin
  call note(\"begin\")
  if nWay==1
    call note(\"one\")
  else
    call note(\"two\")
  endIf
  ? $delete(\"./old.txt\")
  nWay=3
  delay(3600)
end
";

/// Index of the first program line that contains a text.
fn line(folder: &Folder, text: &str) -> Option<usize> {
    folder.read("usrapp/main/start.pgx").lines().position(|line| line.contains(text)).map(|row| row + 1)
}

/// A session with breakpoints at the lines `if nWay` and `delay` of the program, stopped before its first line.
fn launched(folder: &Folder, options: Value) -> (Session, i64) {
    folder.write("usrapp/main/old.txt", "old");
    let path = |name: &str| fs::canonicalize(folder.path().join(name)).unwrap().to_str().unwrap().to_owned();
    let mut launch = json!({ "program": path("usrapp/main"), "script": null });
    launch.as_object_mut().unwrap().extend(options.as_object().unwrap().clone());
    let (mut session, task) = Session::launched(launch);
    let rows = ["if nWay", "delay"].into_iter().filter_map(|text| line(folder, text));
    let lines: Vec<Value> = rows.map(|row| json!({ "line": row })).collect();
    let source = json!({ "path": path("usrapp/main/start.pgx") });
    session.ask("setBreakpoints", json!({ "source": source, "breakpoints": lines }));
    (session, task)
}

fn go(session: &mut Session, command: &str, task: i64) {
    session.ask(command, json!({ "threadId": task }));
    session.stopped("breakpoint");
}

fn text(folder: &Folder, name: &str) -> Option<String> {
    fs::read_to_string(folder.path().join("usrapp/main").join(name)).ok()
}

#[test]
fn the_files_are_those_of_the_last_future() {
    let folder = Folder::with(LISTING);
    let (mut session, task) = launched(&folder, json!({}));
    for way in ["1", "2"] {
        go(&mut session, "continue", task);
        let (_, _, frame) = session.frame(task);
        session.ask("setExpression", json!({ "frameId": frame, "expression": "nWay", "value": way }));
        go(&mut session, "continue", task);
        assert_eq!((text(&folder, "log.txt"), text(&folder, "old.txt").is_some()), (None, true));
        if way == "1" {
            go(&mut session, "reverseContinue", task);
            session.ask("stepBack", json!({ "threadId": task }));
            session.event("stopped");
        }
    }
    session.end();
    assert_eq!(text(&folder, "log.txt").as_deref(), Some("begin\ntwo\n"));
    assert_eq!(text(&folder, "old.txt"), None);
}

#[test]
fn a_restart_begins_with_the_files_of_the_run_before() {
    let folder = Folder::with(LISTING);
    let (mut session, task) = launched(&folder, json!({}));
    go(&mut session, "continue", task);
    session.ask("restart", json!({}));
    let task = session.stopped("entry");
    assert_eq!(text(&folder, "log.txt").as_deref(), Some("begin\n"));
    go(&mut session, "continue", task);
    session.end();
    assert_eq!(text(&folder, "log.txt").as_deref(), Some("begin\nbegin\n"));
}

#[test]
fn a_file_that_was_edited_meanwhile_stays() {
    let folder = Folder::with(LISTING);
    let (mut session, task) = launched(&folder, json!({}));
    go(&mut session, "continue", task);
    folder.write("usrapp/main/log.txt", "by hand");
    session.ask("restart", json!({}));
    let said = loop {
        let output = session.event("output")["output"].as_str().unwrap().to_owned();
        if output.contains("log.txt") {
            break output;
        }
    };
    assert!(said.contains("log.txt` was changed on the disk") && said.contains("`log.txt.debugged`"), "{said}");
    assert_eq!(text(&folder, "log.txt").as_deref(), Some("by hand"));
    assert_eq!(text(&folder, "log.txt.debugged").as_deref(), Some("begin\n"));
    session.end();
}

#[test]
fn a_client_that_disappears_leaves_whole_files() {
    let folder = Folder::with(LISTING);
    let (mut session, task) = launched(&folder, json!({}));
    go(&mut session, "continue", task);
    session.assert_ended();
    assert_eq!(text(&folder, "log.txt").as_deref(), Some("begin\n"));
    assert_eq!(text(&folder, "old.txt").as_deref(), Some("old"));
}

/// The signal arrives while the run is stopped, and while it is running.
#[cfg(unix)]
#[test]
fn a_signal_leaves_whole_files_and_a_complete_record() {
    use rustix::process::Signal;
    for (signal, code, is_stopped) in [(Signal::TERM, 143, true), (Signal::INT, 130, false)] {
        let folder = Folder::with(LISTING);
        let events = folder.path().join("events.jsonl");
        let (mut session, task) = launched(&folder, json!({ "events": events.to_str().unwrap(), "time": "real" }));
        go(&mut session, "continue", task);
        go(&mut session, "continue", task);
        if !is_stopped {
            session.ask("continue", json!({ "threadId": task }));
        }
        assert_eq!(session.signal(signal), Some(code));
        assert_eq!(text(&folder, "log.txt").as_deref(), Some("begin\none\n"));
        assert_eq!(text(&folder, "old.txt"), None);
        let events = folder.read("events.jsonl");
        assert!(events.ends_with("\"kind\":\"end\",\"reason\":\"stopped\"}\n"), "{events}");
    }
}

/// File contents that were read are part of the history: they are discarded with its oldest part.
#[test]
fn contents_that_were_read_count_as_past() {
    let folder = Folder::with(
        "
num nFile
num nRound
string sLines[1]
program start()
begin
  for nRound=1 to 60
    nFile=$fileOpen(\"./large.txt\",\"r\")
    ? $fileGet(nFile,sLines,1)
    ? $fileClose(nFile)
  endFor
  delay(3600)
end
",
    );
    folder.write("usrapp/main/large.txt", &"text\n".repeat(20_000));
    // 60 times 100,000 bytes, without the contents read after the last snapshot.
    let whole = past(&folder, 256);
    assert!(whole["isWhole"] == true && whole["bytes"].as_u64() > Some(4_500_000), "{whole}");
    let bounded = past(&folder, 2);
    assert!(bounded["isWhole"] == false && bounded["bytes"].as_u64() < Some(2 << 20), "{bounded}");
    assert!(bounded["cycles"].as_u64() > Some(10), "{bounded}");
}

/// History of a run that keeps `memory` MB of it.
fn past(folder: &Folder, memory: u64) -> Value {
    let (mut session, task) = launched(folder, json!({ "pastMemory": memory }));
    go(&mut session, "continue", task);
    let past = session.ask("val3/past", json!({}));
    session.end();
    past
}
