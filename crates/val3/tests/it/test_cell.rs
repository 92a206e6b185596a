//! `val3 test` with a simulated cell: script reactions, and `[test]` of `val3.toml`.

use std::fs::{self, File};

use expect_test::{Expect, expect};
use serde_json::Value;

use crate::support::{CommandOutput, Folder};
use crate::watch::Watching;

/// An application `pal` that uses a feeder, its tests, and a stand-in that delivers 9 parts instead of 1.
const FEEDER: &str = r#"
num nUnused
--- palTest
library pal "Disk://pal/pal.pjx"
program testWork()
begin
  call pal:work()
  ? pal:nParts
end
program testAgain()
begin
  call pal:work()
  call pal:work()
  ? pal:nParts
end
--- pal
library feeder "Disk://feeder/feeder.pjx"
public num nParts
public program work()
begin
  call feeder:next(nParts)
end
--- feeder
num nDelivered
public program next(num& x_nParts)
begin
  nDelivered=nDelivered+1
  x_nParts=nDelivered
end
--- stubs/feeder
num nDelivered
public program next(num& x_nParts)
begin
  nDelivered=nDelivered+9
  x_nParts=nDelivered
end
"#;

const REPLACED: &str = "[test]\nreplace = { feeder = \"usrapp/stubs/feeder\" }\n";

/// Files of a listing with a `val3.toml`.
fn cell(listing: &str, settings: &str) -> Folder {
    let folder = Folder::with(listing);
    folder.write("val3.toml", settings);
    folder
}

/// All tests' outputs, each after the test name.
fn prints(run: &CommandOutput) -> String {
    let report: Value = serde_json::from_str(&run.stdout).unwrap_or_else(|_| panic!("{run:?}"));
    report["tests"].as_array().unwrap().iter().map(prints_of_test).collect()
}

fn prints_of_test(test: &Value) -> String {
    let prints: Vec<&str> = test["prints"].as_array().unwrap().iter().map(|text| text.as_str().unwrap()).collect();
    let failure = test["failure"]["message"].as_str().map(|text| format!(" FAILED {text}")).unwrap_or_default();
    format!("{}: {}{failure}\n", test["program"].as_str().unwrap(), prints.join(" "))
}

#[track_caller]
fn check(folder: &Folder, expected: Expect) {
    let run = folder.val3(&["test", "usrapp", "--format", "json"]);
    expected.assert_eq(&prints(&run));
}

#[track_caller]
fn refused(listing: &str, settings: &str, expected: Expect) {
    let folder = cell(listing, settings);
    let run = folder.val3(&["test", "usrapp/palTest"]);
    assert_eq!(run.code, 2, "{run:?}");
    let path = fs::canonicalize(folder.path()).unwrap();
    expected.assert_eq(&format!("{}{}", run.stdout, run.stderr).replace(path.to_str().unwrap(), "CELL"));
}

