//! `val3 test`: skipped tests, known failures, and controller properties of a test.

use expect_test::expect;
use serde_json::{Value, json};

use crate::support::Folder;

const TESTS: &str = r#"
num nUnused
--- palTest
library assert "Disk://val3assert/val3assert.pjx"
num nOne[3]
num nOther[3]
program testAbout()
begin
  call assert:about("sum")
  call assert:equalNum(1,2,0)
end
program testArray()
begin
  nOther[2]=1
  call assert:equalNums(nOne,nOther,0.5)
end
program testContains()
begin
  call assert:notEqualNum(1,2,0.5)
  call assert:notEqualString("a","b")
  call assert:contains("abc","bc")
  call assert:contains("abc","cb")
end
program testKnown()
begin
  call assert:knownFailure("the scale is wrong")
  call assert:equalNum(1,2,0)
end
program testPasses()
begin
  call assert:knownFailure("the scale was wrong")
end
program testSkip()
begin
  call assert:skip("no scale here")
  call assert:fail("not reached")
end
"#;

fn folder() -> Folder {
    let folder = Folder::with(TESTS);
    for (name, text) in val3_suite::library::files(val3_lang::types::Arm::SixAxis) {
        folder.write(&format!("usrapp/val3assert/{name}"), &text);
    }
    folder
}

