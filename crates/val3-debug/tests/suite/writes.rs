//! Recorded writes of data.

use std::ops::ControlFlow;

use expect_test::expect;
use val3_debug::{DataAccess, DataWrites, Debugger, PastLimits, StepKind, Stop, WatchedData, WriteLimits};
use val3_vm::FragmentContext;

use crate::data::{DATA, state, watch, with_signals};
use crate::debugger::{debugger, first_row, run, set, task_of};
use crate::past::WAITS;

fn data(debugger: &mut Debugger, path: &str) -> WatchedData {
    let task = debugger.controller.vm.tasks()[0].id;
    WatchedData::new(&mut debugger.controller, FragmentContext::Frame(task, 0), path).unwrap()
}

fn writes(debugger: &mut Debugger, data: &WatchedData, count: usize) -> DataWrites {
    debugger.writes(data, WriteLimits::writes(count), &mut |_| ControlFlow::Continue(())).unwrap()
}

/// Formats writes, the newest first, `task program:line value`, and the value before them.
fn shown(debugger: &Debugger, writes: &DataWrites) -> String {
    let mut shown = String::new();
    for write in &writes.writes {
        let task = write.task.as_deref().unwrap_or("outside");
        let line = write.line.as_ref().map_or_else(String::new, |line| {
            format!(" {}:{}", line.program, line.row + 1 - first_row(debugger, &line.program))
        });
        shown += &format!("{task}{line} {}\n", write.value);
    }
    shown + writes.initial.as_ref().map_or("...", |initial| &initial.value) + "\n"
}

