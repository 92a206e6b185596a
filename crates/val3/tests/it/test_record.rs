//! `val3 test --record`: scenarios from the records of runs.

use std::path::Path;

use expect_test::{Expect, expect};

use crate::support::{CommandOutput, Folder, copy_folder};

const DATA: &str = r#"
=== main/main.dtx
<?xml version="1.0" encoding="utf-8"?>
<Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
  <Datas>
    <Data name="doLamp" access="private" xsi:type="array" type="dio" size="1"><Value key="0" link="Io\%Q0" /></Data>
    <Data name="diGo" access="private" xsi:type="array" type="dio" size="1"><Value key="0" link="Io\%I0" /></Data>
    <Data name="siHost" access="private" xsi:type="array" type="sio" size="1"><Value key="0" link="Socket\host" /></Data>
    <Data name="nState" access="private" xsi:type="array" type="num" size="1" />
    <Data name="nZero" access="private" xsi:type="array" type="num" size="1" />
    <Data name="sText" access="private" xsi:type="array" type="string" size="1" />
  </Datas>
</Database>"#;

/// An application `main` whose program `start` has this code.
fn cell(code: &str) -> Folder {
    Folder::with(&format!("program start()\nbegin\n{code}\nend\n{DATA}"))
}

/// Runs the application with a script and further arguments, and writes its events to `run.jsonl`.
fn run(folder: &Folder, script: &str, args: &[&str]) {
    folder.write("script.toml", script);
    let fixed = ["run", "usrapp/main", "--script", "script.toml", "--events", "run.jsonl"];
    folder.val3(&[&fixed, args].concat());
}

const RECORD: [&str; 6] = ["test", "--record", "run.jsonl", "--to", "tests/recorded.toml", "usrapp/main"];

/// The scenario of the run, which passes.
#[track_caller]
fn recorded(folder: &Folder) -> (String, CommandOutput) {
    let written = folder.val3(&RECORD);
    assert_eq!(written.code, 0, "{written:?}");
    let text = folder.read("tests/recorded.toml");
    let tested = folder.val3(&["test", "tests/recorded.toml"]);
    assert_eq!(tested.code, 0, "{tested:?}\n{text}");
    (text, written)
}

#[track_caller]
fn check(code: &str, script: &str, args: &[&str], expected: Expect) {
    let folder = cell(code);
    run(&folder, script, args);
    let (text, written) = recorded(&folder);
    assert!(!written.stderr.contains("note:"), "{written:?}");
    expected.assert_eq(&text);
}

