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
fn limits_of_speed() {
    check_limits(
        "[[expect.speed]]\nbelow = 2000\n",
        expect![[r#"
        ok    cycle (5.420 s)
        1 passed, 0 failed"#]],
    );
    check_limits(
        "[[expect.speed]]\nbelow = 500\n",
        expect![[r#"
        ok    cycle (5.420 s)
        1 passed, 0 failed"#]],
    );
    let zone = |x: f64| format!("box = {{ min = [{x}, -20, 300], max = [1000, 200, 800] }}\n");
    check_limits(
        &format!("[[expect.speed]]\nbelow = 250\n{}", zone(470.0)),
        expect![[r#"
        ok    cycle (5.420 s)
        1 passed, 0 failed"#]],
    );
    check_limits(
        &format!("[[expect.speed]]\nbelow = 240\n{}", zone(470.0)),
        expect![[r#"
            FAIL  cycle (5.420 s)
            the tool centre point moves at 250.0 mm/s instead of at most 240 mm/s, at 4.664 s at (475.0, 50.0, 316.7), in move 1 (movel, start:17)
            at start (usrapp/main/start.pgx:17)
            17 │ movel(pCorner,flange,mLine)
            at expect.speed (tests/cycle.toml:2)
            last events:
            1.004 s  power on
            1.008 s  movej 0 started, start:13
            4.620 s  movel 1 started, start:17
            5.084 s  movel 2 started, start:20
            0 passed, 1 failed"#]],
    );
}

#[test]
fn boxes_to_stay_in_and_to_keep_away_from() {
    check_limits(
        "[[expect.inside]]\nbox = { min = [0, -10, 0], max = [1000, 200, 1500] }\n",
        expect![[r#"
        ok    cycle (5.420 s)
        1 passed, 0 failed"#]],
    );
    check_limits(
        "[[expect.inside]]\nbox = { min = [0, -10, 0], max = [1000, 60, 1500] }\n",
        expect![[r#"
            FAIL  cycle (5.420 s)
            the tool centre point is 90.000 mm outside of its box, at 5.416 s at (475.0, 150.0, 225.0), in move 2 (movel, start:20)
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
        &clear(30.0),
        expect![[r#"
            FAIL  cycle (5.420 s)
            the tool centre point comes within 25.000 mm of the box to which it must keep 30 mm, at 5.416 s at (475.0, 150.0, 225.0), in move 2 (movel, start:20)
            at start (usrapp/main/start.pgx:20)
            20 │ movel(pEnd,flange,mLine)
            at expect.clear (tests/cycle.toml:2)
            last events:
            1.004 s  power on
            1.008 s  movej 0 started, start:13
            4.620 s  movel 1 started, start:17
            5.084 s  movel 2 started, start:20
            0 passed, 1 failed"#]],
    );
    check_limits(
        &clear(60.0),
        expect![[r#"
            FAIL  cycle (5.420 s)
            the tool centre point comes within 25.000 mm of the box to which it must keep 60 mm, at 5.416 s at (475.0, 150.0, 225.0), in move 2 (movel, start:20)
            at start (usrapp/main/start.pgx:20)
            20 │ movel(pEnd,flange,mLine)
            at expect.clear (tests/cycle.toml:2)
            last events:
            1.004 s  power on
            1.008 s  movej 0 started, start:13
            4.620 s  movel 1 started, start:17
            5.084 s  movel 2 started, start:20
            0 passed, 1 failed"#]],
    );
}

fn clear(distance: f64) -> String {
    format!("[[expect.clear]]\nbox = {{ min = [500, 150, 0], max = [600, 200, 1000] }}\ndistance = {distance}\n")
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

#[test]
fn limits_of_the_cycle_time() {
    check_limits(
        "[[expect.time]]\nbelow = 10\n",
        expect![[r#"
        ok    cycle (5.420 s)
        1 passed, 0 failed"#]],
    );
    check_limits(
        "[[expect.time]]\nbelow = 1\n",
        expect![[r#"
            FAIL  cycle (5.420 s)
            the cycle takes 5.420 s instead of at most 1 s, from 0.000 s to 5.420 s
            at expect.time (tests/cycle.toml:2)
            last events:
            1.004 s  power on
            1.008 s  movej 0 started, start:13
            4.620 s  movel 1 started, start:17
            5.084 s  movel 2 started, start:20
            0 passed, 1 failed"#]],
    );
    check_limits(
        "[[expect.time]]\nbelow = 5.420\n",
        expect![[r#"
        ok    cycle (5.420 s)
        1 passed, 0 failed"#]],
    );
    check_limits(
        "[[expect.time]]\nbelow = 5.419\n",
        expect![[r#"
            FAIL  cycle (5.420 s)
            the cycle takes 5.420 s instead of at most 5.419 s, from 0.000 s to 5.420 s
            at expect.time (tests/cycle.toml:2)
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
    let unlimited = tested(&cell(CODE, "[expect]\nprint = []\n"), &["--format", "json"]);
    assert!(unlimited.stdout.contains("\"timesNote\": null"), "{unlimited:?}");
    assert_eq!((idle.stderr.as_str(), unlimited.stderr.as_str()), ("", ""));
}

/// Checks a cycle of 0.2 s and a cycle of 0.5 s. At their start, `nStep` is 1, and at their end, 2.
#[track_caller]
fn check_cycles(expectations: &str, expected: Expect) {
    let code = "num nStep\n  nStep=0\n  delay(1)\n  nStep=1\n  delay(0.2)\n  nStep=2\n  delay(1)\n  nStep=1\n  delay(0.5)\n  \
                nStep=2\n  delay(0.1)\n  nStep=1\n  delay(3)\n";
    let folder = cell(code, expectations);
    let run = tested(&folder, &[]);
    let lines: Vec<&str> = run.stdout.lines().skip(1).map(str::trim).collect();
    expected.assert_eq(&lines.join("\n"));
}

#[test]
fn cycles_between_two_occurrences() {
    let time = |keys: &str| format!("[[expect.time]]\n{keys}\n");
    let (from, to) = ("from = { data = { nStep = 1 } }", "to = { data = { nStep = 2 } }");
    // The last cycle has no end.
    check_cycles(
        &time(&format!("below = 0.5\n{from}\n{to}")),
        expect![[r#"
        ok    cycle (5.804 s)
        1 passed, 0 failed"#]],
    );
    check_cycles(
        &time(&format!("below = 0.49\n{from}\n{to}")),
        expect![[r#"
            FAIL  cycle (5.804 s)
            the cycle takes 0.500 s instead of at most 0.49 s, from 2.204 s to 2.704 s
            at expect.time (tests/cycle.toml:2)
            0 passed, 1 failed"#]],
    );
    check_cycles(
        &time(&format!("below = 4\n{from}")),
        expect![[r#"
            FAIL  cycle (5.804 s)
            the cycle takes 4.800 s instead of at most 4 s, from 1.004 s to 5.804 s
            at expect.time (tests/cycle.toml:2)
            0 passed, 1 failed"#]],
    );
    check_cycles(
        &time(&format!("below = 1\n{to}")),
        expect![[r#"
            FAIL  cycle (5.804 s)
            the cycle takes 1.204 s instead of at most 1 s, from 0.000 s to 1.204 s
            at expect.time (tests/cycle.toml:2)
            0 passed, 1 failed"#]],
    );
    check_cycles(
        &time(&format!("below = 1.1\n{from}\nto = {{ data = {{ nStep = 1 }} }}")),
        expect![[r#"
            FAIL  cycle (5.804 s)
            the cycle takes 1.200 s instead of at most 1.1 s, from 1.004 s to 2.204 s
            at expect.time (tests/cycle.toml:2)
            0 passed, 1 failed"#]],
    );
    check_cycles(
        &time(&format!("below = 9\n{from}\nto = {{ data = {{ nStep = 3 }} }}")),
        expect![[r#"
            FAIL  cycle (5.804 s)
            since 1.004 s it did not happen that `nStep` is 3
            `nStep` is 1, not 3
            at expect.time (tests/cycle.toml:2)
            0 passed, 1 failed"#]],
    );
    check_cycles(
        &time("below = 9\nfrom = { data = { nStep = 3 } }"),
        expect![[r#"
            FAIL  cycle (5.804 s)
            it did not happen that `nStep` is 3
            `nStep` is 1, not 3
            at expect.time (tests/cycle.toml:2)
            0 passed, 1 failed"#]],
    );
}

#[test]
fn names_of_cycles_exist() {
    let folder = cell("num nStep\n  nStep=1\n", "[[expect.time]]\nbelow = 9\nfrom = { data = { nStop = 3 } }\n");
    let run = tested(&folder, &[]);
    assert_eq!(run.code, 2, "{run:?}");
    assert!(run.stdout.contains("there is no variable `nStop`; did you mean `nStep`?"), "{run:?}");
}
