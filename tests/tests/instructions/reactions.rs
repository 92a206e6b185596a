//! Reactions of scripts.

use expect_test::{Expect, expect};
use val3_machine::event::Event;
use val3_machine::script::{Condition, Script};
use val3_tests::running::Running;

/// Runs the application of a listing with a script.
fn scripted(script: &str, listing: &str) -> Running {
    let mut running = Running::start(listing);
    running.controller.follow(Script::parse(script).unwrap());
    running
}

#[track_caller]
fn check(script: &str, listing: &str, expected: Expect) {
    let running = scripted(script, listing).to_the_end();
    expected.assert_eq(&format!("{}{}", running.printed(), running.record()));
}

/// Data of a program with a valve, a cup and a scale.
const CELL: &str = r#"
=== main/main.dtx
<?xml version="1.0" encoding="utf-8"?>
<Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
  <Datas>
    <Data name="doValve" access="private" xsi:type="array" type="dio" size="1"><Value key="0" link="Board\%Q0" /></Data>
    <Data name="diCup" access="private" xsi:type="array" type="dio" size="1"><Value key="0" link="Board\%I0" /></Data>
    <Data name="aoScale" access="private" xsi:type="array" type="aio" size="1"><Value key="0" link="Board\scale" /></Data>
  </Datas>
</Database>
"#;

