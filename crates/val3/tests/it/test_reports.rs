//! `val3 test`: reports are complete even if a run ends early.

use std::io::{BufRead as _, BufReader};
use std::process::{Command, Stdio};

use expect_test::expect;
use serde_json::Value;

use crate::test_command::{cell, timeless};

#[test]
fn failures_are_listed_at_the_end() {
    let folder = cell(&[
        ("testA", ""),
        ("testB", "call assert:equalNum(1,2,0)"),
        ("testC", "call helper()"),
        ("helper", "call assert:equalString(\"ab\",\"ac\")"),
    ]);
    let run = folder.val3(&["test", "usrapp"]);
    let summary = run.stdout.split_once("failures:\n").unwrap().1;
    expect![[r#"
          usrapp/mainTest/testB.pgx:5: mainTest:testB: 1 instead of 2 (1 away, tolerance 0)
          usrapp/mainTest/helper.pgx:5: mainTest:testC: "ab" instead of "ac"
        1 passed, 2 failed
    "#]]
    .assert_eq(summary);
    let raw = folder.command(&["test", "usrapp"]).output().unwrap();
    assert!(String::from_utf8(raw.stderr).unwrap().starts_with("finished in "));
    let quiet = folder.val3(&["test", "usrapp", "-q"]);
    assert_eq!((quiet.code, quiet.stdout.contains("ok ")), (1, false), "{quiet:?}");
    assert!(quiet.stdout.contains("FAIL  testB"), "{quiet:?}");
    let passed = folder.val3(&["test", "usrapp", "--quiet", "--filter", "testA"]);
    assert_eq!((passed.code, passed.stdout.as_str()), (0, "1 passed, 0 failed\n"), "{passed:?}");
}

#[test]
fn services_get_what_a_test_has_printed() {
    let folder = cell(&[("testA", "? \"fine\""), ("testB", "? \"<b>\"\nputln(\"page\")\n? sqrt(-1)")]);
    expect![[r#"
        <?xml version="1.0" encoding="UTF-8"?>
        <testsuites name="val3 test" tests="2" failures="1" time="…">
          <testsuite name="mainTest" tests="2" failures="1" errors="0" skipped="0" time="…">
            <properties>
              <property name="controllerSeconds.testA" value="0.004"/>
              <property name="controllerSeconds.testB" value="0.004"/>
            </properties>
            <testcase name="testA" classname="mainTest" time="…">
              <system-out>| fine</system-out>
            </testcase>
            <testcase name="testB" classname="mainTest" time="…">
              <failure message="error 11: invalid numeric value">error 11: invalid numeric value
        at mainTest:testB (usrapp/mainTest/testB.pgx:7)
            7 │ ? sqrt(-1)</failure>
              <system-out>| &lt;b&gt;
        the screen shows:
        +
        | page
        last events:
          0.000 s  error 11: invalid numeric value at testB:7 (task `mainTest~`)</system-out>
            </testcase>
          </testsuite>
        </testsuites>
    "#]]
    .assert_eq(&timeless(&folder.val3(&["test", "usrapp", "--format", "junit"]).stdout));
    let json: Value = serde_json::from_str(&folder.val3(&["test", "usrapp", "--format", "json"]).stdout).unwrap();
    let events = json["tests"][1]["events"].as_array().unwrap();
    let files: Vec<&str> = events.iter().filter_map(|event| event["file"].as_str()).collect();
    assert_eq!(files, ["usrapp/mainTest/testB.pgx"], "{json}");
}

/// Runs tests of which the second never ends, and sends a signal after the first test.
#[cfg(unix)]
fn interrupted(signal: &str, options: &[&str]) -> (i32, String, crate::support::Folder) {
    let folder = cell(&[("testA", "? \"a\""), ("testB", "while true\nendWhile"), ("testC", "")]);
    let arguments = [&["test", "usrapp", "--jobs", "1", "--limit", "1e6"], options].concat();
    let mut child = folder.command(&arguments).stdout(Stdio::piped()).stderr(Stdio::null()).spawn().unwrap();
    let mut output = BufReader::new(child.stdout.take().unwrap());
    let mut text = String::new();
    // The output is written during the execution.
    while !text.contains("testA") {
        assert_ne!(output.read_line(&mut text).unwrap(), 0, "{text}");
    }
    assert!(Command::new("kill").args([signal, &child.id().to_string()]).status().unwrap().success());
    for line in output.lines() {
        text += &line.unwrap();
        text.push('\n');
    }
    (child.wait().unwrap().code().unwrap(), text, folder)
}

#[cfg(unix)]
#[test]
fn an_interrupted_run_writes_all_reports() {
    let outputs = ["--output=junit=junit.xml", "--output=json=tests.json", "--output=tap=tests.tap"];
    let (code, text, folder) = interrupted("-TERM", &outputs);
    assert_eq!(code, 143, "{text}");
    expect![[r#"
        mainTest
          ok    testA (0.004 s)
        1 passed, 0 failed, 2 not run, because the run was interrupted
    "#]]
    .assert_eq(&text);
    expect![[r#"
        <?xml version="1.0" encoding="UTF-8"?>
        <testsuites name="val3 test" tests="3" failures="0" time="…">
          <testsuite name="mainTest" tests="3" failures="0" errors="0" skipped="2" time="…">
            <properties>
              <property name="controllerSeconds.testA" value="0.004"/>
            </properties>
            <testcase name="testA" classname="mainTest" time="…">
              <system-out>| a</system-out>
            </testcase>
            <testcase name="testB" classname="mainTest" time="…">
              <skipped message="not run, because the run was interrupted"/>
            </testcase>
            <testcase name="testC" classname="mainTest" time="…">
              <skipped message="not run, because the run was interrupted"/>
            </testcase>
          </testsuite>
        </testsuites>
    "#]]
    .assert_eq(&timeless(&folder.read("junit.xml")));
    expect![[r#"
        TAP version 14
        1..3
        ok 1 - mainTest:testA
        ok 2 - mainTest:testB # SKIP not run, because the run was interrupted
        ok 3 - mainTest:testC # SKIP not run, because the run was interrupted
        Bail out! The run was interrupted
    "#]]
    .assert_eq(&folder.read("tests.tap"));
    let json: Value = serde_json::from_str(&folder.read("tests.json")).unwrap();
    let not_run: Vec<&str> =
        json["notRun"].as_array().unwrap().iter().filter_map(|test| test["name"].as_str()).collect();
    assert_eq!((&json["interrupted"], not_run), (&Value::Bool(true), vec!["mainTest:testB", "mainTest:testC"]));
    let (code, text, _) = interrupted("-INT", &["--coverage"]);
    assert_eq!((code, text.contains("2 not run, because the run was interrupted")), (130, true), "{text}");
}

#[test]
fn a_page_shows_failures_and_escapes_texts() {
    let folder = cell(&[("testA", "? \"<b>&\""), ("testB", "? \"<i>\"\ncall assert:equalString(\"<a>\",\"<b>\")")]);
    let run = folder.val3(&["test", "usrapp", "--output", "html=report.html"]);
    assert_eq!(run.code, 1, "{run:?}");
    let page = folder.read("report.html");
    assert!(page.starts_with("<!DOCTYPE html>") && page.ends_with("</html>\n"), "{page}");
    assert!(page.contains("<p>1 passed, 1 failed, in "), "{page}");
    assert!(page.contains("<details id=\"mainTest:testB\" class=\"failed\" open><summary><b>✗</b> testB"), "{page}");
    assert!(page.contains("&quot;&lt;a&gt;&quot; instead of &quot;&lt;b&gt;&quot;"), "{page}");
    assert!(page.contains("class=\"passed\"><summary><b>✓</b> testA"), "{page}");
    assert!(page.contains("<li><a href=\"#mainTest:testB\">mainTest:testB</a>: "), "{page}");
    assert!(!page.contains("<i>") && !page.contains("<a>\""), "{page}");
}
