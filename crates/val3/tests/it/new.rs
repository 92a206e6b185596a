//! `val3 new`: writes an application that passes its check, its run and its test.

use expect_test::expect;
use serde_json::Value;
use val3_kinematics::Arm;

use crate::support::{CommandOutput, Folder};

fn passed(folder: &Folder, args: &[&str]) -> CommandOutput {
    let run = folder.val3(args);
    assert_eq!(run.code, 0, "{args:?}: {run:?}");
    run
}

/// Checks, runs and tests the application `app` of the cell `app`.
fn assert_complete(folder: &Folder) {
    let check = passed(folder, &["check", "--motion", "app"]);
    assert!(check.stdout.is_empty(), "{check:?}");
    passed(folder, &["fmt", "--check", "app"]);
    let run = passed(folder, &["run", "app", "--screen"]);
    assert_eq!(run.stderr, "", "{run:?}");
    assert!(run.stdout.contains("log: USR app is done") && run.stdout.contains("|at the part "), "{run:?}");
    let test = passed(folder, &["test", "app"]);
    assert!(test.stdout.contains("ok    testAbove") && test.stdout.contains("1 passed, 0 failed"), "{test:?}");
}

/// Writes an application for each arm, and checks, runs and tests it.
fn assert_complete_for_all_arms(version: &str) {
    for arm in Arm::names() {
        let folder = Folder::empty();
        passed(&folder, &["new", "app", "--arm", arm, "--version", version]);
        assert_complete(&folder);
    }
}

#[test]
fn an_application_for_s7_checks_runs_and_passes_its_test_with_each_arm() {
    assert_complete_for_all_arms("s7.11.3");
}

#[test]
fn an_application_for_s8_checks_runs_and_passes_its_test_with_each_arm() {
    assert_complete_for_all_arms("s8.13");
}

