//! The state at the end of a test, which is compared between two runs.

use expect_test::expect;
use val3_suite::{FinalState, TestResult};

use crate::assertions::bench;
use crate::bench::Bench;
use crate::expectations::cell;

const CELL: &str = "\
num nCount
string sNames[2]
program start()
begin
  nCount=2
  sNames[1]=\"b\"
  title(\"Cell\")
  put(\"page\")
  ? \"line\"
  logMsg(\"log\")
  popUpMsg(\"message\")
end
";

/// Returns the state after the program with another text in place of one.
fn state(from: &str, to: &str) -> FinalState {
    assert!(CELL.contains(from), "{from}");
    let mut bench = Bench::open(&CELL.replace(from, to), "main");
    let result: TestResult = bench.scenario("");
    FinalState::of(&bench.controller, &result)
}

#[test]
fn each_kind_of_output_is_compared() {
    let first = state("nCount=2", "nCount=2");
    assert_eq!(state("nCount=2", "nCount=2"), first);
    let differences = [
        ("nCount=2", "nCount=3"),
        ("sNames[1]", "sNames[0]"),
        ("Cell", "cell"),
        ("page", "Page"),
        ("line", "Line"),
        ("\"log", "\"Log"),
        ("message", "Message"),
        ("popUpMsg(\"message\")", "popUpMsg(\"message\")\n delay(1)"),
    ];
    let differences = differences.map(|(from, to)| {
        let found = state(from, to).first_difference(&first);
        found.map(|found| found.to_string()).unwrap_or_default() + "\n"
    });
    expect![[r#"
        main:nCount is 3 instead of 2
        main:sNames[0] is "b" instead of ""
        the title of the screen is "cell" instead of "Cell"
        row 0 of the screen is "Page" instead of "page"
        printed line 1 is "Line" instead of "line"
        log line 1 is "USR Log" instead of "USR log"
        message 1 is "Message" instead of "message"
        the time of the test is 1.004 s instead of 0.004 s
    "#]]
    .assert_eq(&differences.concat());
}

#[test]
fn signals_are_compared() {
    let state = |code: &str| {
        let mut bench = cell(code);
        let result = bench.scenario("");
        FinalState::of(&bench.controller, &result)
    };
    let found = state("doLamp=true").first_difference(&state("doLamp=false")).unwrap();
    assert_eq!(found.to_string(), r"Io\Lamp is 1 instead of 0");
}

#[test]
fn data_of_assertions_are_no_state_of_the_application() {
    let state = |text: &str| {
        let mut bench = bench(&[("testAbout", &format!("call assert:about(\"{text}\")"))]);
        let result = bench.test("testAbout", "");
        FinalState::of(&bench.controller, &result)
    };
    assert_eq!(state("a"), state("b"));
}

#[test]
fn an_element_can_be_left_out() {
    let (one, other) = (state("nCount=2", "nCount=3"), state("nCount=2", "nCount=2"));
    assert_eq!(one.without("main:nCount"), other.without("main:nCount"));
    assert_ne!(one.without("main:nCounts"), other.without("main:nCounts"));
}
