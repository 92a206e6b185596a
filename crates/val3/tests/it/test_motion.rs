//! `val3 test`: recorded motion.

use expect_test::{Expect, expect};

use crate::support::{CommandOutput, Folder};

/// A joint move, and two lines along x and y with a blend between them.
pub(crate) const CODE: &str = "mdesc mLine\njoint jReady\npoint pCorner\npoint pEnd\n  mLine.blend=joint\n  mLine.leave=20\n  \
                    mLine.reach=20\n  mLine.tvel=250\n  enablePower()\n  wait(isPowered())\n  jReady={0,0,90,0,90,0}\n  \
                    movej(jReady,flange,mLine)\n  waitEndMove()\n  pCorner=here(flange,world)\n  \
                    pCorner.trsf.z=pCorner.trsf.z-100\n  movel(pCorner,flange,mLine)\n  pEnd=pCorner\n  \
                    pEnd.trsf.y=pEnd.trsf.y+100\n  movel(pEnd,flange,mLine)\n  waitEndMove()\n";

const TRACE: &str = "[expect]\ntrace = \"golden/cycle.csv\"\n";

/// An application with this code and a scenario.
pub(crate) fn cell(code: &str, expectations: &str) -> Folder {
    let folder = Folder::with(code);
    expecting(&folder, expectations);
    folder
}

fn expecting(folder: &Folder, expectations: &str) {
    folder.write("tests/cycle.toml", &format!("application = \"../usrapp/main\"\n{expectations}"));
}

pub(crate) fn tested(folder: &Folder, options: &[&str]) -> CommandOutput {
    folder.val3(&[&["test", "tests", "--arm", "TX2-90"], options].concat())
}

/// A cell with recorded motion.
fn recorded() -> Folder {
    let folder = cell(CODE, TRACE);
    let update = tested(&folder, &["--update"]);
    assert_eq!((update.code, update.stderr.as_str()), (0, "recorded: tests/golden/cycle.csv\n"), "{update:?}");
    folder
}

/// Changes the code of the application, and checks the test result.
#[track_caller]
fn check_change(from: &str, to: &str, expected: Expect) {
    let folder = recorded();
    change(&folder, from, to);
    let run = tested(&folder, &[]);
    assert_eq!(run.code, 1, "{run:?}");
    expected.assert_eq(&run.stdout);
}

#[track_caller]
fn change(folder: &Folder, from: &str, to: &str) {
    let program = folder.read("usrapp/main/start.pgx");
    assert!(program.contains(from), "{program}");
    folder.write("usrapp/main/start.pgx", &program.replace(from, to));
}

