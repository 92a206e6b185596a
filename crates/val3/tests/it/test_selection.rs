//! `val3 test`: selection of tests by arguments, and unique test names.

use expect_test::expect;
use serde_json::Value;

use crate::support::{CommandOutput, Folder, copy_folder};
use crate::test_command::{cell, program, timeless};

/// Names of the tests that the arguments select.
#[track_caller]
fn listed(folder: &Folder, arguments: &[&str]) -> Vec<String> {
    let run = folder.val3(&[&["test", "--list"], arguments].concat());
    assert_eq!(run.code, 0, "{run:?}");
    run.stdout.lines().map(str::to_owned).collect()
}

#[test]
fn a_file_selects_its_test() {
    let folder = cell(&[("testA", "call helper()"), ("testB", "? 1"), ("helper", "? 2"), ("testC", "")]);
    let file = |name: &str| format!("usrapp/mainTest/{name}");
    assert_eq!(listed(&folder, &[&file("testA.pgx")]), ["mainTest:testA"]);
    assert_eq!(listed(&folder, &[&file("testA.pgx:5"), &file("testC.pgx")]), ["mainTest:testA", "mainTest:testC"]);
    assert_eq!(listed(&folder, &[&file("testA.pgx"), "usrapp"]).len(), 3);
    // A script belongs to the test next to it.
    folder.write(&file("testB.toml"), "[expect]\nprint = [\"1\"]\n");
    assert_eq!(listed(&folder, &[&file("testB.toml:2")]), ["mainTest:testB"]);
    let scenario = "application = \"../usrapp/main\"\nuntil = 1\n";
    folder.write("tests/one.toml", scenario);
    folder.write("tests/two.toml", scenario);
    assert_eq!(listed(&folder, &["tests/two.toml:1", &file("testB.pgx")]), ["main:two", "mainTest:testB"]);
    let run = folder.val3(&["test", &file("testA.pgx")]);
    assert_eq!((run.code, run.stdout.lines().last()), (0, Some("1 passed, 0 failed")), "{run:?}");
    let json: Value =
        serde_json::from_str(&folder.val3(&["test", "--list", "--format", "json", &file("testA.pgx")]).stdout).unwrap();
    assert_eq!(json["applications"][0]["tests"].as_array().unwrap().len(), 1, "{json}");
}

#[test]
fn a_file_that_is_no_test_is_an_error() {
    let folder = cell(&[("testA", "call helper()"), ("helper", "? 2")]);
    folder.write("usrapp/mainTest/testUnlisted.pgx", &program("testUnlisted", ""));
    for file in ["helper.pgx", "testUnlisted.pgx", "testA.pgx:x", "testNone.pgx"] {
        let run = folder.val3(&["test", &format!("usrapp/mainTest/{file}")]);
        assert_eq!((run.code, run.stdout.as_str()), (2, ""), "{run:?}");
        assert!(run.stderr.contains(file.split(':').next().unwrap()), "{run:?}");
    }
    // If an application does not compile, its tests fail even if an argument names only one file.
    folder.write("usrapp/mainTest/testA.pgx", &program("testA", "nUnknown=1"));
    let run = folder.val3(&["test", "usrapp/mainTest/testA.pgx"]);
    assert_eq!((run.code, run.stdout.contains("(all tests)")), (2, true), "{run:?}");
}

#[test]
fn several_filters_select_and_exclude() {
    let folder = cell(&[("testLeft", ""), ("testRight", ""), ("testUp", ""), ("testUpLeft", "")]);
    let names = |options: &[&str]| listed(&folder, &[&["usrapp"], options].concat());
    assert_eq!(names(&["--filter", "Right", "--filter", "Left"]).len(), 3);
    assert_eq!(names(&["--filter", "Left", "--filter-out", "Up"]), ["mainTest:testLeft"]);
    assert_eq!(names(&["--filter-out", "Left", "--filter-out", "Right"]), ["mainTest:testUp"]);
    let none = folder.val3(&["test", "usrapp", "--filter", "A", "--filter", "B", "--filter-out", "test"]);
    assert_eq!(none.code, 2, "{none:?}");
    assert!(none.stderr.contains("no test whose name contains `A` or `B` without `test`"), "{none:?}");
}

