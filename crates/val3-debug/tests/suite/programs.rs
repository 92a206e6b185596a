//! Breakpoints on programs.

use expect_test::expect;
use val3_debug::{BreakpointId, Debugger, PastLimits, PlacedProgram, ProgramBreakpoint, StepKind, Stop};
use val3_tests::running::Running;

use crate::debugger::{CALLS, debugger, first_row, run, set, shown, stops, task_of};

/// Sets breakpoints on programs, with hit conditions, and returns their resolved lines.
fn on(debugger: &mut Debugger, programs: &[(&str, Option<&str>)]) -> Vec<PlacedProgram> {
    let breakpoints = (10..).zip(programs).map(|(id, (name, hits))| ProgramBreakpoint {
        hits: hits.map(|hits| hits.parse().unwrap()),
        ..ProgramBreakpoint::new(BreakpointId(id), name.parse().unwrap())
    });
    debugger.set_program_breakpoints(breakpoints.collect())
}

#[test]
fn a_task_stops_in_a_called_program() {
    let mut debugger = debugger(CALLS);
    let placed = on(&mut debugger, &[("add", None), ("start", None), ("Add", None)]);
    let row = |placed: &PlacedProgram| placed.places.first().map(|(_, row)| *row);
    let rows: Vec<_> = placed.iter().map(row).collect();
    assert_eq!(rows, [Some(first_row(&debugger, "add")), Some(first_row(&debugger, "start")), None]);
    stops(
        &mut debugger,
        |_, _| (),
        expect![[r#"
            [11] main~: start:1
            [10] main~: add:1 < start:2
            [10] main~: add:1 < start:2
            [10] main~: add:1 < start:2
            end
        "#]],
    );
}

#[test]
fn an_application_or_library_narrows_the_name() {
    for (name, expected) in
        [("add", 3), ("main:add", 3), (" main : add() ", 3), ("other:add", 0), ("Main:add", 0), ("", 0)]
    {
        let mut debugger = debugger(CALLS);
        on(&mut debugger, &[(name, None)]);
        assert_eq!(std::iter::from_fn(|| run(&mut debugger)).count(), expected, "{name}");
    }
}

/// Loops whose first line is the first line of the program.
#[test]
fn a_loop_that_returns_to_the_first_line_is_no_entry() {
    for code in [
        "while x_n<3\n    x_n=x_n+1\n  endWhile",
        "do\n    x_n=x_n+1\n  until x_n>3",
        "while count(x_n)==false\n  endWhile",
        "for x_n=1 to 5\n    ? x_n\n  endFor",
        "wait(count(x_n))",
        "wait(clock()>0.1)",
    ] {
        let code = code.replace("count(x_n)", "clock()>0.05");
        let listing = format!(
            "program start()\nbegin\n  call work(0)\n  taskCreate \"other\",10,work(0)\n  wait(taskStatus(\"other\")==-1)\n\
             end\nprogram work(num x_n)\nbegin\n  {code}\nend\n"
        );
        let mut debugger = debugger(&listing);
        on(&mut debugger, &[("work", None)]);
        let mut names = Vec::new();
        while let Some(stop) = run(&mut debugger).filter(|_| names.len() < 5) {
            names.push(shown(&debugger, Some(stop)));
        }
        assert_eq!(names, ["[10] main~: work:1 < start:1", "[10] other: work:1"], "{code}");
    }
}

#[test]
fn hits_are_counted_with_those_of_the_line() {
    let mut debugger = debugger(CALLS);
    set(&mut debugger, "add", &[(1, Some("%2"))]);
    on(&mut debugger, &[("add", Some(">=2"))]);
    stops(
        &mut debugger,
        |_, _| (),
        expect![[r#"
            [0, 10] main~: add:1 < start:2
            [10] main~: add:1 < start:2
            end
        "#]],
    );
}

#[test]
fn a_step_into_a_program_hits_its_breakpoint_once() {
    let mut debugger = debugger(CALLS);
    set(&mut debugger, "start", &[(2, Some("1"))]);
    on(&mut debugger, &[("add", None)]);
    stops(
        &mut debugger,
        |debugger, stop| debugger.step(task_of(stop).unwrap(), StepKind::In),
        expect![[r#"
            [0] main~: start:2
            [10] main~: add:1 < start:2
            step main~: add:2 < start:2
            step main~: start:3
            step main~: start:1
            step main~: start:2
            [10] main~: add:1 < start:2
            step main~: add:2 < start:2
            step main~: start:3
            step main~: start:1
            step main~: start:2
            [10] main~: add:1 < start:2
            step main~: add:2 < start:2
            step main~: start:3
            step main~: start:1
            step main~: start:5
            end
        "#]],
    );
}

#[test]
fn removed_breakpoints_stop_nothing() {
    let mut debugger = debugger(CALLS);
    on(&mut debugger, &[("add", None)]);
    assert!(run(&mut debugger).is_some());
    on(&mut debugger, &[]);
    assert_eq!(run(&mut debugger), None);
}

#[test]
fn a_run_back_stops_where_a_program_was_entered() {
    let mut debugger = debugger(CALLS);
    debugger.record(PastLimits::snapshots(100));
    on(&mut debugger, &[("add", None)]);
    while run(&mut debugger).is_some() {}
    let mut seen = Vec::new();
    for _ in 0..4 {
        let stop = debugger.run_back();
        seen.push(shown(&debugger, Some(stop)));
    }
    expect![[r#"
        [10] main~: add:1 < start:2
        [10] main~: add:1 < start:2
        [10] main~: add:1 < start:2
        beginning"#]]
    .assert_eq(&seen.join("\n"));
}

/// Breakpoints on programs and pauses do not change the events of a run.
#[test]
fn a_run_with_stops_has_the_same_events() {
    let expected = format!("{:?}", Running::start(CALLS).to_the_end().events);
    let mut debugger = debugger(CALLS);
    on(&mut debugger, &[("add", None), ("start", None)]);
    let mut events = Vec::new();
    while let Some(stop) = run(&mut debugger) {
        if matches!(stop, Stop::Breakpoints { .. }) {
            debugger.pause(None);
        }
        events.extend(debugger.controller.devices.take_events());
    }
    events.extend(debugger.controller.devices.take_events());
    assert_eq!(format!("{events:?}"), expected);
}
