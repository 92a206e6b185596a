//! Pauses, changes of the next line, and restarts.

use expect_test::expect;
use val3_debug::{AdvanceResult, BreakpointId, Debugger, GotoFault, PastLimits, RestartFault, StepKind, Stop};
use val3_lang::ports::TaskNumber;
use val3_vm::TaskState;

use crate::debugger::{CALLS, debugger, file, first_row, run, set, shown, task_of};

/// Two tasks that count, and one that waits.
const COUNTING: &str = r#"
num nFirst
num nSecond
program start()
begin
  taskCreate "first",10,first()
  taskCreate "second",10,second()
  wait(nFirst<0)
end
program first()
begin
  while true
    nFirst=nFirst+1
  endWhile
end
program second()
begin
  while true
    nSecond=nSecond+1
    delay(0.001)
  endWhile
end
"#;

fn task(debugger: &Debugger, name: &str) -> TaskNumber {
    debugger.controller.vm.tasks().iter().find(|task| task.name == name).unwrap().id
}

fn global(debugger: &Debugger, name: &str) -> f64 {
    let vm = &debugger.controller.vm;
    let (_, instance) = vm.space.loaded().next().unwrap();
    let store = instance.data[usize::from(instance.image.data(name).unwrap())];
    vm.space.memory.store(store).unwrap().nums[0]
}

fn cycles(debugger: &mut Debugger, count: usize) {
    for _ in 0..count {
        let progress = debugger.advance();
        assert!(matches!(progress, AdvanceResult::Ran(_)), "{progress:?}");
    }
}

#[test]
fn a_pause_stops_a_loop_without_waits() {
    let mut debugger = debugger(COUNTING);
    cycles(&mut debugger, 3);
    let (now, count) = (debugger.controller.now(), global(&debugger, "nFirst"));
    let first = task(&debugger, "first");
    debugger.pause(Some(first));
    let stop = run(&mut debugger);
    assert_eq!(stop, Some(Stop::Pause { task: Some(first) }));
    assert!(shown(&debugger, stop).starts_with("pause first: first:"));
    assert!(debugger.controller.now() == now && global(&debugger, "nFirst").to_bits() == count.to_bits());
    cycles(&mut debugger, 1);
    assert!(global(&debugger, "nFirst") > count);
}

/// The stack frame of a waiting task shows its waiting line.
#[test]
fn a_pause_shows_the_line_that_waits() {
    let mut debugger = debugger(COUNTING);
    cycles(&mut debugger, 3);
    debugger.pause(None);
    assert!(matches!(run(&mut debugger), Some(Stop::Pause { task: Some(_) })));
    let shown_task = |name| shown(&debugger, Some(Stop::Step { task: task(&debugger, name) }));
    assert_eq!(shown_task("main~"), "step main~: start:3");
    debugger.pause(Some(TaskNumber(99)));
    assert!(matches!(run(&mut debugger), Some(Stop::Pause { task: Some(_) })), "there is no such task");
}

#[test]
fn one_task_is_paused_while_the_others_run() {
    let mut debugger = debugger(COUNTING);
    cycles(&mut debugger, 3);
    let first = task(&debugger, "first");
    debugger.pause_task(first, true);
    let counts = (global(&debugger, "nFirst"), global(&debugger, "nSecond"));
    cycles(&mut debugger, 5);
    assert!(global(&debugger, "nFirst").to_bits() == counts.0.to_bits() && global(&debugger, "nSecond") > counts.1);
    assert_eq!(debugger.paused_tasks(), [first]);
    debugger.resume_tasks();
    cycles(&mut debugger, 1);
    assert!(global(&debugger, "nFirst") > counts.0);
}