/// Two cells with applications of the same name.
fn twins() -> Folder {
    let folder = cell(&[("testA", ""), ("testB", "call assert:equalNum(1,2,0)")]);
    let copy = Folder::empty();
    for cell in ["left", "right"] {
        copy_folder(folder.path(), &copy.path().join(cell));
    }
    copy.write("right/usrapp/mainTest/testB.pgx", &program("testB", ""));
    copy
}

#[test]
fn applications_of_one_name_are_told_apart_by_their_paths() {
    let folder = twins();
    let run: CommandOutput = folder.val3(&["test", "."]);
    assert_eq!(run.code, 1, "{run:?}");
    expect![[r#"
        left/usrapp/mainTest
          ok    testA (0.004 s)
          FAIL  testB (0.004 s)
                1 instead of 2 (1 away, tolerance 0)
                at mainTest:testB (left/usrapp/mainTest/testB.pgx:5)
                    5 │ call assert:equalNum(1,2,0)
        right/usrapp/mainTest
          ok    testA (0.004 s)
          ok    testB (0.004 s)
        failures:
          left/usrapp/mainTest/testB.pgx:5: left/usrapp/mainTest:testB: 1 instead of 2 (1 away, tolerance 0)
        3 passed, 1 failed
    "#]]
    .assert_eq(&run.stdout);
    let junit = folder.val3(&["test", ".", "--format", "junit", "--filter", "testA"]).stdout;
    expect![[r#"
        <?xml version="1.0" encoding="UTF-8"?>
        <testsuites name="val3 test" tests="2" failures="0" time="…">
          <testsuite name="left/usrapp/mainTest" tests="1" failures="0" errors="0" skipped="0" time="…">
            <properties>
              <property name="controllerSeconds.testA" value="0.004"/>
            </properties>
            <testcase name="testA" classname="left/usrapp/mainTest" time="…">
            </testcase>
          </testsuite>
          <testsuite name="right/usrapp/mainTest" tests="1" failures="0" errors="0" skipped="0" time="…">
            <properties>
              <property name="controllerSeconds.testA" value="0.004"/>
            </properties>
            <testcase name="testA" classname="right/usrapp/mainTest" time="…">
            </testcase>
          </testsuite>
        </testsuites>
    "#]]
    .assert_eq(&timeless(&junit));
    let names = ["left/usrapp/mainTest:testA", "right/usrapp/mainTest:testB"];
    assert_eq!(listed(&folder, &[".", "--exact", names[0], "--exact", names[1]]), names);
    assert_eq!(listed(&folder, &[".", "--exact", "mainTest:testA"]).len(), 2);
    let json: Value = serde_json::from_str(&folder.val3(&["test", ".", "--format", "json"]).stdout).unwrap();
    let ids: Vec<&str> = json["tests"].as_array().unwrap().iter().filter_map(|test| test["id"].as_str()).collect();
    assert_eq!((ids.len(), ids[3]), (4, names[1]));
    // Without the second cell, the name is unique.
    assert_eq!(listed(&folder, &["left", "--filter", "testA"]), ["mainTest:testA"]);
}

#[test]
fn scenarios_of_one_name_are_told_apart_by_their_paths() {
    let folder = cell(&[]);
    let scenario = "application = \"../../usrapp/main\"\nuntil = 1\n";
    folder.write("tests/fast/start.toml", scenario);
    folder.write("tests/slow/start.toml", scenario);
    assert_eq!(listed(&folder, &["tests"]), ["main:tests/fast/start", "main:tests/slow/start"]);
    assert_eq!(listed(&folder, &["tests", "--exact", "main:tests/slow/start"]), ["main:tests/slow/start"]);
}
