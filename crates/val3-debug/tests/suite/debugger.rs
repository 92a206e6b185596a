//! Breakpoints, steps and errors of small applications.

use expect_test::{Expect, expect};
use val3_debug::{
    AdvanceResult, Breakpoint, BreakpointId, Debugger, HitCondition, PastLimits, StepKind, Stop, StopErrors, frames,
};
use val3_lang::ports::TaskNumber;
use val3_machine::controller::RunStatus;
use val3_session::Pace;
use val3_tests::running::Running;

/// Creates a debugger at the beginning of the application.
pub(crate) fn debugger(listing: &str) -> Debugger {
    Debugger::new(Running::start(listing).controller)
}

/// Returns the file of the application's program.
pub(crate) fn file(debugger: &Debugger, program: &str) -> String {
    let (_, application) = debugger.controller.vm.space.loaded().next().unwrap();
    let image = &application.image;
    let number = image.program(program).unwrap();
    image.files[image.programs[usize::from(number)].file as usize].clone()
}

/// Sets breakpoints at lines of a program's code, counted from the line after `begin`, and returns their resolved
/// lines.
pub(crate) fn set(debugger: &mut Debugger, program: &str, lines: &[(u32, Option<&str>)]) -> Vec<Option<u32>> {
    let file = file(debugger, program);
    let first = first_row(debugger, program);
    let breakpoints = (0..).zip(lines).map(|(id, (line, hits))| Breakpoint {
        hits: hits.map(|hits| hits.parse().unwrap()),
        ..Breakpoint::new(BreakpointId(id), first + line - 1)
    });
    let placed = debugger.set_breakpoints(&file, breakpoints.collect());
    placed.iter().map(|placed| placed.row.map(|row| row + 1 - first)).collect()
}

pub(crate) fn first_row(debugger: &Debugger, program: &str) -> u32 {
    let (_, application) = debugger.controller.vm.space.loaded().next().unwrap();
    let number = application.image.program(program).unwrap();
    application.image.programs[usize::from(number)].lines[0].row
}

/// Runs to the next stop or to the end.
pub(crate) fn run(debugger: &mut Debugger) -> Option<Stop> {
    for _ in 0..1_000_000 {
        match debugger.advance() {
            AdvanceResult::Stopped(stop) => return Some(stop),
            AdvanceResult::Ran(RunStatus::Waiting(wake)) => {
                Pace::default().wait(&mut debugger.controller, wake)?;
            }
            AdvanceResult::Ran(status) if status.is_final() => return None,
            AdvanceResult::Ran(_) => {}
        }
    }
    panic!("it does not stop");
}

pub(crate) fn task_of(stop: &Stop) -> Option<TaskNumber> {
    match stop {
        Stop::Breakpoints { task, .. }
        | Stop::Step { task }
        | Stop::Error { task, .. }
        | Stop::Exit { task }
        | Stop::CallEnded { task, .. } => Some(*task),
        Stop::Pause { task } => *task,
        Stop::Data(stop) => stop.task,
        Stop::Beginning | Stop::Motion(_) | Stop::PathFault(_) | Stop::Contacts(_) => None,
    }
}

/// Formats a stop: `why task: program:line < caller:line`, lines counted as in [`set`].
pub(crate) fn shown(debugger: &Debugger, stop: Option<Stop>) -> String {
    let (why, task) = match stop {
        None => return "end".to_owned(),
        Some(Stop::Breakpoints { task, ids, .. }) => {
            (format!("{:?}", ids.iter().map(|id| id.0).collect::<Vec<_>>()), task)
        }
        Some(Stop::Step { task }) => ("step".to_owned(), task),
        Some(Stop::CallEnded { task, .. }) => ("call".to_owned(), task),
        Some(Stop::Exit { task }) => ("exit".to_owned(), task),
        Some(Stop::Pause { task: Some(task) }) => ("pause".to_owned(), task),
        Some(Stop::Pause { task: None }) => return "pause".to_owned(),
        Some(Stop::Data(_)) => return "data".to_owned(),
        Some(Stop::Beginning) => return "beginning".to_owned(),
        Some(Stop::Motion(_)) => return "motion".to_owned(),
        Some(Stop::Contacts(contacts)) => return format!("contacts: {contacts:?}"),
        Some(Stop::PathFault(fault)) => return format!("path fault: {}", fault.text),
        Some(Stop::Error { task, fault }) => (format!("error {}", fault.0), task),
    };
    let vm = &debugger.controller.vm;
    let name = vm.tasks().iter().find(|known| known.id == task).map_or("?", |task| &task.name);
    let frames = frames(vm, task).into_iter();
    let frames =
        frames.map(|frame| format!("{}:{}", frame.program, frame.row + 1 - first_row(debugger, &frame.program)));
    format!("{why} {name}: {}", frames.collect::<Vec<_>>().join(" < "))
}