#[test]
fn writes_are_listed_backwards() {
    let mut debugger = debugger(DATA);
    debugger.record(PastLimits::default());
    debugger.stop_at_exit(true);
    assert!(matches!(run(&mut debugger), Some(Stop::Exit { .. })));
    let count = data(&mut debugger, "nCount");
    let found = writes(&mut debugger, &count, 10);
    expect![[r#"
        other other:2 11
        main~ add:1 2
        main~ start:2 1
        0
    "#]]
    .assert_eq(&shown(&debugger, &found));
    let times: Vec<u64> = found.writes.iter().map(|write| write.time / 1_000_000).collect();
    assert_eq!(times, [100, 0, 0]);
    let newest = writes(&mut debugger, &count, 2);
    assert_eq!((&newest.writes[..], &newest.initial), (&found.writes[..2], &None));
    assert_eq!(writes(&mut debugger, &count, 3), found);
    for (path, expected) in [("nGrid[0,1]", "main~ start:6 7\n0\n"), ("sName", "main~ start:7 \"bolt\"\n\"\"\n")] {
        let data = data(&mut debugger, path);
        let found = writes(&mut debugger, &data, 10);
        assert_eq!(shown(&debugger, &found), expected);
    }
}

/// The recorded writes are the stops of a data breakpoint, for any number of snapshots in the history.
#[test]
fn the_writes_are_those_of_a_data_breakpoint() {
    for (listing, path, snapshots) in [(DATA, "nCount", 100), (WAITS, "bSeen", 100), (WAITS, "bGo", 3)] {
        let mut debugger = debugger(listing);
        debugger.record(PastLimits::snapshots(snapshots));
        watch(&mut debugger, &[(path, None)]);
        let watched = data(&mut debugger, path);
        let mut stops = Vec::new();
        while let Some(Stop::Data(stop)) = run(&mut debugger) {
            stops.push((debugger.controller.now(), stop.line, stop.changes[0].new.clone()));
        }
        stops.reverse();
        let before = state(&debugger.controller);
        let found = writes(&mut debugger, &watched, 1000);
        let found: Vec<_> = found.writes.into_iter().map(|write| (write.time, write.line, write.value)).collect();
        assert_eq!(found, stops, "{path}");
        assert_eq!(state(&debugger.controller), before, "the run is where it was");
    }
}

/// The stop is not repeated, and hits are not counted again.
#[test]
fn a_search_of_writes_does_not_change_the_run() {
    let mut debugger = debugger(WAITS);
    debugger.record(PastLimits::default());
    set(&mut debugger, "start", &[(3, Some("2"))]);
    let task = task_of(&run(&mut debugger).unwrap()).unwrap();
    let before = state(&debugger.controller);
    let go = data(&mut debugger, "bGo");
    assert!(!writes(&mut debugger, &go, 100).writes.is_empty());
    assert_eq!(state(&debugger.controller), before);
    assert!(!debugger.is_in_past());
    set(&mut debugger, "start", &[(3, Some("2")), (4, None)]);
    let stop = run(&mut debugger);
    assert_eq!(crate::debugger::shown(&debugger, stop), "[1] main~: start:4");
    debugger.step_back(task, StepKind::Over);
    assert_eq!(state(&debugger.controller), before);
    let mut calls = 0;
    let cancelled = debugger.writes(&go, WriteLimits::writes(100), &mut |_| {
        calls += 1;
        if calls > 3 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    });
    assert_eq!((cancelled, state(&debugger.controller)), (None, before));
    assert!(debugger.is_in_past(), "the recorded future remains");
}

/// An earlier call's variable was in the same place.
#[test]
fn the_writes_of_a_local_are_those_of_its_call() {
    let mut debugger = debugger(
        "program start()\nnum l_n\nbegin\n  for l_n=1 to 3\n    call work(l_n)\n  endFor\nend\nprogram work(num x_n)\n\
         num l_nOwn\nbegin\n  l_nOwn=x_n\n  l_nOwn=l_nOwn*2\n  ? l_nOwn\nend\n",
    );
    debugger.record(PastLimits::default());
    set(&mut debugger, "work", &[(3, Some("3"))]);
    run(&mut debugger).unwrap();
    let own = data(&mut debugger, "l_nOwn");
    let found = writes(&mut debugger, &own, 10);
    assert_eq!(shown(&debugger, &found), "main~ work:2 6\nmain~ work:1 3\n0\n");
}

/// Changes by the debugger and of inputs belong to no task.
#[test]
fn changes_from_outside_are_writes() {
    let listing =
        "num nCount\nprogram start()\nbegin\n  while true\n    nCount=nCount+1\n    delay(0.01)\n  endWhile\nend\n";
    let mut debugger = with_signals(listing, "Io\\lamp", DataAccess::Write);
    debugger.record(PastLimits::default());
    let task = debugger.controller.vm.tasks()[0].id;
    for _ in 0..8 {
        debugger.step(task, StepKind::In);
        run(&mut debugger).unwrap();
    }
    let io = &mut debugger.controller.devices.state.io;
    let signal = io.find("Io\\start").unwrap();
    io.set(signal, 1.0);
    let application = debugger.controller.vm.space.loaded().next().unwrap().1;
    let store = application.data[usize::from(application.image.data("nCount").unwrap())];
    debugger.controller.vm.space.memory.store_mut(store).unwrap().nums[0] = 50.0;
    debugger.begin_new_future();
    let input = WatchedData::signal(&debugger.controller, "Io\\start").unwrap();
    let count = data(&mut debugger, "nCount");
    let found = writes(&mut debugger, &count, 10);
    expect![[r#"
        outside 50
        main~ start:2 2
        main~ start:2 1
        0
    "#]]
    .assert_eq(&shown(&debugger, &found));
    for _ in 0..8 {
        debugger.step(task, StepKind::In);
        run(&mut debugger).unwrap();
    }
    let found = writes(&mut debugger, &input, 10);
    assert_eq!(shown(&debugger, &found), "outside true\nfalse\n");
    let found = writes(&mut debugger, &count, 4);
    expect![[r#"
        main~ start:2 53
        main~ start:2 52
        main~ start:2 51
        outside 50
        ...
    "#]]
    .assert_eq(&shown(&debugger, &found));
}

#[test]
fn a_run_that_is_not_recorded_has_no_writes() {
    let mut debugger = debugger(DATA);
    let count = data(&mut debugger, "nCount");
    assert_eq!(debugger.writes(&count, WriteLimits::writes(10), &mut |_| ControlFlow::Continue(())), None);
}
