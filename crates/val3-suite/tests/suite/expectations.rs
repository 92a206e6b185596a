//! Scenarios and their expectations.

use expect_test::{Expect, expect};
use val3_lang::ports::SECOND;
use val3_suite::Scenario;

use crate::bench::Bench;

const DATA: &str = r#"
=== main/main.dtx
<?xml version="1.0" encoding="utf-8"?>
<Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
  <Datas>
    <Data name="doLamp" access="private" xsi:type="array" type="dio" size="1"><Value key="0" link="Io\Lamp" /></Data>
    <Data name="diGo" access="private" xsi:type="array" type="dio" size="1"><Value key="0" link="Io\Go" /></Data>
    <Data name="siHost" access="private" xsi:type="array" type="sio" size="1"><Value key="0" link="Socket\host" /></Data>
    <Data name="nState" access="private" xsi:type="array" type="num" size="1" />
    <Data name="nMean" access="private" xsi:type="array" type="num" size="1" />
    <Data name="sText" access="private" xsi:type="array" type="string" size="1" />
  </Datas>
</Database>"#;

/// A lamp that is on from 1 s to 2 s.
const LAMP: &str = "title(\"Cell\")\nput(\"ready\")\n? \"first\"\ndelay(1)\ndoLamp=true\nnState=2\nnMean=2.45\nlogMsg(\"lamp\")\n\
                    ? \"on\"\nput(\" on\")\ndelay(1)\ndoLamp=false\nnState=3\npopUpMsg(\"off\")\n? \"last\"";

/// Opens an application whose program `start` has this code.
#[track_caller]
pub(crate) fn cell(code: &str) -> Bench {
    Bench::open(&format!("program start()\nbegin\n{code}\nend\n{DATA}"), "main")
}

#[track_caller]
fn check(code: &str, scenario: &str, expected: Expect) {
    let mut bench = cell(code);
    let result = bench.scenario(scenario);
    expected.assert_eq(&bench.shown(&result));
}

#[test]
fn expectations_that_are_met_pass() {
    let scenario = r#"
        [expect]
        screen = ["Cell", "ready on"]
        io = { "Io\\Lamp" = false }
        data = { nState = 3, nMean = { is = 2.5, within = 0.05 }, "sText[0]" = "" }
        print = ["first", "on"]
        log = ["lamp"]
        popup = ["off"]

        [[expect.at]]
        t = 1.5
        screen = ["on"]
        io = { "Io\\Lamp" = true }
        data = { nState = { above = 1, below = 3 } }

        [[expect.within]]
        event = { io = { "Io\\Lamp" = true } }
        seconds = 1.01

        [[expect.within]]
        event = { io = { "Io\\Lamp" = false } }
        after = { log = "lamp" }
        seconds = 1.01

        [[expect.order]]
        events = [
          { screen = "ready" }, { print = "first" }, { log = "lamp" }, { print = "on" }, { data = { nState = 2 } },
          { data = { nState = 3 } }, { popup = "off" }, { print = "last" },
        ]
    "#;
    check(LAMP, scenario, expect!["ok, 2.004 s"]);
}

