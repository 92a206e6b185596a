//! Evaluation of random input.

use proptest::prelude::{ProptestConfig, Strategy};
use proptest::test_runner::TestRunner;
use proptest::{prop_assert, prop_assert_eq};
use val3_vm::FragmentContext;

use crate::stopped::{Stopped, VARIABLES};

/// Tokens of valid and invalid expressions and statements.
fn token() -> impl Strategy<Value = String> {
    let tokens = [
        "nCount",
        "x_nTotal",
        "l_nMany",
        "x_pAt",
        "pHome",
        "tSlots",
        "l_tSlot",
        "sNames",
        "mFast",
        "main",
        "[",
        "]",
        "(",
        ")",
        "{",
        "}",
        ",",
        ".",
        ":",
        "+",
        "-",
        "*",
        "/",
        "==",
        "=",
        "<",
        "and",
        "not",
        "!",
        "1",
        "0",
        "1e300",
        "\"a\"",
        "\"",
        "trsf",
        "x",
        "nCount",
        "size",
        "len",
        "link",
        "movej",
        "taskKill",
        "appro",
        "isDefined",
        "call double",
        "if",
        "endIf",
        "while true",
        "for",
        "return",
        "?",
        "\n",
        "end",
        "begin",
        "//",
        "]]>",
        "&",
        "é",
        "clock()",
        "setMutex",
        "resize",
        "delete",
        "getData",
    ];
    proptest::collection::vec(proptest::sample::select(tokens.to_vec()), 0..8).prop_map(|tokens| tokens.concat())
}

#[test]
fn watched_texts_change_nothing_whatever_they_are() {
    let stopped = Stopped::at(VARIABLES);
    let before = state(&stopped);
    let stopped = std::cell::RefCell::new(stopped);
    let mut runner =
        TestRunner::new(ProptestConfig { cases: 300, failure_persistence: None, ..ProptestConfig::default() });
    let result = runner.run(&token(), |text| {
        let stopped = &mut *stopped.borrow_mut();
        stopped.watch(&text);
        let context = FragmentContext::Frame(stopped.task, 0);
        let completions = stopped.evaluator.completions(&stopped.debugger.controller, context, &text, text.len());
        prop_assert!(completions.is_ok());
        prop_assert_eq!(&state(stopped), &before, "{}", text);
        Ok(())
    });
    result.unwrap();
}

fn state(stopped: &Stopped) -> String {
    let vm = &stopped.debugger.controller.vm;
    let memory = &vm.space.memory;
    format!("{:?}{:?}{:?}{:?}", vm.tasks(), memory.stack, memory.stores.room, memory.stores)
}

#[test]
fn executed_texts_leave_a_controller_that_runs() {
    let mut runner =
        TestRunner::new(ProptestConfig { cases: 100, failure_persistence: None, ..ProptestConfig::default() });
    let result = runner.run(&proptest::collection::vec(token(), 1..4), |texts| {
        let mut stopped = Stopped::at(VARIABLES);
        for text in texts {
            stopped.execute(&text);
            stopped.assign(&text, "1");
        }
        for _ in 0..10 {
            stopped.debugger.advance();
        }
        Ok(())
    });
    result.unwrap();
}