#[test]
fn a_task_stops_alone_while_the_others_run() {
    let mut debugger = debugger(COUNTING);
    debugger.stop_tasks_alone(true);
    set(&mut debugger, "second", &[(2, None)]);
    let stop = run(&mut debugger);
    let second = task(&debugger, "second");
    assert_eq!(shown(&debugger, stop), "[0] second: second:2");
    assert_eq!(debugger.paused_tasks(), [second]);
    let counts = (global(&debugger, "nFirst"), global(&debugger, "nSecond"));
    cycles(&mut debugger, 5);
    assert!(global(&debugger, "nFirst") > counts.0 && global(&debugger, "nSecond").to_bits() == counts.1.to_bits());
    // The step of one task does not end when another task stops.
    let first = task(&debugger, "first");
    debugger.step(first, StepKind::Out);
    debugger.pause_task(second, false);
    let stop = run(&mut debugger);
    assert_eq!(shown(&debugger, stop), "[0] second: second:2");
    debugger.step(first, StepKind::Over);
    assert_eq!(run(&mut debugger), Some(Stop::Step { task: first }));
    assert_eq!(debugger.paused_tasks().len(), 2);
}

#[test]
fn a_single_task_steps_while_the_others_are_paused() {
    let mut debugger = debugger(COUNTING);
    cycles(&mut debugger, 3);
    let first = task(&debugger, "first");
    debugger.pause_others(first);
    let second = global(&debugger, "nSecond");
    for _ in 0..10 {
        debugger.step(first, StepKind::Over);
        assert_eq!(run(&mut debugger), Some(Stop::Step { task: first }));
    }
    cycles(&mut debugger, 10);
    assert!(global(&debugger, "nSecond").to_bits() == second.to_bits());
    debugger.resume_tasks();
    cycles(&mut debugger, 10);
    assert!(global(&debugger, "nSecond") > second);
}

#[test]
fn a_task_continues_at_another_line() {
    let mut debugger = debugger("program start()\nbegin\n  ? 1\n  ? 2\n\n  ? 3\n  ? 4\nend\n");
    set(&mut debugger, "start", &[(2, None), (5, None)]);
    let task = task_of(&run(&mut debugger).unwrap()).unwrap();
    let (file, first) = (file(&debugger, "start"), first_row(&debugger, "start"));
    let target = debugger.goto_target(task, &file, first + 2).unwrap();
    assert_eq!((target.row, target.is_end), (first + 3, false));
    let target = debugger.goto_target(task, &file, first + 4).unwrap();
    let now = debugger.controller.now();
    debugger.goto(task, target).unwrap();
    assert_eq!(shown(&debugger, Some(Stop::Step { task })), "step main~: start:5");
    assert!(debugger.controller.now() == now, "nothing is executed");
    assert_eq!(run(&mut debugger), None, "the task has arrived at the breakpoint of the line already");
    assert_eq!(debugger.goto(task, target), Err(GotoFault::NoTask));
}

#[test]
fn a_task_continues_only_in_its_innermost_program() {
    let mut debugger = debugger(CALLS);
    set(&mut debugger, "add", &[(2, Some("1"))]);
    let task = task_of(&run(&mut debugger).unwrap()).unwrap();
    let (outer, inner) = (file(&debugger, "start"), file(&debugger, "add"));
    assert_eq!(debugger.goto_target(task, &outer, 1), Err(GotoFault::OtherProgram));
    assert_eq!(debugger.goto_target(TaskNumber(99), &inner, 1), Err(GotoFault::NoTask));
    let end = debugger.goto_target(task, &inner, 1000).unwrap();
    assert!(end.is_end);
    debugger.goto(task, end).unwrap();
    debugger.step(task, StepKind::In);
    let stop = run(&mut debugger);
    assert_eq!(shown(&debugger, stop), "step main~: start:3");
}

