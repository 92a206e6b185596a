//! Stand-in programs for instructions of add-ons (`run.add-ons`), called by `run`, `test`, `eval` and `dap`.

use std::fs;

use expect_test::{Expect, expect};
use serde_json::json;

use crate::dap_client::Session;
use crate::support::Folder;

/// An application and its library, which both use an add-on. The stand-in programs of the add-on share a variable for
/// the speed.
const CELL: &str = r#"
library lib "Disk://lib/lib.pjx"
num nSpeed[2]
num nNow
bool bMoving
program start()
begin
  $velJoint(flange,2)
  nSpeed[0]=5
  nSpeed[1]=7
  $setVelCmd(nSpeed)
  nNow=$getVel(1)+$getVel(0)*10
  ? nNow
  nNow=$getVel(nNow-113)
  ? nNow
  call lib:show()
  bMoving=$isMoving() and $isMoving()
  ? bMoving
  ? $nameOf(3)
end
--- lib
public program show()
begin
  ? $getVel(0)
end
--- standIns
num nVel[2]
num nFactor
public program velJoint(tool x_tTool, num x_nFactor)
begin
  nFactor=x_nFactor
end
public program setVelCmd(num& x_nSpeed[])
begin
  nVel[0]=x_nSpeed[0]*nFactor
  nVel[1]=x_nSpeed[1]*nFactor
end
public program getVel(num x_nAxis, num& x_nResult)
begin
  x_nResult=x_nResult+nVel[x_nAxis]
end
public program isMoving(bool& x_bResult)
begin
  x_bResult=(nVel[0]!=0)
end
public program nameOf(num x_nAxis, string& x_sResult)
begin
  x_sResult=x_sResult+"J"+toString("",x_nAxis)
end
"#;

const SETTINGS: &str = r#"
disk = "usrapp"
[run.add-ons]
'$velJoint' = { program = "usrapp/standIns/velJoint.pgx" }
'$setVelCmd' = { program = "usrapp/standIns/setVelCmd.pgx" }
'$getVel' = { program = "usrapp/standIns/getVel" }
'$isMoving' = { program = "usrapp/standIns/isMoving.pgx" }
'$nameOf' = { program = "usrapp/standIns/nameOf.pgx" }
"#;

fn cell(listing: &str, settings: &str) -> Folder {
    let folder = Folder::with(listing);
    folder.write("val3.toml", settings);
    folder
}

#[track_caller]
fn prints(folder: &Folder, expected: Expect) {
    let run = folder.val3(&["run", "usrapp/main"]);
    let folder = folder.path().to_str().unwrap();
    expected.assert_eq(&format!("{}{}{}\n", run.stdout, run.stderr.replace(folder, "CELL"), run.code));
}