#[test]
fn the_recorded_motion_is_the_same_again() {
    let folder = recorded();
    let run = tested(&folder, &[]);
    assert_eq!((run.code, run.stderr.as_str()), (0, ""), "{run:?}");
    assert!(!folder.path().join("tests/golden/cycle.failed.svg").exists());
    let text = folder.read("tests/golden/cycle.csv");
    let head: Vec<&str> = text.lines().take(3).collect();
    expect![[r#"
        # Motion of a test, recorded by `val3 test --update`: s, mm, degrees, mm/s
        # arm: TX2-90
        t,id,phase,j1,j2,j3,j4,j5,j6,x,y,z,rx,ry,rz,v"#]]
    .assert_eq(&head.join("\n"));
    // With every cycle of the 4.4 s, there would be 1,103 rows.
    assert!((50..300).contains(&text.lines().count()), "{}", text.lines().count());
    let again = tested(&folder, &["--update"]);
    assert_eq!((again.code, again.stderr.as_str()), (0, "unchanged: tests/golden/cycle.csv\n"));
    assert_eq!(folder.read("tests/golden/cycle.csv"), text);
}

#[test]
fn a_page_of_results_has_the_drawing_of_a_changed_motion() {
    let folder = recorded();
    change(&folder, "pEnd.trsf.y+100", "pEnd.trsf.y+90");
    let run = tested(&folder, &["--output", "html=report.html"]);
    assert_eq!(run.code, 1, "{run:?}");
    let (page, picture) = (folder.read("report.html"), folder.read("tests/golden/cycle.failed.svg"));
    assert!(page.contains(&format!("<figure>{picture}</figure>")), "{page}");
}

#[test]
fn a_trace_of_a_run_is_a_recorded_motion() {
    let folder = cell(CODE, TRACE);
    folder.write("tests/golden/.keep", "");
    let run = folder.val3(&["run", "usrapp/main", "--arm", "TX2-90", "--trace", "tests/golden/cycle.csv"]);
    assert_eq!(run.code, 0, "{run:?}");
    let run = tested(&folder, &[]);
    assert_eq!(run.code, 0, "{run:?}");
}

#[test]
fn a_changed_point_is_another_path() {
    check_change(
        "pEnd.trsf.y+100",
        "pEnd.trsf.y+90",
        expect![[r#"
            main
              FAIL  cycle (5.380 s)
                    the motion is not that of `golden/cycle.csv`
                    move 2 (movel, start:19) misses a part of the recorded path: 10.000 mm away, recorded at 5.416 s at (475.0, 150.0, 225.0); this is the largest deviation
                    move 2 (movel, start:19) takes 0.364 s instead of 0.404 s (-9.9 %)
                    both motions: golden/cycle.failed.svg
                    at start (usrapp/main/start.pgx:19)
                       19 │ movel(pEnd,flange,mLine)
                    at expect.trace (tests/cycle.toml:3)
                    last events:
                      1.004 s  power on
                      1.008 s  movej 0 started, start:12
                      4.620 s  movel 1 started, start:16
                      5.084 s  movel 2 started, start:19
            0 passed, 1 failed
        "#]],
    );
}

#[test]
fn a_changed_speed_is_another_time() {
    check_change(
        "mLine.tvel=250",
        "mLine.tvel=200",
        expect![[r#"
            main
              FAIL  cycle (6.504 s)
                    the motion is not that of `golden/cycle.csv`
                    move 0 (movej, start:12) takes 4.504 s instead of 3.612 s (+24.7 %); move 1 (movel, start:16) takes 0.492 s instead of 0.396 s (+24.2 %); move 2 (movel, start:19) takes 0.500 s instead of 0.404 s (+23.8 %)
                    the whole motion takes 5.496 s instead of 4.412 s (+24.6 %)
                    both motions: golden/cycle.failed.svg
                    at start (usrapp/main/start.pgx:12)
                       12 │ movej(jReady,flange,mLine)
                    at expect.trace (tests/cycle.toml:3)
                    last events:
                      1.004 s  power on
                      1.008 s  movej 0 started, start:12
                      5.512 s  movel 1 started, start:16
                      6.092 s  movel 2 started, start:19
            0 passed, 1 failed
        "#]],
    );
}

#[test]
fn a_changed_blend_is_another_path() {
    check_change(
        "mLine.leave=20",
        "mLine.leave=30",
        expect![[r#"
            main
              FAIL  cycle (5.416 s)
                    the motion is not that of `golden/cycle.csv`
                    move 1 (movel, start:16) misses a part of the recorded path: 1.248 mm away, recorded at 5.012 s at (475.0, 53.2, 229.3); this is the largest deviation
                    both motions: golden/cycle.failed.svg
                    at start (usrapp/main/start.pgx:16)
                       16 │ movel(pCorner,flange,mLine)
                    at expect.trace (tests/cycle.toml:3)
                    last events:
                      1.004 s  power on
                      1.008 s  movej 0 started, start:12
                      4.620 s  movel 1 started, start:16
                      5.080 s  movel 2 started, start:19
            0 passed, 1 failed
        "#]],
    );
}

#[test]
fn an_additional_move_is_named() {
    check_change(
        "waitEndMove()\nend",
        "movej(jReady,flange,mLine)\n  waitEndMove()\nend",
        expect![[r#"
            main
              FAIL  cycle (5.948 s)
                    the motion is not that of `golden/cycle.csv`
                    move 2 (movel, start:19) misses a part of the recorded path: 6.910 mm away, recorded at 5.416 s at (475.0, 150.0, 225.0); the largest deviation is in move 3 (movej, start:20): 141.421 mm away, at 5.944 s at (475.0, 50.0, 325.0)
                    the motion has 4 moves instead of 3
                    move 2 (movel, start:19) takes 0.372 s instead of 0.404 s (-7.9 %)
                    the whole motion takes 4.940 s instead of 4.412 s (+12.0 %)
                    both motions: golden/cycle.failed.svg
                    at start (usrapp/main/start.pgx:19)
                       19 │ movel(pEnd,flange,mLine)
                    at expect.trace (tests/cycle.toml:3)
                    last events:
                      1.004 s  power on
                      1.008 s  movej 0 started, start:12
                      4.620 s  movel 1 started, start:16
                      5.084 s  movel 2 started, start:19
                      5.448 s  movej 3 started, start:20
            0 passed, 1 failed
        "#]],
    );
}

#[test]
fn a_missing_move_is_named() {
    check_change(
        "movel(pEnd,flange,mLine)\n",
        "\n",
        expect![[r#"
            main
              FAIL  cycle (5.040 s)
                    the motion is not that of `golden/cycle.csv`
                    move 1 (movel, start:16) leaves the recorded path: 5.314 mm away, at 5.036 s at (475.0, 50.0, 225.0); the largest deviation is in move 2: 100.000 mm away, recorded at 5.416 s at (475.0, 150.0, 225.0)
                    the motion has 2 moves instead of 3
                    move 1 (movel, start:16) takes 0.420 s instead of 0.396 s (+6.1 %)
                    the whole motion takes 4.032 s instead of 4.412 s (-8.6 %)
                    both motions: golden/cycle.failed.svg
                    at start (usrapp/main/start.pgx:16)
                       16 │ movel(pCorner,flange,mLine)
                    at expect.trace (tests/cycle.toml:3)
                    last events:
                      1.004 s  power on
                      1.008 s  movej 0 started, start:12
                      4.620 s  movel 1 started, start:16
            0 passed, 1 failed
        "#]],
    );
}

#[test]
fn a_pause_is_another_time() {
    check_change(
        "movel(pCorner",
        "delay(0.5)\n  movel(pCorner",
        expect![[r#"
            main
              FAIL  cycle (5.920 s)
                    the motion is not that of `golden/cycle.csv`
                    the whole motion takes 4.912 s instead of 4.412 s (+11.3 %), at rest for 0.500 s instead of 0.000 s
                    both motions: golden/cycle.failed.svg
                    at expect.trace (tests/cycle.toml:3)
                        3 │ trace = "golden/cycle.csv"
                    last events:
                      1.004 s  power on
                      1.008 s  movej 0 started, start:12
                      5.120 s  movel 1 started, start:17
                      5.584 s  movel 2 started, start:20
            0 passed, 1 failed
        "#]],
    );
}

#[test]
fn tolerances_may_be_wider() {
    let folder = recorded();
    change(&folder, "pEnd.trsf.y+100", "pEnd.trsf.y+98");
    assert_eq!(tested(&folder, &[]).code, 1);
    expecting(&folder, "[expect]\ntrace = { file = \"golden/cycle.csv\", mm = 2.1, time = 8 }\n");
    let run = tested(&folder, &[]);
    assert_eq!(run.code, 0, "{run:?}");
    expecting(&folder, "[expect]\ntrace = { file = \"golden/cycle.csv\", mm = 1.9, time = 8 }\n");
    assert_eq!(tested(&folder, &[]).code, 1);
}

#[test]
fn both_motions_are_in_one_picture() {
    let folder = recorded();
    let program = folder.read("usrapp/main/start.pgx");
    change(&folder, "pEnd.trsf.y+100", "pEnd.trsf.y+90");
    assert_eq!(tested(&folder, &[]).code, 1);
    let picture = folder.read("tests/golden/cycle.failed.svg");
    let texts = picture
        .lines()
        .filter(|line| ["recorded", "deviation", "label\">start", "\"title"].iter().any(|part| line.contains(part)));
    let texts: Vec<&str> = texts.filter(|line| line.starts_with("<text") || line.starts_with("<line")).collect();
    expect![[r#"
        <text x="40.0" y="34.0" class="title">main</text>
        <text x="40.0" y="56.0" class="small">TX2-90, 3 moves (lines of start), 4.372 s, recorded 4.408 s</text>
        <text x="700.5" y="34.0" class="small">recorded</text>
        <text x="809.5" y="56.0" class="small">largest deviation: 10.000 mm away</text>
        <line x1="391.0" y1="277.6" x2="391.0" y2="283.0" class="deviation"/>
        <text x="400.0" y="276.2" class="deviation label">10.000 mm away</text>
        <line x1="906.0" y1="504.0" x2="906.0" y2="504.0" class="deviation"/>
        <text x="915.0" y="502.6" class="deviation label">10.000 mm away</text>
        <line x1="1342.4" y1="504.0" x2="1337.0" y2="504.0" class="deviation"/>
        <text x="1351.4" y="502.6" class="deviation label">10.000 mm away</text>
        <line x1="1560.0" y1="600.0" x2="1560.0" y2="1352.0" class="deviation"/>"#]]
    .assert_eq(&texts.join("\n"));
    // Three views, six axes, the speed, and the legend.
    assert_eq!(picture.matches("stroke:#c9c9c9;stroke-width:7").count(), 11);
    folder.write("usrapp/main/start.pgx", &program);
    assert_eq!(tested(&folder, &[]).code, 0);
    assert!(!folder.path().join("tests/golden/cycle.failed.svg").exists());
}

#[test]
fn a_changed_motion_is_recorded_again() {
    let folder = recorded();
    change(&folder, "pEnd.trsf.y+100", "pEnd.trsf.y+90");
    assert_eq!(tested(&folder, &[]).code, 1);
    let update = tested(&folder, &["--update"]);
    assert_eq!((update.code, update.stderr.as_str()), (0, "changed: tests/golden/cycle.csv\n"), "{update:?}");
    assert!(!folder.path().join("tests/golden/cycle.failed.svg").exists());
    assert_eq!(tested(&folder, &[]).code, 0);
}

#[test]
fn the_motion_of_teardown_does_not_belong_to_a_test() {
    let start = "num n\nn=1\n--- moveTest\nmdesc mLine\njoint jTo\nprogram start()\nbegin\nend\n";
    let folder = Folder::with(&[start, &moving("testMove", 90), &moving("teardown", 45)].concat());
    folder.write("usrapp/moveTest/testMove.toml", "[expect]\ntrace = \"move.csv\"\n");
    let tested =
        |options: &[&str]| folder.val3(&[&["test", "usrapp/moveTest", "--arm", "TX2-90", "--power"], options].concat());
    assert_eq!(tested(&["--update"]).code, 0);
    let program = folder.read("usrapp/moveTest/teardown.pgx");
    folder.write("usrapp/moveTest/teardown.pgx", &program.replace("0,0,45", "0,0,60"));
    let run = tested(&[]);
    assert_eq!(run.code, 0, "{run:?}");
}

/// Program that moves axis 3 to an angle.
fn moving(name: &str, angle: u32) -> String {
    format!("program {name}()\nbegin\n  jTo={{0,0,{angle},0,90,0}}\n  movej(jTo,flange,mLine)\n  waitEndMove()\nend\n")
}

#[test]
fn a_test_with_another_failure_is_not_recorded() {
    let folder = cell(CODE, "[expect]\ntrace = \"golden/cycle.csv\"\nprint = [\"done\"]\n");
    let update = tested(&folder, &["--update"]);
    assert_eq!(update.code, 1, "{update:?}");
    assert_eq!(update.stderr, "not recorded, because the test has failed: tests/golden/cycle.csv\n");
    assert!(!folder.path().join("tests/golden").exists());
}

/// Checks the failure message for a file with this text.
#[track_caller]
fn check_file(text: Option<&str>, expected: Expect) {
    let folder = cell(CODE, TRACE);
    if let Some(text) = text {
        folder.write("tests/golden/cycle.csv", text);
    }
    let run = tested(&folder, &[]);
    assert_eq!(run.code, 1, "{run:?}");
    let lines: Vec<&str> = run.stdout.lines().skip(2).map(str::trim).collect();
    expected.assert_eq(&lines.join("\n"));
}

#[test]
fn files_that_are_missing_or_broken() {
    check_file(
        None,
        expect![[r#"
            there is no recorded motion `golden/cycle.csv`: `val3 test --update` records this motion
            at expect.trace (tests/cycle.toml:3)
            3 │ trace = "golden/cycle.csv"
            last events:
            1.004 s  power on
            1.008 s  movej 0 started, start:12
            4.620 s  movel 1 started, start:16
            5.084 s  movel 2 started, start:19
            0 passed, 1 failed"#]],
    );
    check_file(
        Some("x;y\n"),
        expect![[r#"
            the recorded motion `golden/cycle.csv` cannot be read: line 1: a trace begins with the names of its columns, as in `t,id,phase,j1,j2,j3,j4,j5,j6,x,y,z,rx,ry,rz,v`: `x;y` are others; `val3 test --update` records this motion
            at expect.trace (tests/cycle.toml:3)
            3 │ trace = "golden/cycle.csv"
            last events:
            1.004 s  power on
            1.008 s  movej 0 started, start:12
            4.620 s  movel 1 started, start:16
            5.084 s  movel 2 started, start:19
            0 passed, 1 failed"#]],
    );
    let head = "# arm: TX2-90\nt,id,phase,j1,j2,j3,j4,j5,j6,x,y,z,rx,ry,rz,v\n";
    check_file(
        Some(&format!("{head}0.1,1,nominal,0,0,x,0,0,0,0,0,0,0,0,0,0\n")),
        expect![[r#"
            the recorded motion `golden/cycle.csv` cannot be read: line 3: column j3: `x` is not a number; `val3 test --update` records this motion
            at expect.trace (tests/cycle.toml:3)
            3 │ trace = "golden/cycle.csv"
            last events:
            1.004 s  power on
            1.008 s  movej 0 started, start:12
            4.620 s  movel 1 started, start:16
            5.084 s  movel 2 started, start:19
            0 passed, 1 failed"#]],
    );
    check_file(
        Some(head),
        expect![[r#"
            the motion is not that of `golden/cycle.csv`
            move 0 (movej, start:12) is not in the recorded motion
            the motion has 3 moves instead of 0
            the whole motion takes 4.412 s instead of 0.000 s
            both motions: golden/cycle.failed.svg
            at start (usrapp/main/start.pgx:12)
            12 │ movej(jReady,flange,mLine)
            at expect.trace (tests/cycle.toml:3)
            last events:
            1.004 s  power on
            1.008 s  movej 0 started, start:12
            4.620 s  movel 1 started, start:16
            5.084 s  movel 2 started, start:19
            0 passed, 1 failed"#]],
    );
}

#[test]
fn another_arm_is_a_failure() {
    let folder = recorded();
    let run = folder.val3(&["test", "tests", "--arm", "TX2-60L"]);
    assert_eq!(run.code, 1, "{run:?}");
    expect![[r#"
        main
          FAIL  cycle (5.272 s)
                `golden/cycle.csv` was recorded with a TX2-90, and this arm is a TX2-60L: choose the arm with --arm or in val3.toml; `val3 test --update` records this motion
                at expect.trace (tests/cycle.toml:3)
                    3 │ trace = "golden/cycle.csv"
                last events:
                  1.004 s  power on
                  1.008 s  movej 0 started, start:12
                  4.472 s  movel 1 started, start:16
                  4.936 s  movel 2 started, start:19
        0 passed, 1 failed
    "#]].assert_eq(&run.stdout);
}

/// Several tests may be recorded with any number of threads.
#[test]
fn every_test_has_its_file() {
    let folder = cell(CODE, TRACE);
    folder.write("tests/other.toml", "application = \"../usrapp/main\"\n[expect]\ntrace = \"golden/other.csv\"\n");
    let update = tested(&folder, &["--update", "--jobs", "4", "--seed", "3"]);
    assert_eq!(update.stderr, "recorded: tests/golden/cycle.csv\nrecorded: tests/golden/other.csv\n", "{update:?}");
    assert_eq!(folder.read("tests/golden/cycle.csv"), folder.read("tests/golden/other.csv"));
}

#[test]
fn a_recording_replaces_only_recordings_of_its_cell() {
    for (file, message) in [
        ("../../home/.bashrc", "`expect.trace` names `"),
        ("notes.txt", "it exists and is no recorded motion"),
        ("/etc/new.csv", "`expect.trace` names `/etc/new.csv`, outside of the cell"),
    ] {
        let folder = cell(CODE, &format!("[expect]\ntrace = \"{file}\"\n"));
        folder.write("tests/notes.txt", "mine");
        let run = tested(&folder, &["--update"]);
        assert_eq!(run.code, 2, "{run:?}");
        assert!(run.stdout.contains(message), "{run:?}");
        assert_eq!(folder.read("tests/notes.txt"), "mine");
    }
}