/// Like `taskResume`.
#[test]
fn a_failed_task_continues_at_another_line() {
    let mut debugger = debugger("program start()\nnum l_nZero\nbegin\n  ? 1/l_nZero\n  ? 2\nend\n");
    debugger.set_errors(val3_debug::StopErrors::all());
    let task = task_of(&run(&mut debugger).unwrap()).unwrap();
    let (file, first) = (file(&debugger, "start"), first_row(&debugger, "start"));
    let target = debugger.goto_target(task, &file, first + 1).unwrap();
    debugger.goto(task, target).unwrap();
    assert_eq!(debugger.controller.vm.tasks()[0].state, TaskState::Running);
    assert_eq!(run(&mut debugger), None);
    let events = debugger.controller.devices.take_events();
    assert!(format!("{events:?}").contains("resumed") && format!("{events:?}").contains('2'));
}

#[test]
fn a_frame_restarts_where_its_program_was_called() {
    let mut debugger = debugger(CALLS);
    debugger.record(PastLimits::snapshots(100));
    set(&mut debugger, "add", &[(2, Some("2"))]);
    let task = task_of(&run(&mut debugger).unwrap()).unwrap();
    let mut seen = Vec::new();
    for depth in [0, 0, 1] {
        let stop = debugger.restart_frame(task, depth).unwrap();
        seen.push(format!("{} at {}", shown(&debugger, Some(stop)), debugger.controller.now()));
    }
    expect![[r#"
        step main~: add:1 < start:2 at 14000
        step main~: add:1 < start:2 at 14000
        step main~: start:1 at 0
    "#]]
    .assert_eq(&(seen.join("\n") + "\n"));
    assert_eq!(debugger.restart_frame(task, 1), Err(RestartFault::NoFrame));
    // The continued run repeats the same lines.
    set(&mut debugger, "add", &[(2, None)]);
    let again = run(&mut debugger);
    assert_eq!(shown(&debugger, again), "[0] main~: add:2 < start:2");
}

#[test]
fn a_frame_out_of_reach_does_not_restart() {
    let mut debugger = debugger(COUNTING);
    assert_eq!(debugger.restart_frame(TaskNumber(1), 0), Err(RestartFault::NoPast));
    cycles(&mut debugger, 2);
    debugger.record(PastLimits::snapshots(10));
    cycles(&mut debugger, 2);
    let (now, first) = (debugger.controller.now(), task(&debugger, "first"));
    assert_eq!(debugger.restart_frame(first, 0), Err(RestartFault::OutOfReach));
    assert_eq!(debugger.controller.now(), now);
}

/// Breakpoints, watched data, pauses and the history are removed: the run continues as without a debugger.
#[test]
fn a_controller_that_is_let_go_runs_on() {
    let mut debugger = debugger(COUNTING);
    debugger.record(PastLimits::default());
    set(&mut debugger, "first", &[(2, None)]);
    assert!(matches!(run(&mut debugger), Some(Stop::Breakpoints { .. })));
    debugger.pause_task(task(&debugger, "second"), true);
    debugger.step(task(&debugger, "first"), StepKind::Over);
    debugger.detach();
    let counts = (global(&debugger, "nFirst"), global(&debugger, "nSecond"));
    cycles(&mut debugger, 10);
    assert!(global(&debugger, "nFirst") > counts.0 && global(&debugger, "nSecond") > counts.1);
    assert_eq!(debugger.reach(), None);
}

/// The caller handles requests of the client between two calls.
#[test]
fn hits_without_a_stop_take_few_calls() {
    let listing =
        "num nCount\nnum nSum\n\nprogram start()\nbegin\n  for nCount=1 to 3000\n    nSum=nSum+nCount\n  endFor\nend\n";
    let mut debugger = debugger(listing);
    set(&mut debugger, "start", &[(2, Some("3000"))]);
    let calls = (1..=10_000).find(|_| matches!(debugger.advance(), AdvanceResult::Stopped(_)));
    assert!(calls.is_some_and(|calls| calls < 30), "{calls:?}");
    assert_eq!(debugger.hits(BreakpointId(0)), 3000);
}