#[test]
fn exempt_tests_are_counted_and_explained() {
    let folder = folder();
    let run =
        folder.val3(&["test", ".", "--output", "tap=t.tap", "--output", "junit=t.xml", "--output", "json=t.json"]);
    assert_eq!((run.code, run.stderr.as_str()), (1, ""), "{run:?}");
    let lines = run.stdout.lines().filter(|line| !line.contains(" at ") && !line.contains('│'));
    expect![[r#"
        palTest
          FAIL  testAbout (0.004 s)
                sum: 1 instead of 2 (1 away, tolerance 0)
          FAIL  testArray (0.004 s)
                [2]: 0 instead of 1
          FAIL  testContains (0.004 s)
                "abc" does not contain "cb"
          xfail  testKnown (0.008 s)
                known failure: the scale is wrong
                1 instead of 2 (1 away, tolerance 0)
          FAIL  testPasses (0.008 s)
                it passes, although it says that it fails (the scale was wrong): remove this statement
          skip  testSkip (0.004 s)
                skipped: no scale here
        failures:
          usrapp/palTest/testAbout.pgx:6: palTest:testAbout: sum: 1 instead of 2 (1 away, tolerance 0)
          usrapp/palTest/testArray.pgx:6: palTest:testArray: [2]: 0 instead of 1
          usrapp/palTest/testContains.pgx:8: palTest:testContains: "abc" does not contain "cb"
          usrapp/palTest/testPasses.pgx:5: palTest:testPasses: it passes, although it says that it fails (the scale was wrong): remove this statement
        0 passed, 4 failed, 1 skipped, 1 with a known failure
    "#]]
    .assert_eq(&lines.map(|line| format!("{line}\n")).collect::<String>());
    let tap = folder.read("t.tap");
    let may_fail = concat!("not ok 4 - palTest:testKnown # TO", "DO the scale is wrong\n");
    assert!(tap.contains(may_fail), "{tap}");
    assert!(tap.contains("ok 6 - palTest:testSkip # SKIP no scale here\n"), "{tap}");
    let junit = folder.read("t.xml");
    assert!(junit.contains(r#"tests="6" failures="4" errors="0" skipped="2""#), "{junit}");
    let report: Value = serde_json::from_str(&folder.read("t.json")).unwrap();
    assert_eq!(report["tests"][5]["exemption"], json!({ "kind": "skipped", "reason": "no scale here" }));
    assert_eq!(report["tests"][3]["exemption"]["failures"][0]["message"], "1 instead of 2 (1 away, tolerance 0)");
    let run = folder.val3(&["test", ".", "--exact", "palTest:testSkip", "--exact", "palTest:testKnown"]);
    assert!(
        run.code == 0 && run.stdout.ends_with("0 passed, 0 failed, 1 skipped, 1 with a known failure\n"),
        "{run:?}"
    );
}

#[test]
fn files_of_tests_skip_and_choose_the_controller() {
    let folder = folder();
    folder.write("usrapp/palTest/testAbout.toml", "skip = \"later\"\n");
    folder.write("usrapp/palTest/testArray.toml", "known_failure = \"the array\"\n");
    folder.write("usrapp/palTest/testPasses.toml", "known_failure = \" \"\n");
    let run = folder.val3(&["test", ".", "--filter", "testA"]);
    assert!(
        run.code == 0 && run.stdout.ends_with("0 passed, 0 failed, 1 skipped, 1 with a known failure\n"),
        "{run:?}"
    );
    let run = folder.val3(&["test", ".", "--filter", "testPasses"]);
    assert!(run.code == 2 && run.stdout.contains("write the reason"), "{run:?}");
}

const ARM: &str = r#"
joint jHere
program start()
begin
  jHere=herej()
  ? jHere
  ? isPowered()
  ? getMonitorSpeed()
  delay(100)
end
program stop()
begin
end
"#;

#[test]
fn a_scenario_chooses_arm_start_power_and_limit() {
    let folder = Folder::with(ARM);
    let scenario = "application = \"../usrapp/main\"\narm = \"tx2-60l\"\nstart = [10, 0, 90, 0, 90, 0]\npower = true\n\
                    monitor_speed = 40\nlimit = 3\nsilent = []\n";
    folder.write("tests/cell.toml", scenario);
    folder.write("tests/other.toml", "application = \"../usrapp/main\"\nuntil = 1\n");
    let run = folder.val3(&["test", ".", "--format", "json"]);
    let report: Value = serde_json::from_str(&run.stdout).unwrap_or_else(|_| panic!("{run:?}"));
    let prints = |number: usize| report["tests"][number]["prints"].clone();
    assert_eq!(prints(0), json!(["{10,0,90,0,90,0}", "true", "40"]));
    assert_eq!(prints(1), json!(["{0,0,0,0,0,0}", "false", "100"]));
    assert!(run.stdout.contains("not ended after 3 s"), "{run:?}");
    // A scenario file is also a run script.
    let run = folder.val3(&["run", "usrapp/main", "--script", "tests/cell.toml", "--until", "1", "--until-ok"]);
    assert!(run.stdout.contains("{10,0,90,0,90,0}") && run.stdout.contains("true"), "{run:?}");
    for (key, message) in [
        ("arm = \"tx2-61\"", "tx2-61"),
        ("start = [1, 2]", "6"),
        ("monitor_speed = 120", "120 is no monitor speed: write 0 to 100 per cent"),
        ("limit = -1", "-1 is not a time"),
    ] {
        folder.write("tests/cell.toml", &format!("application = \"../usrapp/main\"\nuntil = 1\n{key}\n"));
        let run = folder.val3(&["test", "tests/cell.toml"]);
        assert!(run.code == 2 && run.stdout.contains(message), "{key}: {run:?}");
    }
}

const TABLE: &str = r#"
num nUnused
--- palTest
num nIn[3]
bool bSeen
program testRow(num x_nCase)
begin
  ? nIn[x_nCase]
  delay(1)
  ? bSeen
end
"#;

#[test]
fn a_row_has_a_script_of_its_own() {
    let folder = Folder::with(TABLE);
    folder.write("usrapp/palTest/testRow[1].toml", "[[at]]\nt = 0.5\nset = { bSeen = true }\n");
    let run = folder.val3(&["test", ".", "--format", "json"]);
    let report: Value = serde_json::from_str(&run.stdout).unwrap_or_else(|_| panic!("{run:?}"));
    let seen: Vec<&Value> = report["tests"].as_array().unwrap().iter().map(|test| &test["prints"][1]).collect();
    assert_eq!(seen, ["false", "true", "false"]);
    folder.write("usrapp/palTest/testRow[3].toml", "[[at]]\nt = 0.5\nset = { bSeen = true }\n");
    let run = folder.val3(&["test", "."]);
    let message =
        "the script `usrapp/palTest/testRow[3].toml` belongs to no test: `testRow` has 3 rows, counted from 0";
    assert!(run.code == 2 && run.stdout.contains(message), "{run:?}");
}

#[test]
fn tests_are_chosen_by_tags_and_earlier_results() {
    let folder = folder();
    folder.write("usrapp/palTest/testAbout.toml", "tags = [\"slow\", \"sum\"]\n");
    folder.write("usrapp/palTest/testArray.toml", "tags = [\"slow\"]\n");
    let listed = |args: &[&str]| listed_tests(&folder, args);
    assert_eq!(listed(&["--tag", "slow"]), (0, "About Array".to_owned()));
    assert_eq!(listed(&["--tag", "slow", "--tag-out", "sum"]), (0, "Array".to_owned()));
    assert_eq!(listed(&["--tag-out", "slow"]), (0, "Contains Known Passes Skip".to_owned()));
    let run = folder.val3(&["test", ".", "--tag", "fast"]);
    assert!(run.code == 2 && run.stderr.contains("there is no test with the tag `fast`"), "{run:?}");

    folder.val3(&["test", ".", "--output", "json=report.json"]);
    assert_eq!(listed(&["--failed-in", "report.json"]), (0, "About Array Contains Passes".to_owned()));
    let parts: Vec<String> =
        (1..=2).map(|part| listed(&["--shard", &format!("{part}/2"), "--timings", "report.json"]).1).collect();
    let mut all: Vec<&str> = parts.iter().flat_map(|part| part.split(' ')).collect();
    all.sort_unstable();
    assert_eq!(all, ["About", "Array", "Contains", "Known", "Passes", "Skip"]);
    folder.val3(&["test", ".", "--exact", "palTest:testSkip", "--output", "json=report.json"]);
    let run = folder.val3(&["test", ".", "--failed-in", "report.json"]);
    assert!(run.code == 2 && run.stderr.contains("there is no test that has failed in `report.json`"), "{run:?}");
    folder.write("report.json", "{}");
    let run = folder.val3(&["test", ".", "--failed-in", "report.json"]);
    assert!(run.code == 2 && run.stderr.contains("`report.json` is no report of tests"), "{run:?}");
}

/// Exit code of `--list`, and the short names of the listed tests.
fn listed_tests(folder: &Folder, args: &[&str]) -> (i32, String) {
    let run = folder.val3(&[&["test", ".", "--list"], args].concat());
    (run.code, run.stdout.lines().map(|line| line.replace("palTest:test", "")).collect::<Vec<_>>().join(" "))
}

#[test]
fn failed_tests_are_executed_again_and_the_slowest_are_listed() {
    let args = ["test", ".", "--filter", "testAbout", "--retries", "2", "--durations", "5", "--output", "json=r.json"];
    let folder = folder();
    let run = folder.val3(&args);
    assert_eq!(run.code, 1, "{run:?}");
    assert!(run.stdout.contains("testAbout (0.004 s), at each of 3 attempts\n"), "{run:?}");
    assert!(run.stdout.contains("slowest tests:\n") && run.stdout.contains(" s  palTest:testAbout\n"), "{run:?}");
    let report: Value = serde_json::from_str(&folder.read("r.json")).unwrap();
    assert_eq!(report["tests"][0]["attempts"], 3);
}

const FEEDER: &str = r#"
library feeder "Disk://feeder/feeder.pjx"
num nParts
program start()
begin
  call feeder:next(nParts)
end
program stop()
begin
end
--- feeder
public program next(num& x_nParts)
begin
  x_nParts=1
end
--- stubs/feeder
public program next(num& x_nParts)
begin
  x_nParts=9
end
"#;

#[test]
fn a_scenario_replaces_a_library() {
    let folder = Folder::with(FEEDER);
    folder.write("tests/own.toml", &scenario("", 1));
    folder.write("tests/stub.toml", &scenario("replace = { feeder = \"../usrapp/stubs/feeder\" }", 9));
    let run = folder.val3(&["test", ".", "--jobs", "1"]);
    assert_eq!((run.code, run.stderr.as_str()), (0, ""), "{run:?}");
    for (path, message) in [
        ("../usrapp/stubs/none", "there is no library `../usrapp/stubs/none`"),
        ("../../../none/none", "outside of the cell"),
    ] {
        folder.write("tests/stub.toml", &scenario(&format!("replace = {{ feeder = \"{path}\" }}"), 9));
        let run = folder.val3(&["test", "tests/stub.toml"]);
        assert!(run.code == 2 && run.stdout.contains(message), "{run:?}");
    }
    folder.write("tests/stub.toml", &scenario("replace = { feedr = \"../usrapp/stubs/feeder\" }", 9));
    let run = folder.val3(&["test", "tests/stub.toml"]);
    assert!(run.code == 2 && run.stdout.contains("feedr"), "{run:?}");
}

fn scenario(keys: &str, parts: u32) -> String {
    format!("application = \"../usrapp/main\"\n{keys}\n[expect]\ndata = {{ nParts = {parts} }}\n")
}