#[test]
fn expectations_that_are_not_met_show_what_there_is_instead() {
    let scenario = r#"[expect]
screen = ["ready", "2 boxes"]
io = { "Io\\Lamp" = true }
data = { nState = 4, nMean = { is = 2, within = 0.1 }, sText = "a" }
print = ["none"]
log = ["none"]
popup = ["none"]
sent = { "Socket\\host" = "hello" }
errors = [{ code = 20, task = "main~" }]

[[expect.at]]
t = 0.5
io = { "Io\\Lamp" = true }
screen = ["on"]

[[expect.within]]
event = { io = { "Io\\Lamp" = true } }
seconds = 0.5

[[expect.within]]
event = { data = { nState = 9 } }
seconds = 1

[[expect.within]]
event = { data = { nState = 2 } }
after = { popup = "none" }
seconds = 1

[[expect.order]]
events = [
  { print = "on" },
  { print = "first" },
  { error = 20 },
]

[[expect.order]] # in one cycle
events = [{ print = "on" }, { log = "lamp" }]
"#;
    check(
        LAMP,
        scenario,
        expect![[r#"
        failed, 2.004 s
        error 20 in the task `main~` was expected, and nothing has raised it
          at expect.errors (cell.toml:9)
        the screen does not show "on" at 0.504 s
        + Cell
        | ready
          at expect.at.screen (cell.toml:14)
        `Io\Lamp` is false, not true, at 0.504 s
          at expect.at.io (cell.toml:13)
        the screen does not show "2 boxes" at 2.004 s
        + Cell
        | ready on
          at expect.screen (cell.toml:2)
        `Io\Lamp` is false, not true, at 2.004 s
          at expect.io (cell.toml:3)
        `nMean` is 2.45, not 2 within 0.1, at 2.004 s
          at expect.data (cell.toml:4)
        `nState` is 3, not 4, at 2.004 s
          at expect.data (cell.toml:4)
        `sText` is "", not "a", at 2.004 s
          at expect.data (cell.toml:4)
        no printed line contains "none": the last ones
        | first
        | on
        | last
          at expect.print (cell.toml:5)
        no line of the event log contains "none": the last ones
        | USR lamp
          at expect.log (cell.toml:6)
        no message of `popUpMsg` contains "none": the last ones
        | off
          at expect.popup (cell.toml:7)
        it did not happen that "hello" is sent over `Socket\host`: nothing was
          at expect.sent (cell.toml:8)
        `Io\Lamp` is true only at 1.004 s, 0.504 s late; expected within 0.5 s of the start
          at expect.within (cell.toml:16)
        until the end at 2.004 s it did not happen that `nState` is 9; expected within 1 s of the start
        `nState` is 3, not 9
          at expect.within (cell.toml:20)
        until the end at 2.004 s it did not happen that the message "none" comes up, after which `nState` is 2 was expected
          at expect.within (cell.toml:24)
        not in this order until the end at 2.004 s:
            1.000 s  "on" is printed
            missing  "first" is printed (before its turn at 0.000 s)
            missing  error 20 stops a task
          at expect.order (cell.toml:32)
        not in this order until the end at 2.004 s:
            1.000 s  "on" is printed
            missing  the event log says "lamp" (before its turn at 1.000 s)
          at expect.order (cell.toml:37)"#]],
    );
}

/// The state is 1 for 0.2 s, for 0.5 s, and until the end. After the first two times it is 2.
#[test]
fn cycles_between_two_occurrences() {
    let code = "delay(1)\nnState=1\ndelay(0.2)\nnState=2\ndelay(1)\nnState=1\ndelay(0.5)\nnState=2\ndelay(0.1)\nnState=1\n\
                delay(3)";
    let check = |keys: &str, expected: Expect| check(code, &format!("[[expect.time]]\n{keys}\n"), expected);
    let (from, to) = ("from = { data = { nState = 1 } }", "to = { data = { nState = 2 } }");
    // The last cycle has no end.
    check(&format!("below = 0.5\n{from}\n{to}"), expect!["ok, 5.804 s"]);
    check(
        &format!("below = 0.49\n{from}\n{to}"),
        expect![[r#"
        failed, 5.804 s
        the cycle takes 0.500 s instead of at most 0.49 s, from 2.204 s to 2.704 s
          at expect.time (cell.toml:1)"#]],
    );
    check(
        &format!("below = 4\n{from}"),
        expect![[r#"
        failed, 5.804 s
        the cycle takes 4.800 s instead of at most 4 s, from 1.004 s to 5.804 s
          at expect.time (cell.toml:1)"#]],
    );
    check(
        &format!("below = 1\n{to}"),
        expect![[r#"
        failed, 5.804 s
        the cycle takes 1.204 s instead of at most 1 s, from 0.000 s to 1.204 s
          at expect.time (cell.toml:1)"#]],
    );
    check(
        &format!("below = 1.1\n{from}\nto = {{ data = {{ nState = 1 }} }}"),
        expect![[r#"
        failed, 5.804 s
        the cycle takes 1.200 s instead of at most 1.1 s, from 1.004 s to 2.204 s
          at expect.time (cell.toml:1)"#]],
    );
    check(
        &format!("below = 9\n{from}\nto = {{ data = {{ nState = 3 }} }}"),
        expect![[r#"
        failed, 5.804 s
        since 1.004 s it did not happen that `nState` is 3
        `nState` is 1, not 3
          at expect.time (cell.toml:1)"#]],
    );
    check(
        "below = 9\nfrom = { data = { nState = 3 } }",
        expect![[r#"
        failed, 5.804 s
        it did not happen that `nState` is 3
        `nState` is 1, not 3
          at expect.time (cell.toml:1)"#]],
    );
    check("below = 5.804", expect!["ok, 5.804 s"]);
    check(
        "below = 5.803",
        expect![[r#"
        failed, 5.804 s
        the cycle takes 5.804 s instead of at most 5.803 s, from 0.000 s to 5.804 s
          at expect.time (cell.toml:1)"#]],
    );
}

#[test]
fn errors_are_expected_or_fail_the_test() {
    let code = "taskCreate \"other\",10,other()\ndelay(1)\nend\nprogram other()\nbegin\n? sqrt(-1)";
    check(
        code,
        "",
        expect![[r#"
        failed, 1.004 s
        it never ends: the task `other` was stopped by error 11, and nothing can happen any more
          at main:other (main/other.pgx:5)
        error 11: invalid numeric value
          at main:other (main/other.pgx:5)"#]],
    );
    for expected in ["{ code = 11 }", "{ code = 11, task = \"other\" }", "{ code = 11, program = \"other\" }"] {
        check(code, &format!("until = 2\n[expect]\nerrors = [{expected}]\n"), expect!["ok, 1.004 s"]);
    }
    check(
        code,
        "until = 2\n[expect]\nerrors = [{ code = 11, task = \"main~\" }]\n",
        expect![[r#"
        failed, 1.004 s
        error 11: invalid numeric value
          at main:other (main/other.pgx:5)
        error 11 in the task `main~` was expected, and nothing has raised it
          at expect.errors (cell.toml:3)"#]],
    );
}

#[test]
fn a_script_is_the_other_end_of_sockets() {
    let code = "sText=siHost\nsiHost=\"got \"+sText\nsText=siHost\nsiHost=\"bye\"";
    let scenario = r#"
        at = [{ t = 0.5, receive = { "Socket\\host" = "one\r" } }, { t = 1, receive = { "Socket\\host" = "two\r" } }]
        [expect]
        data = { sText = "two" }
        sent = { "Socket\\host" = "got one\rbye\r" }
        [[expect.order]]
        events = [{ sent = { "Socket\\host" = "got one" } }, { sent = { "Socket\\host" = "bye" } }]
        [[expect.within]]
        event = { sent = { "Socket\\host" = "got" } }
        seconds = 0.52
    "#;
    check(code, scenario, expect!["ok, 1.004 s"]);
    check(
        code,
        &scenario.replace("got one\\rbye\\r", "got two"),
        expect![[r#"
        failed, 1.004 s
        it did not happen that "got two" is sent over `Socket\host`: the output ends with "got one\rbye\r"
          at expect.sent (cell.toml:5)"#]],
    );
}

#[test]
fn the_cell_reacts_to_what_the_application_does() {
    let receiving = "siHost=\"GET 1\"\nsText=siHost\n? sText\nsiHost=\"GET 2\"\nsText=siHost\n? sText";
    let scenario = r#"
        [[when]]
        sent = { "Socket\\host" = "GET" }
        then = [{ after = 0.1, receive = { "Socket\\host" = "part\r" } }]
        [expect]
        print = ["part"]
    "#;
    check(receiving, scenario, expect!["ok, 0.212 s"]);
    let waiting = "doLamp=true\nwait(diGo)\n? \"go\"";
    let scenario = r#"
        [[when]]
        io = { "Io\\Lamp" = true }
        then = [{ after = 0.5, io = { "Io\\Go" = true } }]
        [[expect.within]]
        event = { print = "go" }
        after = { io = { "Io\\Lamp" = true } }
        seconds = 0.51
    "#;
    check(waiting, scenario, expect!["ok, 0.508 s"]);
}

#[test]
fn a_cyclic_application_ends_at_its_time() {
    let code = "while true\nnState=nState+1\ndelay(1)\nendWhile";
    check(code, "until = 3.5\n[expect]\ndata = { nState = 4 }\n", expect!["ok, 3.5 s"]);
    let mut bench = cell(code);
    bench.limit = 5 * SECOND;
    let result = bench.scenario("");
    expect![[r#"
        failed, 5 s
        not ended after 5 s: it waits for time (`delay`)
          at main:start (main/start.pgx:7)"#]]
    .assert_eq(&bench.shown(&result));
    // The clock does not skip the time of an expectation.
    let waiting = "at = [{ t = 60, io = { \"Io\\\\Go\" = true } }]\n[[expect.at]]\nt = 59\ndata = { nState = 0 }\n\
                   [expect]\ndata = { nState = 1 }\n";
    check("wait(diGo)\nnState=1", &format!("until = 90\n{waiting}"), expect!["ok, 60.004 s"]);
}

#[test]
fn an_application_that_kills_itself_fails_unless_something_is_expected() {
    let code = "? \"on\"\ntaskKill(\"main~\")\n? \"off\"";
    check(
        code,
        "",
        expect![[r#"
        failed, 0.004 s
        its task has killed itself
          at start (main/start.pgx:6)"#]],
    );
    check(code, "[expect]\nprint = [\"on\"]\n", expect!["ok, 0.004 s"]);
}

#[test]
fn another_program_can_be_started() {
    let code = "? \"start\"\nend\nprogram other()\nbegin\n? \"other\"\nend\nprogram third(num x_n)\nbegin";
    check(code, "program = \"other\"\n[expect]\nprint = [\"other\"]\n", expect!["ok, 0.004 s"]);
    let mut bench = cell(code);
    assert_eq!(bench.scenario("program = \"other\"").prints, ["other"]);
    let result = bench.scenario("until = 1\nprogram = \"third\"");
    expect![[r#"
        failed, 0 s
        `third` has parameters, so it cannot be called
          at program (cell.toml:2)"#]]
    .assert_eq(&bench.shown(&result));
}

#[test]
fn names_that_the_application_does_not_have_are_faults() {
    let bench = cell(LAMP);
    let faults = [
        "data = { nStat = 1 }",
        "data = { nState = \"a\" }",
        "io = { \"Io\\\\Lmap\" = true }",
        "io = { \"Io\\\\Lamp\" = 2 }",
        "sent = { \"Socket\\\\hots\" = \"a\" }",
        "errors = [{ code = 9999 }]",
        "at = [{ t = 4, screen = [\"a\"] }]",
        "at = [{ t = 1, data = { nStat = 1 } }]",
        "at = [{ t = 0.5 }]",
        "order = [{ events = [{ move = \"strat\" }] }]",
        "order = [{ events = [{ error = 9999 }] }]",
        "within = [{ seconds = 1, event = { data = { nStat = 1 } } }]",
        "within = [{ seconds = 1, event = { print = \"a\" }, after = { sent = { \"Socket\\\\hots\" = \"a\" } } }]",
        "time = [{ below = 1, from = { move = \"strat\" } }]",
        "time = [{ below = 1, cycle = { move = \"strat:3\" } }]",
        "time = [{ below = 1, cycle = { print = \"a\" }, to = { print = \"b\" } }]",
    ];
    let faults = faults.map(|expectation| {
        let scenario = Scenario::parse("", &format!("until = 3\n[expect]\n{expectation}\n")).unwrap();
        bench.faults(&scenario).concat() + "\n"
    });
    expect![[r#"
        line 3: there is no variable `nStat`; did you mean `nState`?
        line 3: `nState` is of type num and does not take this value
        line 3: no input or output is called `Io\Lmap`; did you mean `Io\Lamp`?
        line 3: `Io\Lamp` is digital: compare it with true or false
        line 3: there is no serial line or socket `Socket\hots`; did you mean `Socket\host`?
        line 3: there is no run-time error 9999
        line 3: 4 s is after the end of the run, `until`
        line 3: there is no variable `nStat`; did you mean `nState`?
        line 3: this compares nothing, so it always holds: write what is expected, or remove it
        line 3: there is no program `strat`; did you mean `start`?
        line 3: there is no run-time error 9999
        line 3: there is no variable `nStat`; did you mean `nState`?
        line 3: there is no serial line or socket `Socket\hots`; did you mean `Socket\host`?
        line 3: there is no program `strat`; did you mean `start`?
        line 3: there is no program `strat`; did you mean `start`?
        line 3: `cycle` is both `from` and `to`: delete them or `cycle`
    "#]]
    .assert_eq(&faults.concat());
    let scenario = Scenario::parse("", "program = \"strat\"").unwrap();
    assert_eq!(bench.faults(&scenario), ["line 1: there is no program `strat`; did you mean `start`?"]);
}

#[test]
fn recorded_texts_are_the_page_and_the_printed_lines_without_trailing_blanks() {
    let code = "title(\"Cell\")\nput(\"ready \")\n? \"one  \"\n? \"two\"";
    let mut bench = cell(code);
    let result = bench.scenario("[expect]\nscreen_file = \"page.txt\"\nprint_file = \"lines.txt\"\n");
    let texts: Vec<_> = result.golden_texts.iter().map(|text| (text.file(), text.key(), text.text())).collect();
    let page = "# Screen at the end of a test\nCell\nready\n".to_owned();
    let lines = "# Printed lines of a test\none\ntwo\n".to_owned();
    let expected = [("page.txt", "expect.screen_file", page), ("lines.txt", "expect.print_file", lines)];
    assert_eq!(texts, expected);
    assert_eq!(result.golden_texts[1].judge(&texts[1].2), None);
    assert!(bench.scenario("").golden_texts.is_empty());
}