#[test]
fn reactions_of_the_cell_lead_a_test_to_its_end() {
    let folder = cell(
        r#"
        num nUnused
        --- gripTest
        num nState
        bool bHeld
        program testGrip()
        begin
          nState=1
          wait(bHeld)
          ? clock()
          nState=2
          wait(!bHeld)
          ? clock()
        end
        "#,
        "",
    );
    let script = "[[when]]\ndata = { nState = 1 }\nthen = [{ after = 0.2, set = { bHeld = true } }]\n\
                  [[when]]\ndata = { nState = { above = 1.5 } }\nthen = [{ after = 1, set = { bHeld = false } }]\n";
    folder.write("usrapp/gripTest/testGrip.toml", script);
    check(
        &folder,
        expect![[r#"
        testGrip: 0.204 1.208
    "#]],
    );
    folder.write("usrapp/gripTest/testGrip.toml", &script.replace("nState = 1", "nStat = 1"));
    let run = folder.val3(&["test", "usrapp"]);
    let message = "  [[when]] in line 1: there is no variable `nStat`; did you mean `nState`?";
    assert_eq!((run.code, run.stdout.contains(message)), (2, true), "{run:?}");
    // Without the second reaction, the test cannot continue.
    folder.write("usrapp/gripTest/testGrip.toml", script.split("[[when]]\ndata = { nState = {").next().unwrap());
    let run = folder.val3(&["test", "usrapp"]);
    assert!(run.stdout.contains("it waits for a condition"), "{run:?}");
}

#[test]
fn a_library_of_the_application_is_replaced_in_tests_alone() {
    let folder = cell(FEEDER, REPLACED);
    check(
        &folder,
        expect![[r#"
        testAgain: 18
        testWork: 9
    "#]],
    );
    let run = folder.val3(&["run", "usrapp/palTest", "--program", "testWork"]);
    assert_eq!((run.code, run.stdout.as_str()), (0, "1\n"), "{run:?}");
    folder.write("val3.toml", "");
    check(
        &folder,
        expect![[r#"
        testAgain: 2
        testWork: 1
    "#]],
    );
}

#[test]
fn a_library_that_a_program_loads_is_replaced_whatever_its_path_is() {
    let listing = r#"
        num nUnused
        --- partTest
        library part "Disk://part/part.pjx" autoload=false
        program testLoad()
        begin
          ? part:libLoad("Disk://part")
          ? part:sName
          ? part:libLoad("Disk://"+"other")
          ? part:sName
          ? part:libPath()
        end
        --- part
        public string sName = "part"
        --- other
        public string sName = "other"
        --- stub
        public string sName = "stub"
    "#;
    check(
        &cell(listing, "[test.replace]\npart = \"usrapp/stub/stub.pjx\"\n"),
        expect![[r#"
        testLoad: 0 stub 0 stub Disk://stub
    "#]],
    );
    check(
        &cell(listing, ""),
        expect![[r#"
        testLoad: 0 part 0 other Disk://other
    "#]],
    );
}

/// Moves a folder out of `Disk`.
fn move_out(folder: &Folder, from: &str, to: &str) {
    let target = folder.path().join(to);
    fs::create_dir_all(target.parent().unwrap()).unwrap();
    fs::rename(folder.path().join(from), target).unwrap();
}

#[test]
fn stand_ins_can_lie_outside_of_the_disk() {
    let settings = "disk = \"usrapp\"\n[test.replace]\nfeeder = \"stubs/feeder\"\n";
    let listing = FEEDER.replace(
        "--- stubs/feeder\n",
        "--- types/Part\npublic num nSize\n--- log\npublic num nCalls = 100\n--- stubs/feeder\n\
         library beside \"../log\"\ntype Part \"Disk://types/Part\"\nPart part\n",
    );
    let folder = cell(&listing.replace("nDelivered+9", "nDelivered+9+beside:nCalls"), settings);
    move_out(&folder, "usrapp/stubs/feeder", "stubs/feeder");
    move_out(&folder, "usrapp/log", "stubs/log");
    check(
        &folder,
        expect![[r#"
        testAgain: 218
        testWork: 109
    "#]],
    );
}

#[test]
fn a_stand_in_can_use_the_library_that_it_replaces() {
    let listing = FEEDER
        .replace("--- stubs/feeder\n", "--- stubs/feeder\nlibrary feeder \"Disk://feeder/feeder.pjx\"\n")
        .replace("nDelivered=nDelivered+9\n  x_nParts=nDelivered", "call feeder:next(x_nParts)\n  x_nParts=-x_nParts");
    check(
        &cell(&listing, REPLACED),
        expect![[r#"
        testAgain: -2
        testWork: -1
    "#]],
    );
}

#[test]
fn a_stand_in_is_held_against_the_interface() {
    refused(
        &stub("public program following(num& x_nParts)"),
        REPLACED,
        expect![[r#"
            palTest
              FAIL  (all tests) (0.000 s)
                    the tests of `usrapp/palTest/palTest.pjx` cannot be executed: the stand-in `usrapp/stubs/feeder` cannot be used: the library `feeder` does not contain the program `next` of the interface of `feeder`
                      help: add it as public to `feeder`, or test `feeder:libExist("next()")` before each use
                    at (all tests) (usrapp/palTest/palTest.pjx:1)
            0 passed, 1 failed
        "#]],
    );
    refused(
        &stub("public program next(num x_nParts)"),
        REPLACED,
        expect![[r#"
            palTest
              FAIL  (all tests) (0.000 s)
                    the tests of `usrapp/palTest/palTest.pjx` cannot be executed: the stand-in `usrapp/stubs/feeder` cannot be used: the program `next` of `feeder` is `next(num x_nParts)`, but the interface of `feeder` declares `next(num& x_nParts)`
                      help: declare it as `next(num& x_nParts)` in `feeder`, or change all libraries of this interface alike
                    at (all tests) (usrapp/palTest/palTest.pjx:1)
            0 passed, 1 failed
        "#]],
    );
    refused(
        &stub("program next(num& x_nParts)"),
        REPLACED,
        expect![[r#"
            palTest
              FAIL  (all tests) (0.000 s)
                    the tests of `usrapp/palTest/palTest.pjx` cannot be executed: the stand-in `usrapp/stubs/feeder` cannot be used: the program `next` is private in the library `feeder`, but belongs to the interface of `feeder`
                      help: make `next` public in `feeder`
                    at (all tests) (usrapp/palTest/palTest.pjx:1)
            0 passed, 1 failed
        "#]],
    );
    refused(
        &stub("public program next(num& x_nParts)\n  num l_n").replace("num l_n\nbegin", "num l_n\nbegin\n  l_m=1"),
        REPLACED,
        expect![[r#"
            palTest
              FAIL  (all tests) (0.000 s)
                    the tests of `usrapp/palTest/palTest.pjx` cannot be executed: the stand-in `usrapp/stubs/feeder` cannot be used: `l_m` is not declared: no local variable, parameter or data has this name
                      help: did you mean `l_n`?
                    at (all tests) (usrapp/palTest/palTest.pjx:1)
            0 passed, 1 failed
        "#]],
    );
    let missing = FEEDER.replace("Disk://feeder/feeder.pjx", "Disk://feedr/feedr.pjx");
    refused(
        &missing,
        REPLACED,
        expect![[r#"
            palTest
              FAIL  (all tests) (0.000 s)
                    the tests of `usrapp/palTest/palTest.pjx` cannot be executed: the stand-in `usrapp/stubs/feeder` cannot be used: the library that `pal` declares as `feeder` is missing, and it gives the interface
                      help: correct its path in <Libraries>, or add the library
                    at (all tests) (usrapp/palTest/palTest.pjx:1)
            0 passed, 1 failed
        "#]],
    );
}

/// The cell with a stand-in that contains this program.
fn stub(program: &str) -> String {
    let (rest, _) = FEEDER.split_once("--- stubs/feeder").unwrap();
    format!("{rest}--- stubs/feeder\nnum nDelivered\n{program}\nbegin\nend\n")
}

#[test]
fn wrong_settings_are_explained() {
    refused(
        FEEDER,
        "[test]\nreplace = { feedr = \"usrapp/stubs/feeder\" }\n",
        expect![[r#"
        error: no application declares the library identifier `feedr`
         --> val3.toml:2
          |
        2 | replace = { feedr = "usrapp/stubs/feeder" }
          |             ^^^^^
          help: did you mean `feeder`?
    "#]],
    );
    refused(
        FEEDER,
        "[test]\nreplace = { conveyor = \"usrapp/stubs/feeder\" }\n",
        expect![[r#"
        error: no application declares the library identifier `conveyor`
         --> val3.toml:2
          |
        2 | replace = { conveyor = "usrapp/stubs/feeder" }
          |             ^^^^^^^^
          help: write an identifier of <Libraries> as programs use it
    "#]],
    );
    refused(
        FEEDER,
        "[test]\nreplace = { feeder = \"usrapp/stubs/feedr\" }\n",
        expect![[r#"
            palTest
              FAIL  (all tests) (0.000 s)
                    there is no library `usrapp/stubs/feedr`
                     --> val3.toml:2
                      |
                    2 | replace = { feeder = "usrapp/stubs/feedr" }
                      |             ^^^^^^
                      help: did you mean `feeder`?
                    at (all tests) (usrapp/palTest/palTest.pjx:1)
            0 passed, 1 failed
        "#]],
    );
    refused(
        FEEDER,
        "[test]\nreplace = { feeder = \"stubs/tray\" }\n",
        expect![[r#"
            palTest
              FAIL  (all tests) (0.000 s)
                    there is no library `stubs/tray`
                     --> val3.toml:2
                      |
                    2 | replace = { feeder = "stubs/tray" }
                      |             ^^^^^^
                      help: name the folder of a library or its `.pjx`, relative to `CELL`
                    at (all tests) (usrapp/palTest/palTest.pjx:1)
            0 passed, 1 failed
        "#]],
    );
    refused(
        FEEDER,
        "[test]\nlimit = 0\n",
        expect![[r#"
            palTest
              FAIL  (all tests) (0.000 s)
                    0 is not a limit of tests: write seconds from 0.004 to 1e6
                     --> val3.toml:2
                      |
                    2 | limit = 0
                      | ^^^^^
                    at (all tests) (usrapp/palTest/palTest.pjx:1)
            0 passed, 1 failed
        "#]],
    );
    refused(
        FEEDER,
        "[test]\nreplaces = { feeder = \"usrapp/stubs/feeder\" }\n",
        expect![[r#"
        error: there is no setting `test.replaces`
         --> val3.toml:2
          |
        2 | replaces = { feeder = "usrapp/stubs/feeder" }
          | ^^^^^^^^
          help: did you mean `replace`?
    "#]],
    );
}

#[test]
fn an_identifier_of_another_application_is_known() {
    let listing = format!("{FEEDER}--- oven\nlibrary heater \"Disk://feeder/feeder.pjx\"\nnum nOven\n");
    let settings = REPLACED.replace("{ ", "{ heater = \"usrapp/stubs/feeder\", ");
    let run = cell(&listing, &settings).val3(&["test", "usrapp/palTest"]);
    assert_eq!((run.code, run.stdout.lines().last()), (0, Some("2 passed, 0 failed")), "{run:?}");
}

#[test]
fn listed_applications_have_tests() {
    let listing = "program testNone()\nbegin\nend\n--- checks/pal\nprogram testA()\nbegin\nend\n--- checks/deep/oven\n\
                   program testB()\nbegin\nend\n--- palTest\nprogram testC()\nbegin\nend\n";
    let listed = |settings: &str| cell(listing, settings).val3(&["test", "usrapp", "--list"]).stdout;
    assert_eq!(listed(""), "palTest:testC\n");
    assert_eq!(listed("[test]\napplications = [\"**/checks/*\"]\n"), "oven:testB\npal:testA\npalTest:testC\n");
    assert_eq!(listed("[test]\napplications = [\"usrapp/checks/pal\"]\n"), "pal:testA\npalTest:testC\n");
}

#[test]
fn the_limit_of_tests_can_be_configured() {
    let folder = cell("num n\n--- palTest\nprogram testWait()\nbegin\n  wait(false)\nend\n", "[test]\nlimit = 7\n");
    let failure = |options: &[&str]| folder.val3(&[&["test", "usrapp"], options].concat()).stdout;
    assert!(failure(&[]).contains("not ended after 7 s"), "{}", failure(&[]));
    assert!(failure(&["--limit", "3"]).contains("not ended after 3 s"));
    folder.write("val3.toml", "");
    assert!(failure(&[]).contains("not ended after 60 s"));
}

#[test]
fn a_changed_stand_in_repeats_the_tests() {
    let folder = cell(FEEDER, "[test.replace]\nfeeder = \"stubs/feeder\"\n");
    move_out(&folder, "usrapp/stubs/feeder", "stubs/feeder");
    let mut command = folder.command(&["test", "usrapp/palTest", "--watch"]);
    command.stdout(File::create(folder.path().join("results.txt")).unwrap());
    let watching = Watching::of(command);
    watching.wait_for("Waiting for changes");
    assert!(folder.read("results.txt").ends_with("2 passed, 0 failed\n"), "{}", folder.read("results.txt"));
    let program = folder.read("stubs/feeder/next.pgx");
    folder.write("stubs/feeder/next.pgx", &program.replace("nDelivered=nDelivered+9", "nDelivered=sqrt(-1)"));
    watching.wait_for("Waiting for changes");
    assert!(folder.read("results.txt").ends_with("0 passed, 2 failed\n"), "{}", folder.read("results.txt"));
    folder.write("val3.toml", "[test.replace]\nfeeder = \"stubs/feedr\"\n");
    watching.wait_for("Waiting for changes");
    assert!(folder.read("results.txt").contains("there is no library `stubs/feedr`"));
}
