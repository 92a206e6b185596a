//! `val3 test`: a failure shows the fault.

use expect_test::{Expect, expect};

use crate::support::Folder;
use crate::test_command::cell;

/// Checks the output of tests of which one fails at least.
#[track_caller]
fn check(folder: &Folder, options: &[&str], expected: Expect) {
    let run = folder.val3(&[&["test", "usrapp"], options].concat());
    assert_eq!(run.code, 1, "{run:?}");
    expected.assert_eq(&run.stdout);
}

#[test]
fn strings_are_shown_in_full_with_a_mark() {
    let wide = "你好".repeat(15);
    let long = "abcdefghij".repeat(10);
    let code = |actual: &str, expected: &str| format!("call assert:equalString(\"{actual}\",\"{expected}\")");
    let folder = cell(&[
        ("testLong", &code(&format!("{long}x"), &format!("{long}y"))),
        ("testWide", &code(&format!("{wide}好"), &format!("{wide}你"))),
        ("testShort", &code("full", "Full")),
        ("testText", &format!("call assert:isTrue(false,\"{long}, and the end\")")),
    ]);
    check(
        &folder,
        &[],
        expect![[r#"
            mainTest
              FAIL  testLong (0.004 s)
                    the strings differ at position 100, from 0
                      actual    "abcdefghijabcdefghijabcdefghijabcdefghijabcdefghijabcdefghijabcdefghijabcdefghijabcdefghijabcdefghijx"
                      expected  "abcdefghijabcdefghijabcdefghijabcdefghijabcdefghijabcdefghijabcdefghijabcdefghijabcdefghijabcdefghijy"
                                                                                                                                     ^ position 100, from 0
                    at mainTest:testLong (usrapp/mainTest/testLong.pgx:5)
              FAIL  testShort (0.004 s)
                    "full" instead of "Full"
                    at mainTest:testShort (usrapp/mainTest/testShort.pgx:5)
              FAIL  testText (0.004 s)
                    abcdefghijabcdefghijabcdefghijabcdefghijabcdefghijabcdefghijabcdefghijabcdefghijabcdefghijabcdefghij, and the end is false
                    at mainTest:testText (usrapp/mainTest/testText.pgx:5)
              FAIL  testWide (0.004 s)
                    the strings differ at position 30, from 0
                      actual    "你好你好你好你好你好你好你好你好你好你好你好你好你好你好你好好"
                      expected  "你好你好你好你好你好你好你好你好你好你好你好你好你好你好你好你"
                                                                                             ^ position 30, from 0
                    at mainTest:testWide (usrapp/mainTest/testWide.pgx:5)
            0 passed, 4 failed
        "#]],
    );
}

#[test]
fn numbers_and_positions_show_what_differs() {
    let folder = cell(&[
        ("testNum", "call assert:equalNum(0.1+0.2,0.3,0)"),
        ("testJoint", "call assert:equalJoint({1,2.5,3,4,5,6},{1,2,3,4,5,7},0.1)"),
        ("testTrsf", "call assert:equalTrsf({1,2,3,0,0,5},{1,2,3,0,0,0},0.5,1)"),
    ]);
    check(
        &folder,
        &[],
        expect![[r#"
        mainTest
          FAIL  testJoint (0.004 s)
                axis 2: 2.5 instead of 2 (0.5 degrees away, tolerance 0.1)
                axis 6: 6 instead of 7 (1 degree away, tolerance 0.1)
                  actual    {1,2.5,3,4,5,6}
                  expected  {1,2,3,4,5,7}
                at mainTest:testJoint (usrapp/mainTest/testJoint.pgx:5)
          FAIL  testNum (0.004 s)
                0.30000000000000004 instead of 0.3 (5.55112e-17 away, tolerance 0)
                at mainTest:testNum (usrapp/mainTest/testNum.pgx:5)
          FAIL  testTrsf (0.004 s)
                0 mm and 5 degrees away, tolerances 0.5 mm and 1 degree
                  actual    {1,2,3,0,0,5}
                  expected  {1,2,3,0,0,0}
                at mainTest:testTrsf (usrapp/mainTest/testTrsf.pgx:5)
        0 passed, 3 failed
    "#]],
    );
}

#[test]
fn errors_show_the_programs_that_led_there() {
    let folder = cell(&[("testRoot", "? 1\ncall root()"), ("root", "call deeper()"), ("deeper", "? sqrt(-1)")]);
    check(
        &folder,
        &[],
        expect![[r#"
        mainTest
          FAIL  testRoot (0.004 s)
                error 11: invalid numeric value
                at mainTest:deeper (usrapp/mainTest/deeper.pgx:5)
                at mainTest:root (usrapp/mainTest/root.pgx:5)
                at mainTest:testRoot (usrapp/mainTest/testRoot.pgx:6)
                | 1
                last events:
                  0.000 s  error 11: invalid numeric value at deeper:5 (task `mainTest~`)
        0 passed, 1 failed
    "#]],
    );
}

#[test]
fn an_assertion_in_another_task_shows_its_own_place() {
    let folder = cell(&[
        ("testTask", "taskCreate \"worker\",10,worker()\nwait(false)"),
        ("worker", "call deeper()"),
        ("deeper", "call assert:fail(\"deep\")"),
    ]);
    check(
        &folder,
        &[],
        expect![[r#"
        mainTest
          FAIL  testTask (0.004 s)
                deep
                at mainTest:deeper (usrapp/mainTest/deeper.pgx:5)
                at mainTest:worker (usrapp/mainTest/worker.pgx:5)
                last events:
                  0.000 s  task `worker` created at worker:5 (task `mainTest~`)
        0 passed, 1 failed
    "#]],
    );
}

#[test]
fn an_expected_error_is_named_when_another_one_or_none_comes() {
    let folder = cell(&[
        ("testNone", "call assert:expectError(20)\n? 1"),
        ("testOther", "call expecting()\n? sqrt(-1)"),
        ("expecting", "call assert:expectError(20)"),
    ]);
    check(
        &folder,
        &[],
        expect![[r#"
        mainTest
          FAIL  testNone (0.008 s)
                error 20 (index too large) was expected, and nothing has raised it
                at mainTest:testNone (usrapp/mainTest/testNone.pgx:5)
                | 1
          FAIL  testOther (0.008 s)
                error 11: invalid numeric value
                  instead of error 20 (index too large), which `expectError` expects
                at mainTest:testOther (usrapp/mainTest/testOther.pgx:6)
                at expectError(20) (usrapp/mainTest/expecting.pgx:5)
                last events:
                  0.004 s  error 11: invalid numeric value at testOther:6 (task `mainTest~`)
        0 passed, 2 failed
    "#]],
    );
}
