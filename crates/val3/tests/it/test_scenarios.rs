//! `val3 test`: scenarios, which run complete applications, and their expectations.

use std::fs::File;

use expect_test::{Expect, expect};
use serde_json::{Value, json};

use crate::support::{CommandOutput, Folder};
use crate::watch::Watching;

const DATA: &str = r#"
=== main/main.dtx
<?xml version="1.0" encoding="utf-8"?>
<Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
  <Datas>
    <Data name="doLamp" access="private" xsi:type="array" type="dio" size="1"><Value key="0" link="Io\Lamp" /></Data>
    <Data name="diGo" access="private" xsi:type="array" type="dio" size="1"><Value key="0" link="Io\Go" /></Data>
    <Data name="siHost" access="private" xsi:type="array" type="sio" size="1"><Value key="0" link="Socket\host" /></Data>
    <Data name="nState" access="private" xsi:type="array" type="num" size="1" />
    <Data name="nMean" access="private" xsi:type="array" type="num" size="1" />
    <Data name="sText" access="private" xsi:type="array" type="string" size="1" />
  </Datas>
</Database>"#;

/// A lamp that is on from 1 s to 2 s.
const LAMP: &str = "title(\"Cell\")\nput(\"ready\")\n? \"first\"\ndelay(1)\ndoLamp=true\nnState=2\nnMean=2.45\nlogMsg(\"lamp\")\n\
                    ? \"on\"\nput(\" on\")\ndelay(1)\ndoLamp=false\nnState=3\npopUpMsg(\"off\")\n? \"last\"";

/// An application `main` whose program `start` has this code, and its scenario `tests/cell.toml`.
fn cell(code: &str, scenario: &str) -> Folder {
    let folder = Folder::with(&format!("program start()\nbegin\n{code}\nend\n{DATA}"));
    folder.write("tests/cell.toml", &format!("application = \"../usrapp/main\"\n{scenario}"));
    folder
}

fn tested(code: &str, scenario: &str) -> CommandOutput {
    cell(code, scenario).val3(&["test", "."])
}

#[track_caller]
fn check(code: &str, scenario: &str, expected: Expect) {
    let run = tested(code, scenario);
    assert_eq!(run.stderr, "");
    expected.assert_eq(&run.stdout);
}

#[track_caller]
fn check_refusal(scenario: &str, messages: &[&str]) {
    let run = tested(LAMP, scenario);
    assert_eq!(run.code, 2, "{run:?}");
    for message in messages {
        assert!(run.stdout.contains(message), "{message}: {}", run.stdout);
    }
}

