//! Stages of a test: `setup`, the test program and `teardown`; their end by a timeout, an error or another task.

use expect_test::expect;
use val3_lang::ports::SECOND;
use val3_session::LineCondition;
use val3_suite::{Scenario, Stages, Supervision, TestCase, TestResult, TestSettings, Transition, execute};

use crate::assertions::bench;
use crate::bench::Bench;

#[test]
fn setup_and_teardown_surround_each_test() {
    let mut bench = bench(&[
        ("setup", "? \"setup\"\nnOne[0]=nOne[0]+1"),
        ("teardown", "? \"teardown\""),
        ("testFails", "? nOne[0]\ncall assert:fail(\"a\")\n? \"not reached\""),
        ("testPasses", "? nOne[0]"),
    ]);
    for (title, has_passed) in [("testPasses", true), ("testFails", false), ("testPasses", true)] {
        let result = bench.test(title, "");
        assert_eq!((result.has_passed(), result.prints.join(" ")), (has_passed, "setup 1 teardown".to_owned()));
    }
}

#[test]
fn a_failure_in_setup_omits_the_test() {
    let mut bench =
        bench(&[("setup", "call assert:fail(\"a\")"), ("teardown", "? \"teardown\""), ("testNone", "? \"test\"")]);
    let result = bench.test("testNone", "");
    assert_eq!(result.prints, ["teardown"]);
    expect![[r#"
        failed, 0.008 s
        a
          at mainTest:setup (mainTest/setup.pgx:5)"#]]
    .assert_eq(&bench.shown(&result));
}

#[test]
fn programs_that_cannot_be_called_fail_the_test() {
    for name in ["setup", "teardown"] {
        let listing = format!(
            "num nUnused\n--- mainTest\nprogram testSum()\nbegin\n? \"sum\"\nend\nprogram {name}(num x_n)\nbegin\nend"
        );
        let mut bench = Bench::open(&listing, "mainTest");
        let result = bench.test("testSum", "");
        assert_eq!(result.failures[0].message, format!("`{name}` has parameters, so it cannot be called"));
        assert_eq!(result.prints.len(), usize::from(name == "teardown"));
    }
}

#[test]
fn tests_skip_themselves_and_state_known_failures() {
    let mut bench = bench(&[
        ("testKnown", "call assert:knownFailure(\"the scale is wrong\")\ncall assert:equalNum(1,2,0)"),
        ("testPasses", "call assert:knownFailure(\"the scale was wrong\")"),
        ("testSkip", "call assert:skip(\"no scale here\")\ncall assert:fail(\"not reached\")"),
    ]);
    let mut shown = String::new();
    for title in ["testKnown", "testPasses", "testSkip"] {
        let mut result = bench.test(title, "");
        result.judge_known_failure();
        shown += &format!("{title}: {}\n", bench.shown(&result));
    }
    expect![[r#"
        testKnown: known failure: the scale is wrong, 0.008 s
        testPasses: failed, 0.008 s
        it passes, although it says that it fails (the scale was wrong): remove this statement
        testSkip: skipped: no scale here, 0.004 s
    "#]]
    .assert_eq(&shown);
    let result = bench.test("testSkip", "[expect]\nprint = [\"none\"]\n");
    assert!(result.has_passed(), "{result:?}");
    assert_eq!(bench.test("testPasses", "known_failure = \"a\"").known_failure.as_deref(), Some("the scale was wrong"));
}

#[test]
fn a_test_whose_task_is_killed_fails() {
    let mut bench = bench(&[
        ("testItself", "call ending()\ncall assert:fail(\"never reached\")"),
        ("testOther", "taskCreate \"background\",10,killer()\nwait(false)"),
        ("ending", "taskKill(\"mainTest~\")"),
        ("killer", "taskKill(\"mainTest~\")\ndelay(1)"),
    ]);
    expect![[r#"
        testItself: failed, 0.004 s
        its task has killed itself
          at ending (mainTest/ending.pgx:5)
        testOther: failed, 0.004 s
        its task was at line 6 of `testOther` when the task `background` killed it
          at mainTest:killer (mainTest/killer.pgx:6)
    "#]]
    .assert_eq(&bench.tests());
}

#[test]
fn a_test_that_does_not_end_shows_for_what_it_waits() {
    let mut bench = bench(&[("testDelay", "while true\ndelay(1)\nendWhile"), ("testWait", "wait(nOne[0]>0)")]);
    bench.limit = 5 * SECOND;
    let values = vec![("nOne[0]".to_owned(), "0".to_owned())];
    bench.conditions = vec![LineCondition { line: 6, text: "wait(nOne[0]>0)".to_owned(), values }];
    expect![[r#"
        testDelay: failed, 5 s
        not ended after 5 s: it waits for time (`delay`)
          line 6: wait(nOne[0]>0)
            nOne[0] = 0
          at mainTest:testDelay (mainTest/testDelay.pgx:6)
        testWait: failed, 5 s
        not ended after 5 s: it waits for a condition
          line 6: wait(nOne[0]>0)
            nOne[0] = 0
          at mainTest:testWait (mainTest/testWait.pgx:5)
    "#]]
    .assert_eq(&bench.tests());
}

#[test]
fn a_test_has_expectations_too() {
    let mut bench = bench(&[("testFirst", "? \"said\"\n? sqrt(-1)")]);
    let result = bench.test("testFirst", "[expect]\nprint = [\"said\"]\nerrors = [{ code = 11 }]\n");
    assert!(result.has_passed(), "{result:?}");
    let result = bench.test("testFirst", "[expect]\nprint = [\"unsaid\"]\nerrors = [{ code = 20 }]\n");
    expect![[r#"
        failed, 0.004 s
        error 11: invalid numeric value
          at mainTest:testFirst (mainTest/testFirst.pgx:6)
        error 20 was expected, and nothing has raised it
          at expect.errors (test.toml:3)
        no printed line contains "unsaid": the last ones
        | said
          at expect.print (test.toml:2)"#]]
    .assert_eq(&bench.shown(&result));
}

#[test]
fn a_failure_shows_the_user_page_and_each_event_once() {
    let mut bench = bench(&[
        ("testBlank", "call assert:fail(\"no page\")"),
        ("testLog num l_n", "for l_n=1 to 30\nlogMsg(\"again\")\ndelay(0.1)\nendFor\ncall assert:fail(\"no end\")"),
        ("testPage", "cls()\nputln(\"Part 7\")\nput(\"missing\")\ncall assert:fail(\"no part\")"),
        ("testPasses", "put(\"done\")"),
    ]);
    assert_eq!(bench.test("testPage", "").page.as_deref(), Some("+\n| Part 7\n| missing"));
    assert_eq!(["testBlank", "testPasses"].map(|title| bench.test(title, "").page), [None, None]);
    let mut result = bench.test("testLog", "");
    assert_eq!((result.events.len(), result.events[0].count), (1, 30));
    result.keep_last_events(0);
    assert!(result.events.is_empty());
}

/// Advances a test cycle by cycle, as a debugger does.
fn stepped(bench: &mut Bench, title: &str, cycles: usize) -> (TestResult, Vec<Transition>) {
    let case = bench.cases().into_iter().find(|case| case.title() == title).unwrap();
    let controller = &mut bench.controller;
    let mut stages = Stages::start(controller, case, &Scenario::default());
    let mut transitions = Vec::new();
    for _ in 0..cycles {
        let start = controller.now();
        controller.step_tasks();
        let events = controller.devices.take_events();
        stages.see_part(start, &events, controller);
        transitions.push(stages.follow(controller));
    }
    (stages.result(controller), transitions)
}

#[test]
fn a_caller_can_advance_the_controller() {
    let programs = [("setup", ""), ("testSum", "? \"sum\""), ("testWait", "wait(false)")];
    let (result, transitions) = stepped(&mut bench(&programs), "testSum", 2);
    assert_eq!((result.has_passed(), result.prints.len()), (true, 1));
    assert_eq!(transitions, [Transition::Started, Transition::Over]);
    let (result, transitions) = stepped(&mut bench(&programs), "testWait", 3);
    assert_eq!(result.failures[0].message, "it has not ended");
    assert_eq!(transitions, [Transition::Started, Transition::None, Transition::None]);
}

#[test]
fn a_caller_can_end_a_test() {
    let mut bench = bench(&[("testWait", "wait(false)")]);
    for case in [bench.cases().remove(0), TestCase::scenario("mainTest", "cell", "cell.toml")] {
        let supervision = Supervision {
            settings: TestSettings { limit: SECOND },
            may_go_on: &|| false,
            conditions: &mut |_, _| Vec::new(),
        };
        let scenario = Scenario::parse("cell.toml", "program = \"testWait\"").unwrap();
        assert_eq!(execute(&mut bench.controller, &case, &scenario, supervision), None, "{case:?}");
    }
}