#[test]
fn inputs_follow_an_output_after_a_delay() {
    let program = "doValve=true\nwait(diCup)\n? clock()\ndoValve=false\nwait(!diCup)\n? clock()\ndoValve=true\nwait(diCup)\n? clock()\n";
    check(
        r#"
            [[when]]
            io = { "Board\\%Q0" = true }
            then = [{ after = 0.2, io = { "Board\\%I0" = true } }]

            [[when]]
            io = { "Board\\%Q0" = false }
            then = [{ io = { "Board\\%I0" = false } }]
        "#,
        &format!("{program}{CELL}"),
        expect![[r#"
            0.204
            0.208
            0.412
            {"t":0.0,"kind":"act","keys":{"io":{"Board\\%I0":false}}}
            {"t":0.004,"kind":"io","link":"Board\\%Q0","value":1.0}
            {"t":0.204,"kind":"act","keys":{"io":{"Board\\%I0":true}}}
            {"t":0.204,"kind":"io","link":"Board\\%I0","value":1.0}
            {"t":0.208,"kind":"io","link":"Board\\%Q0","value":0.0}
            {"t":0.208,"kind":"act","keys":{"io":{"Board\\%I0":false}}}
            {"t":0.208,"kind":"io","link":"Board\\%I0","value":0.0}
            {"t":0.212,"kind":"io","link":"Board\\%Q0","value":1.0}
            {"t":0.412,"kind":"act","keys":{"io":{"Board\\%I0":true}}}
            {"t":0.412,"kind":"io","link":"Board\\%I0","value":1.0}
        "#]],
    );
}

#[test]
fn every_condition_is_compared() {
    check(
        r#"
            [[when]]
            io = { "Board\\%Q0" = true, "Board\\scale" = { above = 3, below = 4.5 } }
            data = { sPart = "bolt", "nCounts[1]" = 7, bReady = true, nLimit = { below = 0 } }
            then = [{ set = { bDone = true } }]
        "#,
        &format!(
            "string sPart\nnum nCounts[2]\nnum nLimit\nbool bReady\nbool bDone\n  doValve=true\n  sPart=\"bolt\"\n  \
             nCounts[1]=7\n  bReady=true\n  nLimit=-1\n  aioSet(aoScale,4.5)\n  delay(1)\n  ? bDone\n  \
             aioSet(aoScale,3)\n  delay(1)\n  ? bDone\n  aioSet(aoScale,3.5)\n  delay(0.004)\n  ? bDone\n{}",
            CELL.replace(
                "  </Datas>",
                r#"    <Data name="sPart" access="private" xsi:type="array" type="string" size="1" />
    <Data name="nCounts" access="private" xsi:type="array" type="num" size="2" />
    <Data name="nLimit" access="private" xsi:type="array" type="num" size="1" />
    <Data name="bReady" access="private" xsi:type="array" type="bool" size="1" />
    <Data name="bDone" access="private" xsi:type="array" type="bool" size="1" />
  </Datas>"#
            )
        ),
        expect![[r#"
            false
            false
            true
            {"t":0.004,"kind":"io","link":"Board\\%Q0","value":1.0}
            {"t":0.004,"kind":"io","link":"Board\\scale","value":4.5}
            {"t":1.004,"kind":"io","link":"Board\\scale","value":3.0}
            {"t":2.004,"kind":"io","link":"Board\\scale","value":3.5}
            {"t":2.004,"kind":"act","keys":{"set":{"bDone":true}}}
        "#]],
    );
}

#[test]
fn a_reaction_happens_when_its_condition_becomes_true() {
    check(
        "[[when]]\ndata = { bOn = true }\nthen = [{ keys = \"a\" }]\n\
         [[when]]\ndata = { bOn = true }\ntimes = 2\nthen = [{ keys = \"b\" }]",
        "bool bOn\nnum n\n  for n=1 to 3\n    bOn=true\n    delay(0.5)\n    bOn=false\n    delay(0.5)\n  endFor\n  \
         for n=1 to 5\n    ? get()\n  endFor\n  ? clock()\n",
        expect![[r#"
            97
            98
            97
            98
            97
            3.02
            {"t":0.004,"kind":"act","keys":{"keys":"a"}}
            {"t":0.004,"kind":"act","keys":{"keys":"b"}}
            {"t":1.004,"kind":"act","keys":{"keys":"a"}}
            {"t":1.004,"kind":"act","keys":{"keys":"b"}}
            {"t":2.004,"kind":"act","keys":{"keys":"a"}}
        "#]],
    );
}

#[test]
fn a_condition_that_holds_at_the_start_is_met_before_the_first_cycle() {
    check(
        "[[when]]\ndata = { nState = 0 }\nthen = [{ set = { bSeen = true } }, { after = 2, set = { nState = 5 } }]",
        "num nState\nbool bSeen\n  ? bSeen\n  nState=1\n  wait(nState==5)\n  ? clock()\n",
        expect![[r#"
            true
            2
            {"t":0.0,"kind":"act","keys":{"set":{"bSeen":true}}}
            {"t":2.0,"kind":"act","keys":{"set":{"nState":5.0}}}
        "#]],
    );
}

#[test]
fn reactions_cause_each_other_cycle_by_cycle() {
    check(
        "[[when]]\ndata = { n = 1 }\nthen = [{ set = { n = 2 } }]\n\
         [[when]]\ndata = { n = 2 }\nthen = [{ set = { n = 3 } }]\n\
         [[when]]\ndata = { n = 3 }\nthen = [{ set = { n = 1, nRounds = 1 } }]",
        "num n\nnum nRounds\n  n=1\n  wait(nRounds==1)\n  ? clock()\n  ? n\n",
        expect![[r#"
            0.012
            1
            {"t":0.004,"kind":"act","keys":{"set":{"n":2.0}}}
            {"t":0.008,"kind":"act","keys":{"set":{"n":3.0}}}
            {"t":0.012,"kind":"act","keys":{"set":{"n":1.0,"nRounds":1.0}}}
        "#]],
    );
}

#[test]
fn reactions_of_the_cell_reach_an_application_that_cannot_continue() {
    check(
        "[[at]]\nt = 1\nset = { n = 1 }\n[[when]]\ndata = { n = 1 }\nthen = [{ after = 2, stop = true }]",
        "num n\nprogram start()\nbegin\n  ? sqrt(-1)\nend\nprogram stop()\nbegin\n  ? clock()\nend\n",
        expect![[r#"
            error 11
            3.004
            {"t":2e-6,"task":"main~","kind":"error","code":11,"message":"invalid numeric value","help":"The instruction is not defined for this number: the root or logarithm of a negative number, asin or acos beyond 1, or a result too large. Limit the argument before.","program":"start","line":5,"file":"/cell/usr/usrapp/main/start.pgx"}
            {"t":1.0,"kind":"act","keys":{"set":{"n":1.0}}}
            {"t":3.004,"kind":"act","keys":{"stop":true}}
        "#]],
    );
}

#[test]
fn impossible_entries_of_reactions_are_logged() {
    check(
        "# comment\n\n[[when]]\ndata = { n = 1 }\nthen = [{ set = { m = 1 } }]",
        "num n\n  n=1\n  delay(1)\n",
        expect![[r#"
            {"t":0.004,"kind":"act","keys":{"set":{"m":1.0}}}
            {"t":0.004,"kind":"log","level":"error","text":"script, [[when]] in line 3: there is no variable `m`"}
        "#]],
    );
}

fn record(events: &[Event]) -> String {
    events.iter().map(|event| serde_json::to_string(event).unwrap() + "\n").collect()
}

/// Runs step by step without skipped time, and returns the record of the rest.
fn rest(running: &mut Running) -> String {
    while running.controller.now() < 400_000_000 && !running.controller.step().is_final() {}
    record(&running.controller.devices.take_events())
}

#[test]
fn a_restored_controller_repeats_its_reactions() {
    let script = "[[when]]\ndata = { bOn = true }\ntimes = 3\nthen = [{ after = 0.03, set = { bOn = false } }, { key = 97 }]\n\
                  [[when]]\ndata = { bOn = false }\nthen = [{ after = 0.05, set = { bOn = true } }]";
    let listing = "bool bOn\n  while true\n    ? get()\n    ? clock()\n  endWhile\n";
    for cycle in 0..80 {
        let mut running = scripted(script, listing);
        for _ in 0..cycle {
            running.controller.step();
        }
        running.controller.devices.take_events();
        let snapshot = running.controller.snapshot();
        let first = rest(&mut running);
        for _ in 0..2 {
            running.controller.restore(&snapshot);
            assert_eq!(rest(&mut running), first, "restored in cycle {cycle}");
        }
        running.controller.begin_again(&snapshot);
        assert_eq!(rest(&mut running), first, "begun again in cycle {cycle}");
        assert!(cycle > 0 || first.matches("\"text\":\"97\"").count() == 3, "{first}");
    }
}

#[test]
fn conditions_and_entries_are_checked_before_the_run() {
    let running = scripted("", &format!("doValve=true\n{CELL}"));
    let script = Script::parse(
        r#"
            [[at]]
            t = 1
            set = { nNothing = 1 }

            [[when]]
            io = { "Board\\%Q0" = 1, "Board\\%Q1" = true, "Board\\scale" = true, "Board\\%I0" = { above = 0 } }
            data = { doValve = true, nNothing = { below = 3 } }
            then = [{ set = { nNone = 1 } }, { io = { "Board\\%I1" = true } }]

            [[when]]
            io = { "Board\\%Q0" = true, "Board\\scale" = { above = 3 } }
            then = [{ io = { "Board\\%I0" = true } }]
        "#,
    );
    let faults = running.controller.script_faults(&script.unwrap(), &|_| false);
    let faults: Vec<String> = faults.iter().map(|fault| format!("{fault}\n")).collect();
    expect![[r#"
        t = 1: there is no variable `nNothing`
        [[when]] in line 6: `Board\%I0` is digital: compare it with true or false
        [[when]] in line 6: `Board\%Q0` is digital: compare it with true or false
        [[when]] in line 6: no input or output is called `Board\%Q1`; did you mean `Board\%Q0`?
        [[when]] in line 6: `Board\scale` is analog: compare it with a number or a range
        [[when]] in line 6: `doValve` is of type dio and does not take this value
        [[when]] in line 6: there is no variable `nNothing`
        [[when]] in line 6: there is no variable `nNone`
        [[when]] in line 6: no input or output is called `Board\%I1`; did you mean `Board\%I0`?
    "#]]
    .assert_eq(&faults.concat());
}

#[test]
fn mismatches_are_described() {
    let running = scripted("", &format!("doValve=true\naioSet(aoScale,5)\n{CELL}")).to_the_end();
    let condition = serde_json::json!({
        "io": {
            "Board\\%Q0": false,
            "Board\\%I0": false,
            "Board\\%I7": true,
            "Board\\scale": { "above": 1, "below": 4.5 },
        },
        "data": { "nNothing": { "above": 1 } },
    });
    let condition: Condition = serde_json::from_value(condition).unwrap();
    let mismatches = running.controller.mismatches(&condition);
    assert!(!running.controller.meets(&condition));
    let described: Vec<String> = mismatches.iter().map(|mismatch| format!("{mismatch}\n")).collect();
    expect![[r#"
        `Board\%I7` does not exist, so it is not true
        `Board\%Q0` is true, not false
        `Board\scale` is 5, not above 1 and below 4.5
        `nNothing` does not exist, so it is not above 1
    "#]]
    .assert_eq(&described.concat());
    let met: Condition = serde_json::from_value(serde_json::json!({ "io": { "Board\\scale": 5 } })).unwrap();
    assert!(running.controller.meets(&met));
}

#[test]
fn skipped_time_changes_no_reaction() {
    let script = "[[at]]\nt = 7\nset = { n = 3 }\n\
                  [[when]]\ndata = { n = 1 }\nthen = [{ after = 2.5, set = { n = 2 } }]\n\
                  [[when]]\ndata = { n = { above = 1.5 } }\nthen = [{ set = { bDone = true } }, { after = 3, keys = \"x\" }]\n";
    let listing = "num n\nbool bDone\n  delay(1)\n  n=1\n  wait(bDone)\n  ? clock()\n  delay(2)\n  n=0\n  ? get()\n  ? get()\n  ? clock()\n";
    let skipping = scripted(script, listing).to_the_end();
    let mut stepping = scripted(script, listing);
    while !stepping.controller.step().is_final() {}
    let events = stepping.controller.devices.take_events();
    assert_eq!(record(&events), record(&skipping.events));
    expect![[r#"
        3.508
        120
        120
        10.004
    "#]]
    .assert_eq(&skipping.printed());
}
