//! `val3 test`: complete applications with tests.

use std::fs::{self, File};
use std::io::{BufRead as _, BufReader};
use std::process::Stdio;

use expect_test::expect;
use serde_json::{Value, json};

use crate::support::{CommandOutput, Folder};
use crate::watch::Watching;

/// An application `main`, its tests `mainTest`, and the test programs with their code.
pub(crate) fn cell(programs: &[(&str, &str)]) -> Folder {
    let folder = Folder::with("num nCount\nnCount=1\n");
    let written = folder.val3(&["test", "--init", "usrapp/main"]);
    assert_eq!(written.code, 0, "{written:?}");
    let project = folder.read("usrapp/mainTest/mainTest.pjx");
    let names = programs.iter().map(|(name, _)| format!("    <Program file=\"{name}.pgx\" />\n")).collect::<String>();
    let project = project.replace("  </Programs>", &(names + "  </Programs>"));
    // `testFirst` belongs to the template and is removed.
    folder.write("usrapp/mainTest/mainTest.pjx", &project.replace("    <Program file=\"testFirst.pgx\" />\n", ""));
    fs::remove_file(folder.path().join("usrapp/mainTest/testFirst.pgx")).unwrap();
    folder.write("usrapp/mainTest/start.pgx", &program("start", ""));
    for (name, code) in programs {
        folder.write(&format!("usrapp/mainTest/{name}.pgx"), &program(name, code));
    }
    folder
}

pub(crate) fn program(name: &str, code: &str) -> String {
    let namespace = "http://www.staubli.com/robotics/VAL3/Program/2";
    format!(
        "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<Programs xmlns=\"{namespace}\">\n  <Program name=\"{name}\" \
         access=\"public\">\n    <Code><![CDATA[begin\n{code}\nend]]></Code>\n  </Program>\n</Programs>\n"
    )
}

fn tested(programs: &[(&str, &str)], options: &[&str]) -> CommandOutput {
    cell(programs).val3(&[&["test", "usrapp"], options].concat())
}

#[test]
fn the_first_test_passes() {
    let folder = Folder::with("num nCount\nnCount=1\n");
    assert_eq!(folder.val3(&["test", "--init", "usrapp/main"]).code, 0);
    for path in ["usrapp", "usrapp/mainTest", "."] {
        let run = folder.val3(&["test", path]);
        assert_eq!((run.code, run.stdout.lines().last()), (0, Some("1 passed, 0 failed")), "{run:?}");
    }
    let check = folder.val3(&["check", "usrapp/mainTest", "usrapp/val3assert", "--fail-level", "info"]);
    assert_eq!(check.code, 0, "{check:?}");
    folder.write("usrapp/mainTest/testFirst.pgx", "mine");
    let again = folder.val3(&["test", "--init", "usrapp/main"]);
    assert!(again.stderr.contains("exists and stays unchanged"), "{again:?}");
    assert_eq!(folder.read("usrapp/mainTest/testFirst.pgx"), "mine");
}

