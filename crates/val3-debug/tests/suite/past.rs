//! Memory use of the history.

use std::ops::ControlFlow;

use val3_debug::{Debugger, Goal, PastLimits, StepKind, Stop};

use crate::debugger::{LONG, debugger, run, set, shown, task_of};

/// Runs to the fifth wait.
fn run_on(limits: PastLimits) -> Debugger {
    let mut debugger = debugger(LONG);
    debugger.record(limits);
    set(&mut debugger, "start", &[(5, None)]);
    for _ in 0..5 {
        assert!(run(&mut debugger).is_some());
    }
    debugger
}

#[test]
fn the_past_reaches_back_to_the_beginning() {
    let debugger = run_on(PastLimits::default());
    let reach = debugger.reach().unwrap();
    assert!(reach.is_whole && reach.snapshots > 3);
    assert_eq!((reach.time, reach.cycles), (debugger.controller.now(), debugger.controller.now() / 4_000_000));
}

#[test]
fn a_run_is_in_the_past_until_it_is_where_it_was() {
    let mut debugger = run_on(PastLimits::default());
    assert!(!debugger.is_in_past());
    let task = debugger.controller.vm.tasks()[0].id;
    debugger.step_back(task, StepKind::Over);
    assert!(debugger.is_in_past());
    assert!(run(&mut debugger).is_some());
    assert!(!debugger.is_in_past(), "it has stopped at the same breakpoint");
    debugger.run_back();
    debugger.begin_new_future();
    assert!(!debugger.is_in_past(), "what has followed is gone");
}

/// The size of the snapshots is bounded, and the run goes back as far as it reports.
#[test]
fn a_budget_of_bytes_bounds_the_past() {
    let bytes = run_on(PastLimits::default()).reach().unwrap().bytes;
    for budget in [bytes / 2, bytes / 4, 1] {
        let mut debugger = run_on(PastLimits { bytes: budget, ..PastLimits::default() });
        let reach = debugger.reach().unwrap();
        assert!(reach.bytes <= budget || reach.snapshots == 1, "{reach:?}");
        let task = debugger.controller.vm.tasks()[0].id;
        debugger.go_to(reach.first);
        assert_eq!(debugger.controller.now(), reach.first.time);
        assert_eq!(debugger.reach().unwrap().time, 0);
        debugger.step(task, StepKind::Over);
        assert!(run(&mut debugger).is_some_and(|stop| task_of(&stop).is_some()));
    }
}

/// Each snapshot contains the large array.
#[test]
fn snapshots_count_the_data() {
    let programs = ["program start()\nbegin\nend\n", "num nLarge[100000]\nprogram start()\nbegin\nend\n"];
    let [small, large] = programs.map(|listing| {
        let mut debugger = debugger(listing);
        debugger.record(PastLimits::default());
        debugger.reach().unwrap().bytes
    });
    assert!(large >= small + 800_000, "{small} {large}");
    assert!(large < small + 900_000, "{small} {large}");
}

#[test]
fn a_run_that_is_not_recorded_has_no_past() {
    assert_eq!(debugger(LONG).reach(), None);
}

/// A cancelled search leaves the run at its moment. The watcher has received the progress.
#[test]
fn a_search_can_be_given_up() {
    let mut debugger = run_on(PastLimits::default());
    set(&mut debugger, "start", &[]);
    let (now, mut parts) = (debugger.controller.now(), Vec::new());
    let stop = debugger.search_back(Goal::Breakpoint, &mut |part| {
        parts.push(part);
        if parts.len() > 20 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    });
    assert_eq!((stop, debugger.controller.now()), (None, now));
    assert!(parts.iter().all(|part| (0.0..=1.0).contains(part)) && parts.first() < parts.last());
    assert_eq!(debugger.run_back(), Stop::Beginning);
    assert_eq!(debugger.controller.now(), 0);
}

/// A change of data does not hide the line before which it was made.
#[test]
fn a_run_goes_back_to_where_data_were_changed() {
    let mut debugger = debugger(LONG);
    debugger.record(PastLimits::default());
    set(&mut debugger, "start", &[(5, None)]);
    let stop = run(&mut debugger);
    let task = task_of(stop.as_ref().unwrap()).unwrap();
    let changed = debugger.controller.now();
    debugger.begin_new_future();
    debugger.step(task, StepKind::Over);
    assert!(run(&mut debugger).is_some());
    assert!(debugger.controller.now() > changed);
    debugger.step_back(task, StepKind::Over);
    assert_eq!(debugger.controller.now(), changed, "step back");
    run(&mut debugger);
    assert!(debugger.controller.now() > changed);
    debugger.run_back();
    assert_eq!(debugger.controller.now(), changed, "run back");
}

/// Lines that wait in every way, next to a task that ends the waits.
pub(crate) const WAITS: &str = r#"
bool bGo
bool bSeen
num nCount

program start()
num l_nRound
num l_nCode
begin
  taskCreate "helper",10,helper()
  for l_nRound=1 to 3
    delay(0.01)
    wait(bGo)
    bGo=false
    bSeen=false
    bSeen=watch(bGo,0.02)
    l_nCode=libDelete("Disk://gone")
    call inner()
    wait(sqrt(nCount)>=l_nRound)
    wait(taskStatus("helper")==1)
  endFor
end

program inner()
begin
  delay(0.005)
  wait(bGo or nCount>2)
end

program helper()
begin
  while nCount<30
    delay(0.013)
    bGo=true
    nCount=nCount+1
  endWhile
end
"#;

/// A step back over a waiting line goes to the beginning of the line.
#[test]
fn a_step_back_over_a_wait_leads_to_its_beginning() {
    for kind in [StepKind::In, StepKind::Over] {
        let mut debugger = debugger(WAITS);
        debugger.record(PastLimits::default());
        set(&mut debugger, "start", &[(1, None)]);
        let task = task_of(&run(&mut debugger).unwrap()).unwrap();
        set(&mut debugger, "start", &[]);
        let place = |debugger: &Debugger, stop: &Stop| (debugger.controller.now(), shown(debugger, Some(stop.clone())));
        let mut passed = Vec::new();
        debugger.step(task, kind);
        for _ in 0..20 {
            let stop = run(&mut debugger).unwrap();
            passed.push(place(&debugger, &stop));
            if passed.len() < 20 {
                debugger.step(task, kind);
            }
        }
        passed.pop();
        while let Some(before) = passed.pop() {
            let stop = debugger.step_back(task, kind);
            assert_eq!(place(&debugger, &stop), before);
        }
    }
}
