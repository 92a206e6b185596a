//! Messages of failed assertions.

use expect_test::{Expect, expect};

use crate::bench::Bench;

/// Opens a test application with these programs, their locals and the code.
#[track_caller]
pub(crate) fn bench(programs: &[(&str, &str)]) -> Bench {
    let program = |(head, code): &(&str, &str)| {
        let (name, locals) = head.split_once(' ').unwrap_or((head, ""));
        format!("program {name}()\n{locals}\nbegin\n{code}\nend\n")
    };
    let programs: String = programs.iter().map(program).collect();
    let libraries = "library assert \"Disk://val3assert/val3assert.pjx\"\nnum nOne[3]\nnum nOther[3]";
    Bench::open(&format!("num nUnused\n--- mainTest\n{libraries}\n{programs}"), "mainTest")
}

#[track_caller]
fn check(programs: &[(&str, &str)], expected: Expect) {
    expected.assert_eq(&bench(programs).tests());
}

#[test]
fn numbers_positions_and_texts_show_what_differs() {
    check(
        &[
            ("testAbout", "call assert:about(\"sum\")\ncall assert:equalNum(1,2,0)"),
            ("testBool", "call assert:equalBool(false,true)"),
            ("testContains", "call assert:contains(\"abc\",\"cb\")"),
            ("testFail", "call assert:fail(\"not yet\")"),
            ("testJoint", "call assert:equalJoint({1,2.5,3,4,5,6},{1,2,3,4,5,7},0.1)"),
            ("testNotString", "call assert:notEqualString(\"a\",\"a\")"),
            ("testNum", "call assert:equalNum(0.1+0.2,0.3,0)"),
            ("testNums", "nOther[2]=1\ncall assert:equalNums(nOne,nOther,0.5)"),
            ("testString", "call assert:equalString(\"full\",\"Full\")"),
            ("testTrsf", "call assert:equalTrsf({1,2,3,0,0,5},{1,2,3,0,0,0},0.5,1)"),
            ("testTrue", "call assert:isTrue(2<1,\"2<1\")"),
        ],
        expect![[r#"
            testAbout: failed, 0.004 s
            sum: 1 instead of 2 (1 away, tolerance 0)
              at mainTest:testAbout (mainTest/testAbout.pgx:6)
            testBool: failed, 0.004 s
            false instead of true
              at mainTest:testBool (mainTest/testBool.pgx:5)
            testContains: failed, 0.004 s
            "abc" does not contain "cb"
              at mainTest:testContains (mainTest/testContains.pgx:5)
            testFail: failed, 0.004 s
            not yet
              at mainTest:testFail (mainTest/testFail.pgx:5)
            testJoint: failed, 0.004 s
            axis 2: 2.5 instead of 2 (0.5 degrees away, tolerance 0.1)
            axis 6: 6 instead of 7 (1 degree away, tolerance 0.1)
              actual    {1,2.5,3,4,5,6}
              expected  {1,2,3,4,5,7}
              at mainTest:testJoint (mainTest/testJoint.pgx:5)
            testNotString: failed, 0.004 s
            not expected: "a"
              at mainTest:testNotString (mainTest/testNotString.pgx:5)
            testNum: failed, 0.004 s
            0.30000000000000004 instead of 0.3 (5.55112e-17 away, tolerance 0)
              at mainTest:testNum (mainTest/testNum.pgx:5)
            testNums: failed, 0.004 s
            [2]: 0 instead of 1
              at mainTest:testNums (mainTest/testNums.pgx:6)
            testString: failed, 0.004 s
            "full" instead of "Full"
              at mainTest:testString (mainTest/testString.pgx:5)
            testTrsf: failed, 0.004 s
            0 mm and 5 degrees away, tolerances 0.5 mm and 1 degree
              actual    {1,2,3,0,0,5}
              expected  {1,2,3,0,0,0}
              at mainTest:testTrsf (mainTest/testTrsf.pgx:5)
            testTrue: failed, 0.004 s
            2<1 is false
              at mainTest:testTrue (mainTest/testTrue.pgx:5)
        "#]],
    );
}

/// The message in the event log is cut at 128 bytes.
#[test]
fn texts_are_complete() {
    let long = "abcdefghij".repeat(10);
    let mut bench = bench(&[("testText", &format!("call assert:isTrue(false,\"{long}, and the end\")"))]);
    assert_eq!(bench.test("testText", "").failures[0].message, format!("{long}, and the end is false"));
}

#[test]
fn assertions_that_hold_pass() {
    let code = "call assert:isTrue(1<2,\"1<2\")\ncall assert:equalNum(1.4,1,0.4)\ncall assert:equalString(\"a\",\"a\")\n\
                call assert:equalBool(false,false)\ncall assert:contains(\"abc\",\"bc\")\n\
                call assert:equalJoint({1,2,3,4,5,6},{1,2,3,4,5,6.5},0.5)\n\
                call assert:equalTrsf({1,2,3,0,0,180},{1,2,3.5,0,0,-180},0.5,0.001)\n\
                call assert:notEqualNum(1,2,0.5)\ncall assert:notEqualString(\"a\",\"b\")\n\
                call assert:equalNums(nOne,nOther,0)";
    check(
        &[("testAll", code)],
        expect![[r#"
        testAll: ok, 0.004 s
    "#]],
    );
}

#[test]
fn what_is_no_number_equals_nothing() {
    let big = "l_nBig=10\nwhile l_nBig<1e300\nl_nBig=l_nBig*10\nendWhile\nl_nBig=l_nBig*1e300\n";
    let programs = [
        ("testJoint num l_nBig", "call assert:equalJoint({1,2,3,4,l_nBig-l_nBig,6},{1,2,3,4,5,6},1)"),
        ("testNum num l_nBig", "call assert:equalNum(l_nBig-l_nBig,5,0)"),
        ("testTrsf num l_nBig", "call assert:equalTrsf({l_nBig-l_nBig,0,0,0,0,0},{0,0,0,0,0,0},1,1)"),
    ];
    let programs = programs.map(|(head, code)| (head, format!("{big}{code}")));
    let programs: Vec<_> = programs.iter().map(|(head, code)| (*head, code.as_str())).collect();
    check(
        &programs,
        expect![[r#"
        testJoint: failed, 0.004 s
        axis 5: nan instead of 5
          actual    {1,2,3,4,nan,6}
          expected  {1,2,3,4,5,6}
          at mainTest:testJoint (mainTest/testJoint.pgx:13)
        testNum: failed, 0.004 s
        nan instead of 5
          at mainTest:testNum (mainTest/testNum.pgx:13)
        testTrsf: failed, 0.004 s
        nan mm and 0 degrees away, tolerances 1 mm and 1 degree
          actual    {nan,0,0,0,0,0}
          expected  {0,0,0,0,0,0}
          at mainTest:testTrsf (mainTest/testTrsf.pgx:13)
    "#]],
    );
}

#[test]
fn errors_and_assertions_show_the_programs_that_led_there() {
    check(
        &[
            ("testRoot", "? 1\ncall root()"),
            ("root", "call deeper()"),
            ("deeper", "? sqrt(-1)"),
            ("testTask", "taskCreate \"worker\",10,worker()\nwait(false)"),
            ("worker", "call failing()"),
            ("failing", "call assert:fail(\"deep\")"),
        ],
        expect![[r#"
            testRoot: failed, 0.004 s
            error 11: invalid numeric value
              at mainTest:deeper (mainTest/deeper.pgx:5)
              at mainTest:root (mainTest/root.pgx:5)
              at mainTest:testRoot (mainTest/testRoot.pgx:6)
            testTask: failed, 0.004 s
            deep
              at mainTest:failing (mainTest/failing.pgx:5)
              at mainTest:worker (mainTest/worker.pgx:5)
        "#]],
    );
}

#[test]
fn an_expected_error_is_named_when_another_one_or_none_comes() {
    check(
        &[
            ("testExpected", "call assert:expectError(11)\n? sqrt(-1)\ncall assert:fail(\"not reached\")"),
            ("testNone", "call assert:expectError(20)\n? 1"),
            ("testOther", "call expecting()\n? sqrt(-1)"),
            ("testWrong", "call assert:expectError(-1)\n? 1"),
            ("expecting", "call assert:expectError(20)"),
        ],
        expect![[r#"
            testExpected: ok, 0.008 s
            testNone: failed, 0.008 s
            error 20 (index too large) was expected, and nothing has raised it
              at mainTest:testNone (mainTest/testNone.pgx:5)
            testOther: failed, 0.008 s
            error 11: invalid numeric value
              instead of error 20 (index too large), which `expectError` expects
              at mainTest:testOther (mainTest/testOther.pgx:6)
              at expectError(20) (mainTest/expecting.pgx:5)
            testWrong: failed, 0.004 s
            `expectError` needs the number of a run-time error, not -1
              at mainTest:testWrong (mainTest/testWrong.pgx:5)
        "#]],
    );
}
