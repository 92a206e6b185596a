//! `val3 test`: limits for the tool centre point and the cycle time.

use expect_test::{Expect, expect};

use crate::test_motion::{CODE, cell, tested};

/// Checks the failures of expectations, without their file locations.
#[track_caller]
fn check_limits(expectations: &str, expected: Expect) {
    let folder = cell(&format!("num nStep\nframe fTable\n  fTable.trsf.y=50\n{CODE}"), expectations);
    let run = tested(&folder, &[]);
    let lines: Vec<&str> = run.stdout.lines().skip(1).map(str::trim).collect();
    expected.assert_eq(&lines.join("\n"));
}

#[test]
fn boxes_in_frames() {
    check_limits(
        "[[expect.inside]]\nbox = { min = [0, -10, 0], max = [1000, 60, 1500], frame = \"fTable\" }\n",
        expect![[r#"
            FAIL  cycle (5.420 s)
            the tool centre point is 40.000 mm outside of its box, at 5.416 s at (475.0, 150.0, 225.0), in move 2 (movel, start:20)
            at start (usrapp/main/start.pgx:20)
            20 │ movel(pEnd,flange,mLine)
            at expect.inside (tests/cycle.toml:2)
            last events:
            1.004 s  power on
            1.008 s  movej 0 started, start:13
            4.620 s  movel 1 started, start:17
            5.084 s  movel 2 started, start:20
            0 passed, 1 failed"#]],
    );
    check_limits(
        "[[expect.inside]]\nbox = { min = [0, 0, 0], max = [1, 1, 1], frame = \"fTabel\" }\n",
        expect![[r#"
            FAIL  cycle (5.420 s)
            the box has no place: there is no frame `fTabel` in the application, or it has no reference
            at expect.inside (tests/cycle.toml:2)
            last events:
            1.004 s  power on
            1.008 s  movej 0 started, start:13
            4.620 s  movel 1 started, start:17
            5.084 s  movel 2 started, start:20
            0 passed, 1 failed"#]],
    );
}

/// The note appears once for all tests of an arm, and only if a limit was compared with motion times.
#[test]
fn limits_of_times_of_a_model_arm_are_noted_once() {
    let limited = cell(CODE, "[[expect.time]]\nbelow = 10\n");
    let run = tested(&limited, &["--repeat", "2", "--format", "json"]);
    assert_eq!(run.stderr.matches("note: times of a model arm: ").count(), 1, "{run:?}");
    assert_eq!(run.stdout.matches("\"timesNote\": \"times of a model arm: ").count(), 2, "{run:?}");
    let idle = tested(&cell("delay(1)\n", "[[expect.time]]\nbelow = 10\n"), &[]);
    let unlimited = tested(&cell(CODE, "[expect]\nerrors = []\n"), &["--format", "json"]);
    assert!(unlimited.stdout.contains("\"timesNote\": null"), "{unlimited:?}");
    assert_eq!((idle.stderr.as_str(), unlimited.stderr.as_str()), ("", ""));
}