#[test]
fn a_script_is_the_other_end_of_sockets() {
    let code = "sText=siHost\nsiHost=\"got \"+sText\nsText=siHost\nsiHost=\"bye\"";
    let scenario = r#"
        at = [{ t = 0.5, receive = { "Socket\\host" = "one\r" } }, { t = 1, receive = { "Socket\\host" = "two\r" } }]
        [expect]
        data = { sText = "two" }
        sent = { "Socket\\host" = "got one\rbye\r" }
        [[expect.order]]
        events = [{ sent = { "Socket\\host" = "got one" } }, { sent = { "Socket\\host" = "bye" } }]
        [[expect.within]]
        event = { sent = { "Socket\\host" = "got" } }
        seconds = 0.52
    "#;
    check(
        code,
        scenario,
        expect![[r#"
        main
          ok    cell (1.004 s)
        1 passed, 0 failed
    "#]],
    );
    // A test's outputs do not satisfy another test.
    let folder = cell(code, scenario);
    folder.write("tests/other.toml", &format!("application = \"../usrapp/main\"\n{}", scenario.replace("one", "ONE")));
    let run = folder.val3(&["test", ".", "--repeat", "2", "--jobs", "1"]);
    assert!(run.stdout.ends_with("4 passed, 0 failed\n"), "{run:?}");
    let other = scenario.replace("got one\\rbye\\r", "got two");
    check(
        code,
        &other,
        expect![[r#"
            main
              FAIL  cell (1.004 s)
                    it did not happen that "got two" is sent over `Socket\host`: the output ends with "got one\rbye\r"
                    at expect.sent (tests/cell.toml:6)
                        6 │ sent = { "Socket\\host" = "got two" }
                    last events:
                      0.500 s  Socket\host in: one (task `main~`)
                      0.500 s  Socket\host out: got one\r (task `main~`)
                      1.000 s  Socket\host in: two (task `main~`)
                      1.000 s  Socket\host out: bye\r (task `main~`)
            0 passed, 1 failed
        "#]],
    );
}

#[test]
fn the_cell_answers_what_is_sent() {
    let code = "siHost=\"GET 1\"\nsText=siHost\n? sText\nsiHost=\"GET 2\"\nsText=siHost\n? sText";
    let scenario = r#"
        [[when]]
        sent = { "Socket\\host" = "GET" }
        then = [{ after = 0.1, receive = { "Socket\\host" = "part\r" } }]
        [expect]
        print = ["part"]
    "#;
    check(
        code,
        scenario,
        expect![[r#"
        main
          ok    cell (0.212 s)
        1 passed, 0 failed
    "#]],
    );
    let run = tested(code, &format!("until = 1\n{}", scenario.replace("GET", "GET 1")));
    assert_eq!((run.code, run.stdout.contains("ok    cell (1.000 s)")), (0, true), "{run:?}");
    check_refusal(&scenario.replace("host", "hots"), &["[[when]] in line 3: there is no serial line or socket"]);
}

#[test]
fn a_cyclic_application_ends_at_its_time() {
    let code = "while true\nnState=nState+1\ndelay(1)\nendWhile";
    let run = tested(code, "until = 3.5\n[expect]\ndata = { nState = 4 }\n");
    assert_eq!((run.code, run.stdout.contains("ok    cell (3.500 s)")), (0, true), "{run:?}");
    let run = cell(code, "").val3(&["test", ".", "--limit", "5"]);
    expect![[r#"
        main
          FAIL  cell (5.000 s)
                not ended after 5 s: it waits for time (`delay`)
                at main:start (usrapp/main/start.pgx:7)
                    7 │ delay(1)
        0 passed, 1 failed
    "#]]
    .assert_eq(&run.stdout);
    // An expectation with a time is checked at its time.
    let waiting = "wait(diGo)\nnState=1";
    let run = tested(
        waiting,
        "until = 90\nat = [{ t = 60, io = { \"Io\\\\Go\" = true } }]\n[[expect.at]]\nt = 59\ndata = { nState = 0 }\n\
         [expect]\ndata = { nState = 1 }\n",
    );
    assert_eq!(run.code, 0, "{run:?}");
}

#[test]
fn the_cell_reacts_and_moves_are_seen() {
    let folder = Folder::with(
        "mdesc mStop\njoint jReady\ndio dUnused\n  mStop.blend=off\n  enablePower()\n  wait(isPowered())\n  \
         jReady={90,0,90,0,90,0}\n  movej(jReady,flange,mStop)\n  waitEndMove()\n  ? \"there\"\n",
    );
    folder.write(
        "tests/cell.toml",
        "application = \"../usrapp/main\"\n[[expect.order]]\nevents = [{ move = \"start\" }, { print = \"there\" }]\n",
    );
    let run = folder.val3(&["test", "."]);
    assert_eq!(run.code, 0, "{run:?}");
    let reacting = "doLamp=true\nwait(diGo)\n? \"go\"";
    let run = tested(
        reacting,
        "[[when]]\nio = { \"Io\\\\Lamp\" = true }\nthen = [{ after = 0.5, io = { \"Io\\\\Go\" = true } }]\n\
         [[expect.within]]\nevent = { print = \"go\" }\nafter = { io = { \"Io\\\\Lamp\" = true } }\nseconds = 0.51\n",
    );
    assert_eq!(run.code, 0, "{run:?}");
}

#[test]
fn scenarios_are_tests_like_others() {
    let folder = cell(LAMP, "[expect]\nprint = [\"first\"]\n");
    let failing = "application = \"../../usrapp/main/main.pjx\"\n[expect]\nprint = [\"none\"]\nlog = [\"none\"]\n";
    folder.write("tests/more/failing.toml", failing);
    folder.write("tests/golden/data.toml", "x = 1\n");
    folder.write("scripts/cell.toml", "application = \"../usrapp/main\"\n");
    for path in [".", "tests"] {
        assert_eq!(folder.val3(&["test", path, "--list"]).stdout, "main:cell\nmain:failing\n", "{path}");
    }
    assert_eq!(folder.val3(&["test", "tests/cell.toml", "--list"]).stdout, "main:cell\n");
    assert_eq!(folder.val3(&["test", "scripts/cell.toml", "--list"]).stdout, "main:cell\n");
    assert_eq!(folder.val3(&["test", ".", "--filter", "fail", "--list"]).stdout, "main:failing\n");
    assert_eq!(folder.val3(&["test", ".", "--shard", "2/2", "--list"]).stdout, "main:failing\n");
    let run = folder.val3(&["test", ".", "--format", "json", "--seed", "3"]);
    let report: Value = serde_json::from_str(&run.stdout).unwrap();
    let failure = &report["tests"][1]["failure"];
    let place = |line: u32, key: &str, source: &str| json!([{ "program": key, "file": "tests/more/failing.toml", "line": line, "source": source }]);
    assert_eq!(failure["places"], place(3, "expect.print", "print = [\"none\"]"), "{}", run.stdout);
    assert_eq!(failure["others"][0]["places"], place(4, "expect.log", "log = [\"none\"]"), "{}", run.stdout);
    let github = folder.val3(&["test", ".", "--format", "github"]).stdout;
    let lines: Vec<&str> = github.lines().map(|line| line.split_once(",title").unwrap().0).collect();
    assert_eq!(lines, ["::error file=tests/more/failing.toml,line=3", "::error file=tests/more/failing.toml,line=4"]);
    folder.write("val3.toml", "exclude = [\"tests/more\"]\n");
    assert_eq!(folder.val3(&["test", ".", "--list"]).stdout, "main:cell\n");
    assert_eq!(folder.val3(&["test", "tests/more", "--list"]).stdout, "main:failing\n");
    // A scenario is also a run script.
    assert_eq!(folder.val3(&["run", "usrapp/main", "--script", "tests/cell.toml"]).code, 0);
}

#[test]
fn files_that_cannot_be_used_are_explained() {
    check_refusal("[expect]\nscren = [\"a\"]\n", &["tests/cell.toml", "line 3", "unknown field `scren`", "`screen`"]);
    check_refusal("[expect]\nscreen = 1\n", &["line 3", "expected a sequence"]);
    check_refusal("until = -1\n", &["-1 is not a time"]);
    check_refusal("until = 1e300\n", &["is not a time"]);
    check_refusal("program = \"strat\"\n", &["line 2: there is no program `strat`; did you mean `start`?"]);
    check_refusal("[[expect.order]]\nevents = [{ prnt = \"a\" }]\n", &["unknown variant `prnt`", "`print`"]);
    check_refusal("[[expect.order]]\nevents = [{ print = \"a\", log = \"b\" }]\n", &["line 3"]);
    check_refusal("[[expect.within]]\nevent = { print = \"a\" }\n", &["missing field `seconds`"]);
    check_refusal("[[expect.order]]\nevents = [{ data = {} }]\n", &["a condition needs"]);
    let folder = cell(LAMP, "");
    for (scenario, message) in [
        ("application = \"../usrapp/none\"\n", "there is no such file or folder"),
        ("application = \"..\"\n[expect]\n", "holds 2 applications"),
        ("application = 1\n", "expected a string"),
        ("application = \"\n", "cell.toml"),
    ] {
        folder.write("tests/cell.toml", scenario);
        folder.write("usrapp/second/second.pjx", &folder.read("usrapp/main/main.pjx"));
        let run = folder.val3(&["test", "tests"]);
        assert_eq!((run.code, run.stdout.contains(message)), (2, true), "{scenario}: {run:?}");
        assert!(run.stdout.contains("tests/cell.toml"), "{run:?}");
    }
    folder.write("tests/cell.toml", "until = 1\n");
    let run = folder.val3(&["test", "tests/cell.toml"]);
    assert_eq!((run.code, run.stdout.contains("it names no application")), (2, true), "{run:?}");
    let run = cell("nUnknown=1", "").val3(&["test", "tests"]);
    assert_eq!((run.code, run.stdout.contains("the compiler rejects the application")), (2, true), "{run:?}");
}

#[test]
fn test_programs_have_expectations_too() {
    let folder = Folder::with("num nCount\nnCount=1\n");
    assert_eq!(folder.val3(&["test", "--init", "usrapp/main"]).code, 0);
    let program = folder.read("usrapp/mainTest/testFirst.pgx");
    let (head, rest) = program.split_once("begin").unwrap();
    let (_, tail) = rest.split_once("\nend").unwrap();
    folder.write("usrapp/mainTest/testFirst.pgx", &format!("{head}begin\n? \"said\"\n? sqrt(-1)\nend{tail}"));
    let run = expecting(&folder, "[expect]\nprint = [\"said\"]\nerrors = [{ code = 11 }]\n");
    assert_eq!(run.code, 0, "{run:?}");
    let run = expecting(&folder, "[expect]\nprint = [\"unsaid\"]\nerrors = [{ code = 20 }]\n");
    expect![[r#"
        mainTest
          FAIL  testFirst (0.004 s)
                error 11: invalid numeric value
                at mainTest:testFirst (usrapp/mainTest/testFirst.pgx:6)
                    6 │ ? sqrt(-1)
                error 20 was expected, and nothing has raised it
                at expect.errors (usrapp/mainTest/testFirst.toml:3)
                    3 │ errors = [{ code = 20 }]
                no printed line contains "unsaid": the last ones
                | said
                at expect.print (usrapp/mainTest/testFirst.toml:2)
                    2 │ print = ["unsaid"]
                | said
                last events:
                  0.000 s  error 11: invalid numeric value at testFirst:6 (task `mainTest~`)
        0 passed, 1 failed
    "#]]
    .assert_eq(&run.stdout);
    let run = expecting(&folder, "application = \"../main\"\n");
    assert_eq!((run.code, run.stdout.contains("`application` is a key of scenarios")), (2, true), "{run:?}");
}

/// Executes the tests with these expectations of the first test.
fn expecting(folder: &Folder, expectations: &str) -> CommandOutput {
    folder.write("usrapp/mainTest/testFirst.toml", expectations);
    folder.val3(&["test", "usrapp"])
}

#[test]
fn changed_scenarios_are_executed_again() {
    let folder = cell(LAMP, "[expect]\nprint = [\"first\"]\n");
    let mut command = folder.command(&["test", "tests/cell.toml", "--watch"]);
    command.stdout(File::create(folder.path().join("results.txt")).unwrap());
    let watching = Watching::of(command);
    watching.wait_for("Waiting for changes");
    assert!(folder.read("results.txt").ends_with("1 passed, 0 failed\n"));
    folder.write("tests/cell.toml", "application = \"../usrapp/main\"\n[expect]\nprint = [\"none\"]\n");
    watching.wait_for("Waiting for changes");
    assert!(folder.read("results.txt").ends_with("0 passed, 1 failed\n"));
    folder.write("tests/cell.toml", "application = \"../usrapp/none\"\n");
    watching.wait_for("Waiting for changes");
    assert!(folder.read("results.txt").contains("the scenario `tests/cell.toml` cannot be executed"));
}