#[test]
fn failures_show_the_line_the_programs_and_the_output() {
    let run = tested(
        &[
            ("testSum", "? \"first\"\ncall assert:equalNum(1+1,2,0)\ncall sum()"),
            ("sum", "call assert:equalNum(1+1,3,0.5)"),
            ("testError", "? sqrt(-1)"),
            ("testWait", "wait(false)"),
        ],
        &["--limit", "5"],
    );
    assert_eq!(run.code, 1, "{run:?}");
    expect![[r#"
        mainTest
          FAIL  testError (0.004 s)
                error 11: invalid numeric value
                at mainTest:testError (usrapp/mainTest/testError.pgx:5)
                    5 │ ? sqrt(-1)
                last events:
                  0.000 s  error 11: invalid numeric value at testError:5 (task `mainTest~`)
          FAIL  testSum (0.004 s)
                2 instead of 3 (1 away, tolerance 0.5)
                at mainTest:sum (usrapp/mainTest/sum.pgx:5)
                    5 │ call assert:equalNum(1+1,3,0.5)
                at mainTest:testSum (usrapp/mainTest/testSum.pgx:7)
                | first
          FAIL  testWait (5.000 s)
                not ended after 5 s: it waits for a condition
                at mainTest:testWait (usrapp/mainTest/testWait.pgx:5)
                    5 │ wait(false)
        failures:
          usrapp/mainTest/testError.pgx:5: mainTest:testError: error 11: invalid numeric value
          usrapp/mainTest/sum.pgx:5: mainTest:testSum: 2 instead of 3 (1 away, tolerance 0.5)
          usrapp/mainTest/testWait.pgx:5: mainTest:testWait: not ended after 5 s: it waits for a condition
        0 passed, 3 failed
    "#]]
    .assert_eq(&run.stdout);
}

#[test]
fn errors_can_be_expected() {
    let run = tested(
        &[
            ("testRaised", "call assert:expectError(11)\n? sqrt(-1)\ncall assert:fail(\"reached\")"),
            ("testOther", "call assert:expectError(20)\n? sqrt(-1)"),
            ("testUnraised", "call assert:expectError(11)"),
        ],
        &["--format", "tap"],
    );
    expect![[r#"
        TAP version 14
        1..3
        not ok 1 - mainTest:testOther
        # error 11: invalid numeric value
        #   instead of error 20 (index too large), which `expectError` expects
        # at mainTest:testOther (usrapp/mainTest/testOther.pgx:6)
        #     6 │ ? sqrt(-1)
        # at expectError(20) (usrapp/mainTest/testOther.pgx:5)
        ok 2 - mainTest:testRaised
        not ok 3 - mainTest:testUnraised
        # error 11 (invalid numeric value) was expected, and nothing has raised it
        # at mainTest:testUnraised (usrapp/mainTest/testUnraised.pgx:5)
        #     5 │ call assert:expectError(11)
    "#]]
    .assert_eq(&run.stdout);
}

#[test]
fn each_test_begins_in_the_initial_state_between_setup_and_teardown() {
    let programs = [
        ("setup", "setProfile(\"default\",\"\")\n? \"setup\""),
        ("teardown", "? \"teardown\""),
        (
            "testOne",
            "? clock()<0.1\nlibDelete(\"Disk://gone\")\ntaskCreate \"other\",10,other()\ncall assert:fail(\"1\")",
        ),
        ("testTwo", "? clock()<0.1\n? taskStatus(\"other\")\ncall assert:fail(\"2\")"),
        ("other", "delay(1000)"),
    ];
    let folder = cell(&programs);
    folder.write("usrapp/gone/gone.pjx", "<Project />");
    let run = folder.val3(&["test", "usrapp", "--format", "json", "--jobs", "1"]);
    let report: Value = serde_json::from_str(&run.stdout).unwrap();
    let prints = |test: usize| report["tests"][test]["prints"].clone();
    assert_eq!(prints(0), json!(["setup", "true", "teardown"]), "{}", run.stdout);
    assert_eq!(prints(1), json!(["setup", "true", "-1", "teardown"]), "{}", run.stdout);
    // Tests change files only in memory.
    assert_eq!(folder.read("usrapp/gone/gone.pjx"), "<Project />");
}

#[test]
fn results_are_the_same_in_any_order_on_any_number_of_threads() {
    let names: Vec<String> = (10..40).map(|number| format!("test{number}")).collect();
    let programs: Vec<_> =
        names.iter().map(|name| (name.as_str(), "? clock()\ncall assert:isTrue(clock()<1,\"\")")).collect();
    let folder = cell(&programs);
    let run = |options: &[&str]| folder.val3(&[&["test", "usrapp"], options].concat()).stdout;
    let expected = run(&["--jobs", "1"]);
    assert!(expected.ends_with("30 passed, 0 failed\n"), "{expected}");
    assert_eq!(run(&["--jobs", "4", "--seed", "1"]), expected);
    assert_eq!(run(&["--jobs", "2", "--seed", "99"]), expected);
    let parts: Vec<usize> = ["1/3", "2/3", "3/3"].map(|part| run(&["--shard", part, "--list"]).lines().count()).into();
    assert_eq!(parts, [10, 10, 10]);
    assert_eq!(run(&["--filter", "test1", "--list"]).lines().count(), 10);
    assert!(run(&["--filter", "test11", "--repeat", "5"]).ends_with("5 passed, 0 failed\n"));
}

#[test]
fn tests_are_chosen_by_their_whole_name() {
    let folder = cell(&[("testA", ""), ("testAll", ""), ("testB", "")]);
    let run = |options: &[&str]| folder.val3(&[&["test", "usrapp", "--list"], options].concat());
    assert_eq!(run(&["--exact", "mainTest:testA"]).stdout, "mainTest:testA\n");
    let two = run(&["--exact", "mainTest:testB", "--exact", "mainTest:testA"]);
    assert_eq!(two.stdout, "mainTest:testA\nmainTest:testB\n");
    assert_eq!(run(&["--exact", "mainTest:testA", "--filter", "B"]).stdout, "");
    let unknown = run(&["--exact", "mainTest:testC"]);
    assert_eq!((unknown.code, unknown.stderr.contains("did you mean `mainTest:testA`")), (2, true), "{unknown:?}");
}

/// Parses each output line as an object.
fn lines(output: &str) -> Vec<Value> {
    output.lines().map(|line| serde_json::from_str(line).unwrap()).collect()
}

/// Removes real times from an object.
pub(crate) fn without_times(mut object: Value) -> Value {
    match &mut object {
        Value::Object(keys) => {
            keys.remove("wallSeconds");
            keys.values_mut().for_each(|value| *value = without_times(value.take()));
        }
        Value::Array(values) => values.iter_mut().for_each(|value| *value = without_times(value.take())),
        _ => {}
    }
    object
}

/// Removes real times from a report.
pub(crate) fn timeless(report: &str) -> String {
    report.lines().map(timeless_line).collect()
}

fn timeless_line(line: &str) -> String {
    if line.contains("\"wallSeconds\"") {
        return String::new();
    }
    let Some((before, after)) = line.split_once(" time=\"") else { return format!("{line}\n") };
    let after = after.split_once('"').map_or("", |(_, after)| after);
    format!("{before} time=\"…\"{after}\n")
}

#[test]
fn programs_follow_the_execution_line_by_line() {
    let run =
        tested(&[("testA", ""), ("testB", "call assert:equalNum(1,2,0)")], &["--format", "json-lines", "--jobs", "1"]);
    assert_eq!(run.code, 1, "{run:?}");
    let lines = lines(&run.stdout);
    let kinds: Vec<_> = lines.iter().map(|line| (&line["kind"], &line["test"]["name"])).collect();
    let expected = json!([
        ["started", "mainTest:testA"],
        ["finished", "mainTest:testA"],
        ["started", "mainTest:testB"],
        ["finished", "mainTest:testB"],
        ["summary", null],
    ]);
    assert_eq!(json!(kinds), expected);
    // A test object equals the object of the format `json`.
    let whole = tested(&[("testA", ""), ("testB", "call assert:equalNum(1,2,0)")], &["--format", "json"]);
    let whole: Value = serde_json::from_str(&whole.stdout).unwrap();
    let lines: Vec<Value> = lines.into_iter().map(without_times).collect();
    assert_eq!(json!([lines[1]["test"], lines[3]["test"]]), without_times(whole)["tests"]);
    let summary = json!({
        "kind": "summary",
        "version": 1,
        "passed": 1,
        "failed": 1,
        "skipped": 0,
        "knownFailures": 0,
        "interrupted": false,
        "notRun": [],
    });
    assert_eq!(lines[4], summary);
}

#[test]
fn lines_are_written_while_tests_are_executed() {
    let folder = cell(&[("testA", ""), ("testB", "while true\nendWhile")]);
    let arguments = ["test", "usrapp", "--format", "json-lines", "--jobs", "1", "--limit", "1e6"];
    let mut child = folder.command(&arguments).stdout(Stdio::piped()).spawn().unwrap();
    let mut output = BufReader::new(child.stdout.take().unwrap()).lines();
    for expected in ["started", "finished", "started"] {
        let line: Value = serde_json::from_str(&output.next().unwrap().unwrap()).unwrap();
        assert_eq!(line["kind"], expected, "{line}");
    }
    child.kill().unwrap();
    child.wait().unwrap();
}

#[test]
fn editors_list_the_tests_of_all_applications_that_have_some() {
    let folder = cell(&[("testA", "")]);
    let application = json!({
        "name": "mainTest", "folder": "usrapp/mainTest", "file": "usrapp/mainTest/mainTest.pjx", "error": null,
        "tests": [{
            "id": "mainTest:testA", "name": "mainTest:testA", "application": "mainTest", "program": "testA",
            "row": null, "file": "usrapp/mainTest/testA.pgx", "line": 1,
        }],
    });
    assert_eq!(list(&folder), json!({ "version": 1, "applications": [application] }));
    folder.write("usrapp/mainTest/testA.pgx", &program("testA", "nUnknown=1"));
    let listed = list(&folder);
    let refused = &listed["applications"][0];
    assert_eq!(refused["tests"], Value::Null);
    assert!(refused["error"].as_str().unwrap().contains("the compiler rejects the application"), "{refused}");
    assert_eq!(list(&Folder::with("num nCount\n")), json!({ "version": 1, "applications": [] }));
}

fn list(folder: &Folder) -> Value {
    let run = folder.val3(&["test", ".", "--list", "--format", "json"]);
    assert_eq!(run.code, 0, "{run:?}");
    serde_json::from_str(&run.stdout).unwrap()
}

#[test]
fn a_run_can_end_at_the_first_failure() {
    let run = tested(&[("testA", ""), ("testB", "call assert:fail(\"b\")"), ("testC", "")], &["--fail-fast"]);
    let end = "1 passed, 1 failed, 1 not run, because --fail-fast ends at the first failure\n";
    assert!(run.stdout.ends_with(end), "{}", run.stdout);
}

#[test]
fn scripts_beside_the_program_simulate_the_cell() {
    let folder = cell(&[("testKey", "call assert:equalNum(get(),65,0)")]);
    folder.write("usrapp/mainTest/testKey.toml", "[[at]]\nt = 2\nkeys = \"A\"\n");
    let run = folder.val3(&["test", "usrapp"]);
    assert_eq!((run.code, run.stdout.contains("ok    testKey (2.")), (0, true), "{run:?}");
    folder.write("usrapp/mainTest/testKey.toml", "[[at]]\nt = 2\nkyes = \"A\"\n");
    let run = folder.val3(&["test", "usrapp"]);
    assert_eq!((run.code, run.stdout.contains("testKey.toml` cannot be used")), (2, true), "{run:?}");
}

#[test]
fn changed_tests_are_executed_again() {
    let folder = cell(&[("testA", "")]);
    let mut command = folder.command(&["test", "usrapp/mainTest", "--watch"]);
    command.stdout(File::create(folder.path().join("results.txt")).unwrap());
    let watching = Watching::of(command);
    watching.wait_for("Waiting for changes");
    assert!(folder.read("results.txt").ends_with("1 passed, 0 failed\n"));
    folder.write("usrapp/mainTest/testA.pgx", &program("testA", "call assert:fail(\"changed\")"));
    watching.wait_for("Waiting for changes");
    assert!(folder.read("results.txt").ends_with("0 passed, 1 failed\n"));
    folder.write("usrapp/mainTest/testA.pgx", &program("testA", "nUnknown=1"));
    watching.wait_for("Waiting for changes");
    assert!(folder.read("results.txt").contains("the compiler rejects the application"));
}

#[test]
fn ci_services_read_the_results() {
    let folder = cell(&[("testA", ""), ("testB", "call assert:fail(\"<b> & 50 %\")")]);
    let run = |format| folder.val3(&["test", "usrapp", "--format", format]).stdout;
    expect![[r#"
        <?xml version="1.0" encoding="UTF-8"?>
        <testsuites name="val3 test" tests="2" failures="1" time="…">
          <testsuite name="mainTest" tests="2" failures="1" errors="0" skipped="0" time="…">
            <properties>
              <property name="controllerSeconds.testA" value="0.004"/>
              <property name="controllerSeconds.testB" value="0.004"/>
            </properties>
            <testcase name="testA" classname="mainTest" time="…">
            </testcase>
            <testcase name="testB" classname="mainTest" time="…">
              <failure message="&lt;b&gt; &amp; 50 %">&lt;b&gt; &amp; 50 %
        at mainTest:testB (usrapp/mainTest/testB.pgx:5)
            5 │ call assert:fail(&quot;&lt;b&gt; &amp; 50 %&quot;)</failure>
            </testcase>
          </testsuite>
        </testsuites>
    "#]]
    .assert_eq(&timeless(&run("junit")));
    expect![[r#"
        ::error file=usrapp/mainTest/testB.pgx,line=5,title=mainTest%3AtestB::<b> & 50 %25%0Aat mainTest:testB (usrapp/mainTest/testB.pgx:5)%0A    5 │ call assert:fail("<b> & 50 %25")
    "#]]
    .assert_eq(&run("github"));
}

#[test]
fn results_are_written_to_files_too() {
    let folder = cell(&[("testA", ""), ("testB", "call assert:fail(\"b\")")]);
    let run = |options: &[&str]| folder.val3(&[&["test", "usrapp"], options].concat());
    let formats = ["human", "json", "json-lines", "junit", "tap", "github"];
    let outputs = formats.map(|format| format!("--output={format}={format}.txt"));
    let human = run(&outputs.each_ref().map(String::as_str));
    assert_eq!((human.code, &human.stdout), (1, &folder.read("human.txt")), "{human:?}");
    for format in ["json", "junit", "tap", "github"] {
        let written = timeless(&folder.read(&format!("{format}.txt")));
        assert_eq!(timeless(&run(&["--format", format]).stdout), written, "{format}");
    }
    let lines = folder.read("json-lines.txt");
    let kinds: Vec<Value> =
        lines.lines().map(|line| serde_json::from_str::<Value>(line).unwrap()["kind"].clone()).collect();
    assert_eq!(kinds, ["finished", "finished", "summary"]);
    let refused = run(&["--output", "junit=nowhere/tests.xml"]);
    assert_eq!((refused.code, refused.stderr.contains("cannot write `nowhere/tests.xml`")), (2, true), "{refused:?}");
}

#[test]
fn wrong_usage_is_explained() {
    let folder = Folder::with("num nCount\nnCount=1\n");
    for (arguments, word) in [
        (&["test", "usrapp"][..], "there are no tests here"),
        (&["test", "nowhere"], "nowhere"),
        (&["test", "--init", "usrapp"], "is not an application"),
        (&["test", "--shard", "3/2"], "write the part and the number of parts"),
        (&["test", "--limit", "0"], "write seconds"),
    ] {
        let run = folder.val3(arguments);
        assert_eq!((run.code, run.stderr.contains(word)), (2, true), "{run:?}");
    }
    let folder = cell(&[("testA", "nUnknown=1")]);
    let run = folder.val3(&["test", "usrapp"]);
    assert_eq!((run.code, run.stdout.contains("the compiler rejects the application")), (2, true), "{run:?}");
}
