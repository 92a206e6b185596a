//! `val3 test` only passes if something was proved.

use expect_test::expect;

use crate::support::Folder;
use crate::test_command::{cell, program, timeless};

#[test]
fn files_that_belong_to_no_test_are_failures() {
    let folder = cell(&[("testSum", "? \"sum\"")]);
    folder.write("usrapp/mainTest/testSumm.toml", "[expect]\nprint = [\"never\"]\n");
    folder.write("tests/lost.toml", "aplication = \"../usrapp/main\"\n[expect]\nprint = [\"never\"]\n");
    folder.write("tests/script.toml", "[[at]]\nt = 1\npower = true\n");
    folder.write("usrapp/mainTest/day.toml", "[[at]]\nt = 1\npower = true\n");
    folder.write("tests/other.toml", "[package]\nname = \"a\"\n");
    let run = folder.val3(&["test"]);
    assert_eq!(run.code, 2, "{run:?}");
    expect![[r#"
        usrapp/mainTest
          ok    testSum (0.004 s)
        tests
          FAIL  lost (0.000 s)
                the script `tests/lost.toml` cannot be used
                TOML parse error at line 1, column 1
                  |
                1 | aplication = "../usrapp/main"
                  | ^^^^^^^^^^
                unknown field `aplication`, expected one of `application`, `program`, `until`, `limit`, `skip`, `known_failure`, `arm`, `cell`, `start`, `power`, `monitor_speed`, `tags`, `replace`, `at`, `when`, `silent`, `expect`
                at lost (tests/lost.toml:1)
          FAIL  script (0.000 s)
                the scenario `tests/script.toml` cannot be executed: it names no application, and no test program has its name
                  help: write `application = "FOLDER"` before the first table, or name it as the test program that it belongs to, which would be `script.pgx`
                at script (tests/script.toml:1)
        usrapp/mainTest
          FAIL  testSumm (0.000 s)
                the scenario `usrapp/mainTest/testSumm.toml` cannot be executed: it names no application, and no test program has its name
                  help: write `application = "FOLDER"` before the first table, or name it as the test program that it belongs to, which would be `testSumm.pgx`
                at testSumm (usrapp/mainTest/testSumm.toml:1)
        failures:
          tests/lost.toml:1: tests:lost: the script `tests/lost.toml` cannot be used
          tests/script.toml:1: tests:script: the scenario `tests/script.toml` cannot be executed: it names no application, and no test program has its name
          usrapp/mainTest/testSumm.toml:1: usrapp/mainTest:testSumm: the scenario `usrapp/mainTest/testSumm.toml` cannot be executed: it names no application, and no test program has its name
        1 passed, 3 failed
    "#]].assert_eq(&run.stdout);
}

#[test]
fn tests_that_no_project_lists_are_named() {
    let folder = cell(&[("testSum", "? \"sum\"")]);
    folder.write("usrapp/mainTest/testNew.pgx", &program("testNew", "call assert:fail(\"found\")"));
    folder.write("usrapp/mainTest/helper.pgx", &program("helper", ""));
    folder.write("usrapp/main/testNew.pgx", &program("testNew", ""));
    let run = folder.val3(&["test"]);
    assert_eq!(run.code, 0, "{run:?}");
    expect![[r#"
        warning: `usrapp/mainTest/testNew.pgx` is not executed, because `mainTest.pjx` does not list it
    "#]]
    .assert_eq(&run.stderr);
}

#[test]
fn no_motion_is_recorded() {
    let folder = Folder::with("? \"on\"\n");
    folder.write("tests/day.toml", "application = \"../usrapp/main\"\n[expect]\ntrace = \"day.csv\"\n");
    let run = folder.val3(&["test", "tests", "--update"]);
    assert_eq!((run.code, folder.path().join("tests/day.csv").exists()), (1, false), "{run:?}");
    expect![[r#"
        not recorded, because the arm has not moved: tests/day.csv
    "#]]
    .assert_eq(&run.stderr);
}

#[test]
fn an_application_that_does_not_compile_stops_no_other() {
    let folder = cell(&[("testSum", "? \"sum\""), ("testOther", "")]);
    folder.write("tests/bad/bad.pjx", &folder.read("usrapp/main/main.pjx").replace("main.", "bad."));
    folder.write("tests/bad/bad.dtx", &folder.read("usrapp/main/main.dtx"));
    for name in ["start", "stop"] {
        folder.write(&format!("tests/bad/{name}.pgx"), &program(name, ""));
    }
    folder.write("tests/bad/start.pgx", &program("start", "x=<\nputln(y)"));
    folder.write("tests/good.toml", "application = \"../usrapp/main\"\n[expect]\nerrors = []\n");
    folder.write("tests/wrong.toml", "application = \"../usrapp/main\"\n[expect]\nio = { nothing = true }\n");
    let run = folder.val3(&["test", "--output", "junit=tests.xml"]);
    assert_eq!(run.code, 2, "{run:?}");
    expect![[r#"
        main
          ok    good (0.004 s)
          FAIL  wrong (0.000 s)
                the script `tests/wrong.toml` cannot be used
                  line 3: no input or output is called `nothing`
                at main:wrong (tests/wrong.toml:1)
                    1 │ application = "../usrapp/main"
        mainTest
          ok    testOther (0.004 s)
          ok    testSum (0.004 s)
        bad
          FAIL  (all tests) (0.000 s)
                the tests of `tests/bad/bad.pjx` cannot be executed: the compiler rejects the application
                  help: val3 check tests/bad
                at (all tests) (tests/bad/bad.pjx:1)
                a value is expected here, but `<` was found
                at V0010 (tests/bad/start.pgx:5)
                    5 │ x=<
                `y` is not declared: no local variable, parameter or data has this name
                at V0101 (tests/bad/start.pgx:6)
                    6 │ putln(y)
        failures:
          tests/wrong.toml:1: main:wrong: the script `tests/wrong.toml` cannot be used
          tests/bad/bad.pjx:1: bad:(all tests): the tests of `tests/bad/bad.pjx` cannot be executed: the compiler rejects the application (and 2 more)
        3 passed, 2 failed
    "#]]
    .assert_eq(&run.stdout);
    expect![[r#"
        <?xml version="1.0" encoding="UTF-8"?>
        <testsuites name="val3 test" tests="5" failures="2" time="…">
          <testsuite name="main" tests="2" failures="1" errors="0" skipped="0" time="…">
            <properties>
              <property name="controllerSeconds.good" value="0.004"/>
              <property name="controllerSeconds.wrong" value="0.000"/>
            </properties>
            <testcase name="good" classname="main" time="…">
            </testcase>
            <testcase name="wrong" classname="main" time="…">
              <failure message="the script `tests/wrong.toml` cannot be used">the script `tests/wrong.toml` cannot be used
          line 3: no input or output is called `nothing`
        at main:wrong (tests/wrong.toml:1)
            1 │ application = &quot;../usrapp/main&quot;</failure>
            </testcase>
          </testsuite>
          <testsuite name="mainTest" tests="2" failures="0" errors="0" skipped="0" time="…">
            <properties>
              <property name="controllerSeconds.testOther" value="0.004"/>
              <property name="controllerSeconds.testSum" value="0.004"/>
            </properties>
            <testcase name="testOther" classname="mainTest" time="…">
            </testcase>
            <testcase name="testSum" classname="mainTest" time="…">
              <system-out>| sum</system-out>
            </testcase>
          </testsuite>
          <testsuite name="bad" tests="1" failures="1" errors="0" skipped="0" time="…">
            <properties>
              <property name="controllerSeconds.(all tests)" value="0.000"/>
            </properties>
            <testcase name="(all tests)" classname="bad" time="…">
              <failure message="the tests of `tests/bad/bad.pjx` cannot be executed: the compiler rejects the application">the tests of `tests/bad/bad.pjx` cannot be executed: the compiler rejects the application
          help: val3 check tests/bad
        at (all tests) (tests/bad/bad.pjx:1)
        a value is expected here, but `&lt;` was found
        at V0010 (tests/bad/start.pgx:5)
            5 │ x=&lt;
        `y` is not declared: no local variable, parameter or data has this name
        at V0101 (tests/bad/start.pgx:6)
            6 │ putln(y)</failure>
            </testcase>
          </testsuite>
        </testsuites>
    "#]].assert_eq(&timeless(&folder.read("tests.xml")));
    let chosen = folder.val3(&["test", "--filter", "main:good"]);
    assert_eq!(chosen.stdout.lines().last(), Some("1 passed, 1 failed"), "{chosen:?}");
    let listed = folder.val3(&["test", "--list"]);
    assert_eq!(listed.code, 2, "{listed:?}");
    expect![[r#"
        main:good
        main:wrong
        mainTest:testOther
        mainTest:testSum
        error: the tests of `tests/bad/bad.pjx` cannot be executed: the compiler rejects the application
          help: val3 check tests/bad
    "#]]
    .assert_eq(&format!("{}{}", listed.stdout, listed.stderr));
}

#[test]
fn a_folder_above_the_cell_says_nothing_about_tests() {
    let cell = cell(&[("testSum", "? \"sum\"")]);
    cell.write("tests/job/app/app.pjx", &cell.read("usrapp/main/main.pjx").replace("main.", "app."));
    cell.write("tests/job/app/app.dtx", &cell.read("usrapp/main/main.dtx"));
    cell.write("tests/job/app/start.pgx", &program("start", "? \"on\""));
    cell.write("tests/job/app/stop.pgx", &program("stop", ""));
    cell.write("tests/job/app/testGrip.pgx", &program("testGrip", "wait(false)"));
    let manifest = cell.read("tests/job/app/app.pjx");
    let program = "    <Program file=\"testGrip.pgx\" />\n  </Programs>";
    cell.write("tests/job/app/app.pjx", &manifest.replace("  </Programs>", program));
    cell.write("tests/job/cycle/day.toml", "application = \"../app\"\n");
    cell.write("tests/job/checks/day.toml", "application = \"../app\"\n[expect]\nprint = [\"on\"]\n");
    let list = || cell.val3(&["test", "tests/job", "--list"]).stdout;
    // The cell is `tests/job`: as a repository, or without a repository as the folder above its applications.
    for mark in ["tests/job/.git/HEAD", "tests/job/val3.toml"] {
        cell.write(mark, "");
        assert_eq!(list(), "", "{mark}");
        std::fs::remove_file(cell.path().join(mark)).unwrap();
        let _ = std::fs::remove_dir(cell.path().join("tests/job/.git"));
    }
    // If the folder that contains `tests` is a repository, that folder is the cell.
    cell.write(".git/HEAD", "");
    assert_eq!(list(), "app:testGrip\napp:tests/job/checks/day\napp:tests/job/cycle/day\n");
    let covered = cell.val3(&["test", "tests/job", "--filter", "app:day", "--coverage"]);
    assert!(covered.code == 0 && !covered.stdout.contains("start"), "tests are not covered code: {covered:?}");
    std::fs::remove_dir_all(cell.path().join(".git")).unwrap();
    let covered = cell.val3(&["test", "tests/job/checks/day.toml", "--coverage"]);
    assert!(covered.code == 0 && covered.stdout.contains("start"), "{covered:?}");
}

#[test]
fn a_scenario_in_another_encoding_is_a_failure() {
    let folder = cell(&[("testSum", "? \"sum\"")]);
    let text: Vec<u8> = "application = \"../usrapp/main\"\n".encode_utf16().flat_map(u16::to_le_bytes).collect();
    folder.write("tests/day.toml", "");
    std::fs::write(folder.path().join("tests/day.toml"), [&[0xff, 0xfe], text.as_slice()].concat()).unwrap();
    let run = folder.val3(&["test"]);
    assert_eq!((run.code, run.stdout.contains("FAIL  day")), (2, true), "{run:?}");
}