#[test]
fn what_came_from_outside_and_what_the_run_did_is_written() {
    let code = "title(\"Cell\")\nput(\"ready\")\nwait(diGo)\ndoLamp=true\nlogMsg(\"lamp\")\nnState=get()\n? \"key \"+toString(\"\",nState)\n\
                popUpMsg(\"it's \"+sText)\ndoLamp=false\ndelay(1)\ndoLamp=true";
    let script = r#"
        [[at]]
        t = 0.5
        io = { 'Io\%I0' = true }
        set = { sText = 'a "b"' }
        [[at]]
        t = 1
        key = "F1"
        mode = "remote"
        monitor_speed = 50
    "#;
    check(
        code,
        script,
        &[],
        expect![[r##"
        # Recorded from run.jsonl
        application = "../usrapp/main"

        [[at]]
        t = 0.5
        io = { 'Io\%I0' = true }
        set = { sText = 'a "b"' }

        [[at]]
        t = 1
        key = "F1"
        mode = "remote"
        monitor_speed = 50

        [expect]
        screen = [
          "Cell",
          "ready",
        ]
        print = [
          "key 271",
        ]
        log = [
          "USR lamp",
        ]
        popup = [
          "it's a \"b\"",
        ]

        [expect.io]
        'Io\%Q0' = true
    "##]],
    );
}

#[test]
fn reactions_become_events_at_their_times() {
    let script = "[[when]]\nio = { 'Io\\%Q0' = true }\nthen = [{ after = 0.25, io = { 'Io\\%I0' = true } }]";
    check(
        "delay(0.1)\ndoLamp=true\nwait(diGo)\n? \"on\"",
        script,
        &[],
        expect![[r##"
        # Recorded from run.jsonl
        application = "../usrapp/main"

        [[at]]
        t = 0.356
        io = { 'Io\%I0' = true }

        [expect]
        print = [
          "on",
        ]

        [expect.io]
        'Io\%Q0' = true
    "##]],
    );
}

#[test]
fn lines_have_the_bytes_of_both_directions() {
    let script = "[[at]]\nt = 0.5\nreceive = { 'Socket\\host' = { hex = \"01 02 0D\" } }\n\
                  [[at]]\nt = 0.7\nreceive = { 'Socket\\host' = \"go\\r\" }";
    let folder = cell("sText=siHost\nsText=siHost\nsiHost=\"got \"+sText");
    run(&folder, script, &["--until", "3"]);
    let (text, _) = recorded(&folder);
    for part in ["{ hex = \"01 02 0D\" }", "t = 0.7\nreceive = { 'Socket\\host' = \"go\\r\" }", "[expect.sent]"] {
        assert!(text.contains(part), "{part}: {text}");
    }
}

#[test]
fn errors_that_stop_tasks_are_expected() {
    check(
        "delay(1)\nnState=1/nZero",
        "",
        &["--until", "3"],
        expect![[r##"
        # Recorded from run.jsonl
        application = "../usrapp/main"
        until = 1.004

        [expect]
        errors = [
          { code = 10, task = "main~", program = "start" },
        ]
    "##]],
    );
}

#[test]
fn a_stop_and_typed_keys_are_repeated() {
    let script = "[[at]]\nt = 2\nstop = true";
    check(
        "nState=get()\nput(nState)\nwhile true\n  delay(0.1)\nendWhile",
        script,
        &["--keys", "97,F2"],
        expect![[r##"
        # Recorded from run.jsonl
        application = "../usrapp/main"

        [[at]]
        t = 0
        keys = "a{F2}"

        [[at]]
        t = 2
        stop = true

        [expect]
        screen = [
          "97",
        ]
    "##]],
    );
}

#[test]
fn the_controller_at_the_start_is_that_of_the_run() {
    check(
        "wait(isPowered())\n? \"power\"",
        "",
        &["--power"],
        expect![[r##"
        # Recorded from run.jsonl
        application = "../usrapp/main"
        power = true

        [expect]
        print = [
          "power",
        ]
    "##]],
    );
}

#[test]
fn a_peer_becomes_the_script() {
    let folder = cell("sText=siHost\n? sText");
    run(&folder, "silent = ['Socket\\host']", &["--until", "1"]);
    let events = folder.read("run.jsonl");
    let received = r#"{"t":0.5,"task":"main~","kind":"sio","link":"Socket\\host","dir":"in","bytes":[104,105,13]}"#;
    let printed = r#"{"t":0.5,"task":"main~","kind":"print","text":"hi"}"#;
    let end = events.lines().last().unwrap();
    let begin: Vec<&str> = events.lines().filter(|line| *line != end).collect();
    folder.write("run.jsonl", &format!("{}\n{received}\n{printed}\n{end}\n", begin.join("\n")));
    let (text, _) = recorded(&folder);
    assert!(text.contains("t = 0.5\nreceive = { 'Socket\\host' = \"hi\\r\" }"), "{text}");
    assert!(text.contains("print = [\n  \"hi\",\n]"), "{text}");
}

#[test]
fn what_is_not_repeated_is_a_comment_and_a_note() {
    let folder = cell("? \"one\"\n? \"two\"\ndelay(1)\nput(\"end\")");
    run(&folder, "", &[]);
    let events = folder.read("run.jsonl").replace("\"two\"", "\"other\"");
    let (begin, end) = events.trim_end().rsplit_once('\n').unwrap();
    let page = r#"{"t":0.75,"kind":"act","keys":{"userPage":{"to":"next"}}}"#;
    folder.write("run.jsonl", &format!("{begin}\n{page}\n{end}\n"));
    let (text, written) = recorded(&folder);
    expect![[r##"
        # Recorded from run.jsonl
        # Not repeated: at 0.75 s the operator has done what no script does: {"userPage":{"to":"next"}}
        # Not repeated: the execution does not repeat "other"
        # Not repeated: the page at the end is left out, because the execution differs from the run
        application = "../usrapp/main"

        # t = 0.75: no key of a script is {"userPage":{"to":"next"}}

        [expect]
        print = [
          "one",
          # not repeated: "other",
        ]
    "##]]
    .assert_eq(&text);
    expect![[r#"
        note: at 0.75 s the operator has done what no script does: {"userPage":{"to":"next"}}; the scenario has a comment about it
        note: the execution does not repeat "other"; the scenario has a comment about it
        note: the page at the end is left out, because the execution differs from the run; the scenario has a comment about it
        wrote tests/recorded.toml
        execute it: val3 test tests/recorded.toml
    "#]].assert_eq(&written.stderr);
}

#[test]
fn a_scenario_that_cannot_pass_is_not_written() {
    let folder = cell("? \"one\"");
    run(&folder, "", &[]);
    let changed = folder.read("usrapp/main/start.pgx").replace("? \"one\"", "? nState/nZero");
    folder.write("usrapp/main/start.pgx", &changed);
    let refused = folder.val3(&RECORD);
    expect![[r#"
        error: a scenario cannot repeat this run, so none is written
        it never ends: it was stopped by error 10, and nothing can happen any more
          help: the application may differ from the one of the run, or a line may have had another end
    "#]]
    .assert_eq(&refused.stderr);
    assert!(refused.code == 2 && !folder.path().join("tests").exists(), "{refused:?}");
}

#[test]
fn wrong_arguments_say_what_to_do() {
    let folder = cell("? \"one\"");
    run(&folder, "", &[]);
    recorded(&folder);
    let again = folder.val3(&RECORD);
    assert!(again.code == 2 && again.stderr.contains("it exists, and is not replaced"), "{again:?}");
    folder.write("none.jsonl", "hello\n");
    folder.write("empty.jsonl", "");
    folder.write("faults.jsonl", "{\"t\":0.0,\"kind\":\"end\",\"reason\":\"refused\"}\n");
    for (record, to, message) in [
        ("run.jsonl", "tests/a.txt", "ends with `.toml`"),
        ("none.jsonl", "tests/a.toml", "line 1 is not JSON"),
        ("empty.jsonl", "tests/a.toml", "the file has no events"),
        ("faults.jsonl", "tests/a.toml", "was not started because of its faults"),
        ("missing.jsonl", "tests/a.toml", "cannot record a scenario from `missing.jsonl`"),
    ] {
        let refused = folder.val3(&["test", "--record", record, "--to", to, "usrapp/main"]);
        assert!(refused.code == 2 && refused.stderr.contains(message), "{refused:?}");
    }
    let several = folder.val3(&["test", "--record", "run.jsonl", "--to", "tests/a.toml", "usrapp/main", "usrapp"]);
    assert!(several.stderr.contains("--record needs --to and one application"), "{several:?}");
}

#[test]
fn runs_of_the_example_are_repeated() {
    let example = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/palletiser");
    let folder = Folder::empty();
    copy_folder(&example, folder.path());
    let application = "usr/usrapp/palletiser";
    for script in ["boxes.toml", "tests/bags.toml", "tests/lostBox.toml"] {
        let events = folder.path().join("run.jsonl");
        drop(std::fs::remove_file(&events));
        folder.val3(&["run", application, "--script", script, "--until", "12", "--events", "run.jsonl"]);
        let to = format!("tests/recorded/{}", Path::new(script).file_name().unwrap().to_str().unwrap());
        let written = folder.val3(&["test", "--record", "run.jsonl", "--to", &to, application]);
        assert!(written.code == 0 && !written.stderr.contains("note:"), "{written:?}");
    }
    let tested = folder.val3(&["test", "tests/recorded"]);
    assert!(tested.code == 0 && tested.stdout.contains("3 passed, 0 failed"), "{tested:?}");
}