#[test]
fn a_new_cell_has_the_default_arm_and_the_next_commands() {
    let folder = Folder::empty();
    let run = passed(&folder, &["new", "app"]);
    assert_eq!(run.stdout, "");
    expect![[r#"
        wrote app/val3.toml
        wrote app/cell.toml
        wrote app/usr/usrapp/app
        wrote app/usr/usrapp/appTest
        wrote app/usr/usrapp/val3assert
        the application is for a TX2-90 and VAL 3 s8.20
          run it:   val3 run app --screen
          test it:  val3 test app/usr/usrapp/appTest
          check it: val3 check --motion app/usr/usrapp/app
    "#]]
    .assert_eq(&run.stderr);
    expect![[r##"
        # Settings of this cell

        # The arm of `val3 check --motion`, `val3 run` and `val3 test`
        arm = "tx2-90"

        [run]
        # The arm has power when a run starts, as if an operator had switched it on
        power = true
    "##]]
    .assert_eq(&folder.read("app/val3.toml"));
    assert_complete(&folder);
    expect![[r#"
        log: USR app is done
        +app-------------------------------------+
        |to the part                             |
        |at the part                             |
        |done                                    |
        |                                        |
        |                                        |
        |                                        |
        |                                        |
        |                                        |
        |                                        |
        |                                        |
        |                                        |
        |                                        |
        |                                        |
        |                                        |
        +----------------------------------------+
    "#]]
    .assert_eq(&passed(&folder, &["run", "app", "--screen"]).stdout);
}

#[test]
fn the_default_version_is_that_of_the_controller_of_the_arm() {
    for (arm, version) in [("tx2-60l", "s8.20"), ("ts2-60", "s8.20"), ("tx60", "s7.11.3"), ("ts60", "s7.11.3")] {
        let folder = Folder::empty();
        let run = passed(&folder, &["new", "app", "--arm", arm, "--format", "json"]);
        let written: Value = serde_json::from_str(&run.stdout).unwrap();
        assert_eq!(written["val3"], version, "{arm}");
        assert!(written["application"].as_str().unwrap().ends_with("app"), "{written}");
    }
}

#[test]
fn a_cell_decides_on_place_arm_and_version() {
    let folder = Folder::empty();
    folder.write("cell/usr/configs/arm.cfx", "<arm><String name=\"arm\" value=\"ts60-S1\"/></arm>");
    folder.write("cell/usr/configs/val3version.xml", "<Versions><Version name=\"val3\">s7.8.3</Version></Versions>");
    folder.write("cell/usr/usrapp/readme.txt", "");
    for place in ["cell", "cell/usr", "cell/usr/usrapp", "cell/usr/configs"] {
        let name = format!("app{}", place.len());
        let run = passed(&folder, &["new", &name, "--folder", place]);
        assert!(run.stderr.contains("a TS60 and VAL 3 s7.8.3") && run.stderr.contains("--power"), "{run:?}");
        let app = format!("cell/usr/usrapp/{name}");
        passed(&folder, &["run", &app, "--power"]);
        passed(&folder, &["test", &format!("{app}Test")]);
        assert_eq!(passed(&folder, &["check", "--motion", &app]).stdout, "");
    }
    assert!(!folder.path().join("cell/val3.toml").exists());
    let run = folder.val3(&["new", "other", "--folder", "cell", "--arm", "tx2-60l"]);
    assert_eq!(run.code, 2);
    expect![[r#"
        error: the arm of this cell is a TS60 (cell/usr/configs/arm.cfx)
          help: omit --arm, or name a folder outside of the cell: --folder DIR
    "#]]
    .assert_eq(&run.stderr);
}

#[test]
fn settings_without_an_arm_are_not_changed() {
    let folder = Folder::empty();
    folder.write("cell/val3.toml", "[run]\npower = true\n");
    folder.write("cell/usr/usrapp/readme.txt", "");
    let run = folder.val3(&["new", "app", "--folder", "cell", "--arm", "tx2-60l"]);
    assert_eq!(run.code, 2);
    expect![[r#"
        error: the arm is not that of this cell: `cell/val3.toml` does not name it
          help: add `arm = "tx2-60l"` to the beginning of that file
    "#]]
    .assert_eq(&run.stderr);
    passed(&folder, &["new", "app", "--folder", "cell"]);
    passed(&folder, &["run", "cell/usr/usrapp/app"]);
    assert_eq!(folder.read("cell/val3.toml"), "[run]\npower = true\n");
}

#[test]
fn nothing_is_replaced() {
    let folder = Folder::empty();
    passed(&folder, &["new", "app"]);
    for (args, path) in [
        (&["new", "app"][..], "app"),
        (&["new", "APP"], "app"),
        (&["new", "App", "--folder", "app"], "app/usr/usrapp/app"),
    ] {
        let run = folder.val3(args);
        assert_eq!(run.code, 2);
        assert_eq!(run.stderr, format!("error: `{path}` exists\n  help: write another name\n"), "{args:?}");
    }
    let second = passed(&folder, &["new", "second", "--folder", "app"]);
    assert!(!second.stderr.contains("val3assert"), "{second:?}");
    passed(&folder, &["test", "app"]);
}

#[test]
fn unusable_names_arms_and_versions_are_refused() {
    for (args, message) in [
        (&["new", "movej"][..], "error: an application cannot have the name `movej`: it is a word of VAL 3"),
        (&["new", "a", "--arm", "rx13b"], "error: the arm `rx13b` is not known; did you mean `RX130B`?"),
        (&["new", "a", "--version", "s6.8"], "s6.8 is not supported here: name a version of s7 (CS8) or s8 (CS9)"),
        (&["new", "a", "--version", "9"], "write a version such as s7.11 or s8.13"),
        (&["new", "a", "--folder", "none"], "none"),
    ] {
        let folder = Folder::empty();
        let run = folder.val3(args);
        assert_eq!((run.code, run.stdout.as_str()), (2, ""), "{run:?}");
        assert!(run.stderr.contains(message), "{run:?}");
        assert_eq!(folder.path().read_dir().unwrap().count(), 0, "{args:?}");
    }
}

#[test]
fn an_application_for_a_scara_arm_has_data_of_its_kind_and_gets_further_tests() {
    let folder = Folder::empty();
    passed(&folder, &["new", "app", "--arm", "ts2-60"]);
    let data = folder.read("app/usr/usrapp/app/app.dtx");
    assert!(data.contains("\"pointRs\"") && !data.contains("\"pointRx\""), "{data}");
    assert_complete(&folder);
    std::fs::remove_dir_all(folder.path().join("app/usr/usrapp/appTest")).unwrap();
    passed(&folder, &["test", "--init", "app/usr/usrapp/app"]);
    let check = passed(&folder, &["check", "--motion", "app"]);
    assert!(check.stdout.is_empty(), "{check:?}");
    let test = folder.val3(&["test", "app"]);
    assert!(test.stdout.contains(" passed") || test.stderr.contains(" passed"), "{test:?}");
}