#[test]
fn a_run_calls_programs_with_arguments_and_results() {
    let expected = expect![[r#"
        114
        14
        10
        true
        J3
        0
    "#]];
    prints(&cell(CELL, SETTINGS), expected);
}

#[test]
fn their_library_can_lie_outside_of_the_disk() {
    let folder = cell(CELL, &SETTINGS.replace("usrapp/standIns", "sim/standIns"));
    fs::create_dir(folder.path().join("sim")).unwrap();
    fs::rename(folder.path().join("usrapp/standIns"), folder.path().join("sim/standIns")).unwrap();
    let run = folder.val3(&["run", "usrapp/main"]);
    assert_eq!((run.code, run.stdout.as_str()), (0, "114\n14\n10\ntrue\nJ3\n"), "{run:?}");
}

#[test]
fn a_program_of_the_application_can_be_called() {
    let listing = "program start()\nnum l_n\nbegin\n  l_n=$twice(4)\n  ? l_n\n  call lib:show()\nend\n\
                   library lib \"Disk://lib/lib.pjx\"\n\
                   public program double(num x_n, num& x_nResult)\nbegin\n  x_nResult=2*x_n\nend\n\
                   --- lib\npublic program show()\nbegin\n  ? $twice(5)\nend\n";
    let settings = "disk = \"usrapp\"\n[run.add-ons]\n'$twice' = { program = \"usrapp/main/double.pgx\" }\n";
    prints(
        &cell(listing, settings),
        expect![[r#"
        8
        10
        0
    "#]],
    );
}

#[test]
fn a_condition_calls_the_program_in_each_turn() {
    let listing = "program start()\nbegin\n  wait($isDone())\n  ? \"done\"\nend\n\
                   --- standIns\nnum nCalls\npublic program isDone(bool& x_bResult)\nbegin\n  nCalls=nCalls+1\n  \
                   x_bResult=nCalls>=3\nend\n";
    let settings = "disk = \"usrapp\"\n[run.add-ons]\n'$isDone' = { program = \"usrapp/standIns/isDone.pgx\" }\n";
    prints(
        &cell(listing, settings),
        expect![[r#"
        done
        0
    "#]],
    );
}

#[test]
fn tests_and_their_coverage_treat_them_as_programs() {
    let listing = CELL.replacen("program start()", "program testMoves()", 1).replacen(
        "library lib",
        "--- palTest\nlibrary lib",
        1,
    );
    let folder = cell(&listing, SETTINGS);
    let run = folder.val3(&["test", "usrapp", "--coverage-output", "lcov=lcov.info"]);
    assert_eq!(run.code, 0, "{run:?}");
    let report = folder.read("lcov.info");
    assert!(report.contains("standIns/getVel.pgx") && report.contains("standIns/velJoint.pgx"), "{report}");
}

#[test]
fn an_evaluation_calls_them() {
    let folder = cell(CELL, SETTINGS);
    let run = folder.val3(&["eval", "--app", "usrapp/main", "$velJoint(flange,2)", "$nameOf(4)", "$isMoving()"]);
    assert_eq!((run.code, run.stdout.as_str()), (0, "\"J4\"\nfalse\n"), "{run:?}");
}

#[test]
fn a_debugger_steps_into_them() {
    let folder = cell(CELL, SETTINGS);
    let application = fs::canonicalize(folder.path().join("usrapp/main")).unwrap();
    let (mut session, task) = Session::launched(json!({ "program": application, "script": null }));
    assert_eq!(session.frame(task).0, "main:start()");
    session.ask("stepIn", json!({ "threadId": task }));
    session.stopped("step");
    assert_eq!(session.frame(task).0, "standIns:velJoint()");
    let trace = session.ask("stackTrace", json!({ "threadId": task }));
    assert_eq!(trace["stackFrames"][1]["name"], "main:start()");
    session.ask("stepOut", json!({ "threadId": task }));
    session.stopped("step");
    for _ in 0..4 {
        session.ask("next", json!({ "threadId": task }));
        session.stopped("step");
    }
    let (name, _, frame) = session.frame(task);
    assert_eq!((name.as_str(), session.evaluate(frame, "nNow").as_str()), ("main:start()", "114"));
    let executed = json!({ "expression": "$getVel(1)", "frameId": frame, "context": "repl" });
    assert_eq!(session.ask("evaluate", executed)["result"], "14");
    session.end();
}

#[track_caller]
fn refused(listing: &str, settings: &str, expected: Expect) {
    let folder = cell(listing, settings);
    let run = folder.val3(&["run", "usrapp/main"]);
    assert!(run.code != 0 && run.stdout.is_empty(), "{run:?}");
    let path = folder.path().to_str().unwrap();
    expected.assert_eq(&run.stderr.replace(path, "CELL"));
}

#[test]
fn wrong_settings_are_explained_at_their_place() {
    let with = |from: &str, to: &str| SETTINGS.replace(from, to);
    refused(
        CELL,
        &with("standIns/velJoint", "standIn/velJoint"),
        expect![[r#"
        error: there is no library `usrapp/standIn/standIn.pjx` in `CELL`
         --> val3.toml:4
          |
        4 | '$velJoint' = { program = "usrapp/standIn/velJoint.pgx" }
          | ^^^^^^^^^^^
          help: add the library with the program, or correct the path: it names a program in the folder of its library
    "#]],
    );
    refused(
        CELL,
        &with("standIns/velJoint", "standIns/velJiont"),
        expect![[r#"
        error: `standIns.pjx` has no program `velJiont`
         --> val3.toml:4
          |
        4 | '$velJoint' = { program = "usrapp/standIns/velJiont.pgx" }
          | ^^^^^^^^^^^
          help: did you mean `velJoint`?
    "#]],
    );
    refused(
        CELL,
        &with("usrapp/standIns/velJoint", "velJoint"),
        expect![[r#"
        error: the path `velJoint.pgx` does not name the folder of the library with the program: `standIns/velJoint.pgx`
         --> val3.toml:3
          |
        3 | [run.add-ons]
          | ^^^^^^^^^^^^^
    "#]],
    );
    refused(
        CELL,
        &with("{ program = \"usrapp/standIns/velJoint.pgx\" }", "{ call = \"velJoint\" }"),
        expect![[r#"
        error: there is no setting `run.add-ons.$velJoint.call`
         --> val3.toml:4
          |
        4 | '$velJoint' = { call = "velJoint" }
          |                 ^^^^
          help: known settings: program
    "#]],
    );
    refused(
        CELL,
        &with("{ program = \"usrapp/standIns/velJoint.pgx\" }", "[1]"),
        expect![[r#"
        error: `run.add-ons.$velJoint` must be a text in quotes or a whole number or a number with a fraction or `true` or `false` or a table, and this is a list in square brackets
         --> val3.toml:4
          |
        4 | '$velJoint' = [1]
          |               ^^^
    "#]],
    );
    refused(
        &CELL.replace("public program velJoint", "program velJoint"),
        SETTINGS,
        expect![[r#"
        error: the program `velJoint` is not public, so that no other project can call it
         --> val3.toml:4
          |
        4 | '$velJoint' = { program = "usrapp/standIns/velJoint.pgx" }
          | ^^^^^^^^^^^
          help: write `access="public"` in its element <Program>
    "#]],
    );
    refused(
        &CELL.replace("nFactor=x_nFactor", "nFactor=x_nFaktor"),
        SETTINGS,
        expect![[r#"
        error: the library of `getVel` cannot be loaded: CELL/usrapp/standIns/velJoint.pgx:9: `x_nFaktor` is not declared: no local variable, parameter or data has this name
         --> val3.toml:6
          |
        6 | '$getVel' = { program = "usrapp/standIns/getVel" }
          | ^^^^^^^^^
          help: did you mean `x_nFactor`?
    "#]],
    );
    refused(
        CELL,
        &with("usrapp/standIns/velJoint", "../outside/velJoint"),
        expect![[r#"
        error: `run.add-ons.$velJoint` resolves to `../outside`, outside of the cell
         --> val3.toml:4
          |
        4 | '$velJoint' = { program = "../outside/velJoint.pgx" }
          | ^^^^^^^^^^^
          help: files in `CELL` count only inside it, unless you trust their author: val3 trust CELL
    "#]],
    );
}

/// Add-on table with `num $getVel(num)`.
const TABLE: &str = r#"
=== /configs/arm.cfx
<?xml version="1.0"?><Arm></Arm>
=== /app/val3.Velocity.anthro.cfx
<Language xmlns="http://www.staubli.com/robotics/VAL3/1"><Version>s7.11</Version><Functions>
<Func><Name>$getVel</Name><Return>num</Return><Param index="0" type="num" dataRef="false" array="false" arrayDim="0" /><Lib>false</Lib><Class>Function</Class></Func>
</Functions></Language>
"#;

#[test]
fn the_table_of_the_cell_decides_on_the_parameters() {
    let listing = "program start()\nbegin\n  ? $getVel(1)\nend\n--- standIns\n\
                   public program getVel(PARAMETERS)\nbegin\n  x_nResult=8\nend\n";
    let settings = "[run.add-ons]\n'$getVel' = { program = \"usrapp/standIns/getVel.pgx\" }\n";
    let with = |parameters: &str| format!("{}{TABLE}", listing.replace("PARAMETERS", parameters));
    prints(
        &cell(&with("num x_nAxis, num& x_nResult"), settings),
        expect![[r#"
        8
        0
    "#]],
    );
    refused(
        &with("num& x_nResult"),
        settings,
        expect![[r#"
        error: `getVel` has other parameters than the instruction, which is `num $getVel(num n1)` in the cell
         --> val3.toml:2
          |
        2 | '$getVel' = { program = "usrapp/standIns/getVel.pgx" }
          | ^^^^^^^^^
          help: declare the same parameters in this order; a last parameter by reference receives the result
    "#]],
    );
}

#[test]
fn without_a_table_calls_are_checked_against_the_program() {
    refused(
        &CELL.replacen("$velJoint(flange,2)", "$velJoint(2)", 1),
        SETTINGS,
        expect![[r#"
        error[V0204]: `$velJoint` takes 2 arguments; 1 is given
          ┌─ usrapp/main/start.pgx:5:3
          │
        5 │   $velJoint(2)
          │   ^^^^^^^^^^^^ 1 argument missing
          │
          = help: the form is `void $velJoint(tool x_tTool, num x_nFactor)`

    "#]],
    );
}