/// Checks the stops of a run that calls `then` after each stop.
pub(crate) fn stops(debugger: &mut Debugger, mut then: impl FnMut(&mut Debugger, &Stop), expected: Expect) {
    let mut all = String::new();
    loop {
        let stop = run(debugger);
        all += &(shown(debugger, stop.clone()) + "\n");
        match stop {
            Some(stop) if all.lines().count() < 40 => then(debugger, &stop),
            _ => break,
        }
    }
    expected.assert_eq(&all);
}

pub(crate) const CALLS: &str = r#"
program start()
num l_nRound
begin
  for l_nRound=1 to 3
    call add(l_nRound)
    ? l_nRound
  endFor
  ? "over"
end

program add(num x_nValue)
begin
  ? x_nValue
  ? x_nValue+1
end
"#;

#[test]
fn a_task_stops_at_each_breakpoint() {
    let mut debugger = debugger(CALLS);
    assert_eq!(set(&mut debugger, "add", &[(2, None)]), [Some(2)]);
    assert_eq!(set(&mut debugger, "start", &[(5, None)]), [Some(5)]);
    stops(
        &mut debugger,
        |_, _| (),
        expect![[r#"
        [0] main~: add:2 < start:2
        [0] main~: add:2 < start:2
        [0] main~: add:2 < start:2
        [0] main~: start:5
        end
    "#]],
    );
}

#[test]
fn hits_are_counted() {
    for (hits, expected) in
        [("2", 1), (" == 2", 1), (">=2", 2), (">2", 1), ("<3", 2), ("<=3", 3), ("% 2", 1), ("3", 1), ("4", 0)]
    {
        let mut debugger = debugger(CALLS);
        set(&mut debugger, "add", &[(1, Some(hits))]);
        let stops = std::iter::from_fn(|| run(&mut debugger)).count();
        assert_eq!(stops, expected, "{hits}");
    }
    for wrong in ["", "x", "0", "<1", "%0", "!=5", "5x", "%-1", ">="] {
        assert!(wrong.parse::<HitCondition>().is_err(), "{wrong}");
    }
}

#[test]
fn a_breakpoint_moves_to_the_next_line_with_an_instruction() {
    let mut debugger = debugger("program start()\nbegin\n  ? 1\n\n  // a comment\n  ? 2\nend\n");
    assert_eq!(
        set(&mut debugger, "start", &[(2, None), (3, None), (4, None), (9, None)]),
        [Some(4), Some(4), Some(4), None]
    );
    stops(
        &mut debugger,
        |_, _| (),
        expect![[r#"
        [0, 1, 2] main~: start:4
        end
    "#]],
    );
}

fn steps(kind: StepKind, expected: Expect) {
    let mut debugger = debugger(CALLS);
    set(&mut debugger, "start", &[(2, Some("1"))]);
    stops(&mut debugger, |debugger, stop| debugger.step(task_of(stop).unwrap(), kind), expected);
}

#[test]
fn a_step_over_stays_in_the_program() {
    steps(
        StepKind::Over,
        expect![[r#"
        [0] main~: start:2
        step main~: start:3
        step main~: start:1
        step main~: start:2
        step main~: start:3
        step main~: start:1
        step main~: start:2
        step main~: start:3
        step main~: start:1
        step main~: start:5
        end
    "#]],
    );
}

#[test]
fn a_step_in_enters_called_programs() {
    steps(
        StepKind::In,
        expect![[r#"
        [0] main~: start:2
        step main~: add:1 < start:2
        step main~: add:2 < start:2
        step main~: start:3
        step main~: start:1
        step main~: start:2
        step main~: add:1 < start:2
        step main~: add:2 < start:2
        step main~: start:3
        step main~: start:1
        step main~: start:2
        step main~: add:1 < start:2
        step main~: add:2 < start:2
        step main~: start:3
        step main~: start:1
        step main~: start:5
        end
    "#]],
    );
}

#[test]
fn a_step_out_ends_in_the_caller() {
    let mut debugger = debugger(CALLS);
    set(&mut debugger, "add", &[(1, None)]);
    stops(
        &mut debugger,
        |debugger, stop| {
            if let Stop::Breakpoints { task, .. } = stop {
                debugger.step(*task, StepKind::Out);
            }
        },
        expect![[r#"
        [0] main~: add:1 < start:2
        step main~: start:3
        [0] main~: add:1 < start:2
        step main~: start:3
        [0] main~: add:1 < start:2
        step main~: start:3
        end
    "#]],
    );
}

/// The breakpoint on the line where a step ends counts one hit.
#[test]
fn a_step_that_ends_at_a_breakpoint_hits_it_once() {
    let mut debugger = debugger("program start()\nbegin\n  ? 1\n  ? 2\n  ? 3\nend\n");
    set(&mut debugger, "start", &[(1, None), (2, None)]);
    let mut is_first = true;
    stops(
        &mut debugger,
        |debugger, stop| {
            if let (Stop::Breakpoints { task, .. }, true) = (stop, std::mem::take(&mut is_first)) {
                debugger.step(*task, StepKind::Over);
            }
        },
        expect![[r#"
        [0] main~: start:1
        [1] main~: start:2
        end
    "#]],
    );
}

#[test]
fn a_step_waits_with_its_task() {
    let mut debugger = debugger(
        "program start()\nbegin\n  taskCreate \"other\",10,other()\n  delay(1)\n  ? 2\nend\nprogram other()\nbegin\n  \
         while true\n    delay(0.1)\n  endWhile\nend\n",
    );
    set(&mut debugger, "start", &[(2, None)]);
    stops(
        &mut debugger,
        |debugger, stop| {
            if let Stop::Breakpoints { task, .. } = stop {
                debugger.step(*task, StepKind::Over);
            } else {
                debugger.controller.stop();
            }
        },
        expect![[r#"
        [0] main~: start:2
        step main~: start:3
        end
    "#]],
    );
    assert!(debugger.controller.now() >= 1_000_000_000);
}

#[test]
fn a_run_time_error_stops_the_run_where_it_happens() {
    let listing = "program start()\nnum l_nZero\nbegin\n  ? 1\n  ? 1/l_nZero\n  ? 3\nend\n";
    let mut debugger = debugger(listing);
    debugger.set_errors(StopErrors::all());
    stops(
        &mut debugger,
        |_, _| (),
        expect![[r#"
        error 10 main~: start:2
        end
    "#]],
    );
    for (errors, expected) in [(StopErrors::default(), 0), (StopErrors::only([10]), 1), (StopErrors::only([20]), 0)] {
        let mut debugger = self::debugger(listing);
        debugger.set_errors(errors.clone());
        assert_eq!(usize::from(run(&mut debugger).is_some()), expected, "{errors:?}");
    }
}

/// Breakpoints and steps do not change the events of a run.
#[test]
fn a_debugged_run_has_the_same_events() {
    let expected = Running::start(CALLS).to_the_end().printed();
    let mut debugger = debugger(CALLS);
    set(&mut debugger, "start", &[(1, None), (2, None), (3, None)]);
    set(&mut debugger, "add", &[(1, None)]);
    let mut events = Vec::new();
    while let Some(stop) = run(&mut debugger) {
        debugger.step(task_of(&stop).unwrap(), StepKind::In);
        events.extend(debugger.controller.devices.take_events());
    }
    events.extend(debugger.controller.devices.take_events());
    let running = Running { controller: debugger.controller, events };
    assert_eq!(running.printed(), expected);
}

/// Going back step by step from the end of `CALLS` passes the same lines as the steps forward, in reverse order.
#[test]
fn steps_back_pass_the_lines_of_the_steps_forward() {
    for kind in [StepKind::In, StepKind::Over] {
        let mut debugger = debugger(CALLS);
        debugger.record(PastLimits::snapshots(100));
        set(&mut debugger, "start", &[(1, Some("1"))]);
        let mut forward = Vec::new();
        let mut task = None;
        while let Some(stop) = run(&mut debugger) {
            task = task_of(&stop);
            forward.push(shown(&debugger, Some(Stop::Step { task: task.unwrap() })));
            debugger.step(task.unwrap(), kind);
            if forward.len() == 9 {
                break;
            }
        }
        debugger.abandon_step();
        let mut back = Vec::new();
        while let stop @ Stop::Step { .. } = debugger.step_back(task.unwrap(), kind) {
            back.push(shown(&debugger, Some(stop)));
        }
        back.reverse();
        forward.pop();
        assert_eq!(back, forward[1..], "{kind:?}");
        // The continued run repeats the same lines.
        let again = run(&mut debugger);
        assert_eq!(shown(&debugger, again), "[0] main~: start:1");
    }
}

#[test]
fn a_step_back_out_of_a_program_leads_to_its_call() {
    let mut debugger = debugger(CALLS);
    debugger.record(PastLimits::snapshots(100));
    set(&mut debugger, "add", &[(2, Some("2"))]);
    let task = task_of(&run(&mut debugger).unwrap()).unwrap();
    let stop = debugger.step_back(task, StepKind::Out);
    expect!["step main~: start:2"].assert_eq(&shown(&debugger, Some(stop)));
}

#[test]
fn a_run_back_stops_at_each_breakpoint_and_at_the_beginning() {
    let mut debugger = debugger(CALLS);
    debugger.record(PastLimits::snapshots(100));
    set(&mut debugger, "add", &[(1, None)]);
    while run(&mut debugger).is_some() {}
    let mut seen = Vec::new();
    for _ in 0..4 {
        let stop = debugger.run_back();
        seen.push(shown(&debugger, Some(stop)));
    }
    expect![[r#"
        [0] main~: add:1 < start:2
        [0] main~: add:1 < start:2
        [0] main~: add:1 < start:2
        beginning"#]]
    .assert_eq(&seen.join("\n"));
}

pub(crate) const LONG: &str = r#"
program start()
num l_nRound
num l_nSum
begin
  taskCreate "other",10,other()
  for l_nRound=1 to 200000
    l_nSum=l_nSum+l_nRound
    if l_nRound-20000*roundDown(l_nRound/20000)==0
      delay(0.01)
    endIf
  endFor
  ? l_nSum
end

program other()
begin
  while true
    delay(0.002)
  endWhile
end
"#;

/// Reverse execution restores exactly the state that the run had at a moment the first time.
#[test]
fn a_long_run_goes_back_to_the_same_states() {
    let mut debugger = debugger(LONG);
    debugger.record(PastLimits::snapshots(20));
    set(&mut debugger, "start", &[(5, None)]);
    let mut passed = Vec::new();
    while passed.len() < 10 {
        assert!(run(&mut debugger).is_some());
        passed.push(state(&debugger));
    }
    for expected in passed.iter().rev().skip(1) {
        debugger.run_back();
        assert!(state(&debugger) == *expected);
    }
    for expected in passed.iter().skip(1) {
        assert!(run(&mut debugger).is_some());
        assert!(state(&debugger) == *expected);
    }
}

/// Time and threads.
fn state(debugger: &Debugger) -> String {
    let threads: Vec<_> = debugger.controller.vm.tasks().iter().map(|task| &task.thread).collect();
    format!("{:?} {threads:?}", debugger.controller.now())
}
