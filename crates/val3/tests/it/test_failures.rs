//! `val3 test`: reports of failures.

use expect_test::{Expect, expect};

use crate::support::Folder;
use crate::test_command::cell;

/// Checks the output of tests with at least one failure.
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
                        5 │ call assert:equalString("abcdefghijabcdefghijabcdefghijabcdefghijabcdefghijabcdefghijabcdefghijabcdefghijabcdefghijabcdefghijx","abcdefghijabcdefghijabcdefghija…
              FAIL  testShort (0.004 s)
                    "full" instead of "Full"
                    at mainTest:testShort (usrapp/mainTest/testShort.pgx:5)
                        5 │ call assert:equalString("full","Full")
              FAIL  testText (0.004 s)
                    abcdefghijabcdefghijabcdefghijabcdefghijabcdefghijabcdefghijabcdefghijabcdefghijabcdefghijabcdefghij, and the end is false
                    at mainTest:testText (usrapp/mainTest/testText.pgx:5)
                        5 │ call assert:isTrue(false,"abcdefghijabcdefghijabcdefghijabcdefghijabcdefghijabcdefghijabcdefghijabcdefghijabcdefghijabcdefghij, and the end")
              FAIL  testWide (0.004 s)
                    the strings differ at position 30, from 0
                      actual    "你好你好你好你好你好你好你好你好你好你好你好你好你好你好你好好"
                      expected  "你好你好你好你好你好你好你好你好你好你好你好你好你好你好你好你"
                                                                                             ^ position 30, from 0
                    at mainTest:testWide (usrapp/mainTest/testWide.pgx:5)
                        5 │ call assert:equalString("你好你好你好你好你好你好你好你好你好你好你好你好你好你好你好好","你好你好你好你好你好你好你好你好你好你好你好你好你好你好你好你")
            failures:
              usrapp/mainTest/testLong.pgx:5: mainTest:testLong: the strings differ at position 100, from 0
              usrapp/mainTest/testShort.pgx:5: mainTest:testShort: "full" instead of "Full"
              usrapp/mainTest/testText.pgx:5: mainTest:testText: abcdefghijabcdefghijabcdefghijabcdefghijabcdefghijabcdefghijabcdefghijabcdefghijabcdefghijabcdefghij, and the end is false
              usrapp/mainTest/testWide.pgx:5: mainTest:testWide: the strings differ at position 30, from 0
            0 passed, 4 failed
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
                        5 │ ? sqrt(-1)
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
fn a_test_that_waits_shows_the_condition_and_its_values() {
    let folder = cell(&[
        ("testLoop", "nWanted=3\nwhile taskStatus(\"none\")!=nWanted\n  delay(0.1)\nendWhile"),
        ("testUntil", "nWanted=1\ndo\n  delay(0.1)\nuntil (nWanted<1)"),
        ("testWait", "nWanted=5\nwait(nWanted<3 and clock()>0 and sText==\"on\")"),
    ]);
    let data = folder.read("usrapp/mainTest/mainTest.dtx");
    let added = "<Datas>\n    <Data name=\"nWanted\" access=\"private\" xsi:type=\"array\" type=\"num\" size=\"1\" />\n    \
                 <Data name=\"sText\" access=\"private\" xsi:type=\"array\" type=\"string\" size=\"1\" />\n  </Datas>";
    folder.write("usrapp/mainTest/mainTest.dtx", &data.replace("<Datas />", added));
    check(
        &folder,
        &["--limit", "1"],
        expect![[r#"
            mainTest
              FAIL  testLoop (1.000 s)
                    not ended after 1 s: it waits for time (`delay`)
                      line 6: while taskStatus("none")!=nWanted
                        taskStatus("none") = -1
                        nWanted = 3
                    at mainTest:testLoop (usrapp/mainTest/testLoop.pgx:7)
                        7 │ delay(0.1)
              FAIL  testUntil (1.000 s)
                    not ended after 1 s: it waits for time (`delay`)
                      line 8: until (nWanted<1)
                        nWanted = 1
                    at mainTest:testUntil (usrapp/mainTest/testUntil.pgx:7)
                        7 │ delay(0.1)
              FAIL  testWait (1.000 s)
                    not ended after 1 s: it waits for a condition
                      line 6: wait(nWanted<3 and clock()>0 and sText=="on")
                        nWanted = 5
                        clock() = 1
                        sText = ""
                    at mainTest:testWait (usrapp/mainTest/testWait.pgx:6)
            failures:
              usrapp/mainTest/testLoop.pgx:7: mainTest:testLoop: not ended after 1 s: it waits for time (`delay`)
              usrapp/mainTest/testUntil.pgx:7: mainTest:testUntil: not ended after 1 s: it waits for time (`delay`)
              usrapp/mainTest/testWait.pgx:6: mainTest:testWait: not ended after 1 s: it waits for a condition
            0 passed, 3 failed
        "#]],
    );
}

#[test]
fn a_failure_shows_the_user_page_and_each_event_once() {
    let folder = cell(&[
        ("testPage", "cls()\nputln(\"Part 7\")\nputln(\"missing\")\ncall assert:fail(\"no part\")"),
        ("testBlank", "call assert:fail(\"no page\")"),
        (
            "testLog",
            "for nTimes=1 to 30\n  logMsg(\"again\")\n  delay(0.1)\nendFor\nlogMsg(\"last\")\ncall assert:fail(\"no end\")",
        ),
    ]);
    let data = folder.read("usrapp/mainTest/mainTest.dtx");
    let added = "<Datas>\n    <Data name=\"nTimes\" access=\"private\" xsi:type=\"array\" type=\"num\" size=\"1\" />\n  </Datas>";
    folder.write("usrapp/mainTest/mainTest.dtx", &data.replace("<Datas />", added));
    check(
        &folder,
        &[],
        expect![[r#"
            mainTest
              FAIL  testBlank (0.004 s)
                    no page
                    at mainTest:testBlank (usrapp/mainTest/testBlank.pgx:5)
                        5 │ call assert:fail("no page")
              FAIL  testLog (3.004 s)
                    no end
                    at mainTest:testLog (usrapp/mainTest/testLog.pgx:10)
                       10 │ call assert:fail("no end")
                    last events:
                      2.900 s  log: USR again (task `mainTest~`), 30 times since 0.000 s
                      3.000 s  log: USR last (task `mainTest~`)
              FAIL  testPage (0.004 s)
                    no part
                    at mainTest:testPage (usrapp/mainTest/testPage.pgx:8)
                        8 │ call assert:fail("no part")
                    the screen shows:
                      +
                      | Part 7
                      | missing
            failures:
              usrapp/mainTest/testBlank.pgx:5: mainTest:testBlank: no page
              usrapp/mainTest/testLog.pgx:10: mainTest:testLog: no end
              usrapp/mainTest/testPage.pgx:8: mainTest:testPage: no part
            0 passed, 3 failed
        "#]],
    );
    let run = folder.val3(&["test", "usrapp", "--events", "1", "--filter", "testLog"]);
    assert!(!run.stdout.contains("again"), "{run:?}");
}
