//! Data breakpoints.

use expect_test::{Expect, expect};
use val3_debug::{
    AdvanceResult, BreakpointId, DataAccess, DataBreakpoint, DataStop, Debugger, PastLimits, StepKind, Stop,
    WatchedData, frames,
};
use val3_lang::memory::LinkPlace;
use val3_lang::ports::TaskNumber;
use val3_machine::controller::Controller;
use val3_machine::io::{Direction, Signal};
use val3_tests::running::Running;
use val3_vm::FragmentContext;

use crate::debugger::{CALLS, debugger, first_row, run, set, shown, task_of};
use crate::past::WAITS;

/// Sets data breakpoints on these paths in the frame of the first task.
pub(crate) fn watch(debugger: &mut Debugger, paths: &[(&str, Option<&str>)]) {
    watch_access(debugger, paths, DataAccess::Write);
}

/// Sets a data breakpoint on a path in the innermost frame of a task.
pub(crate) fn watch_in(debugger: &mut Debugger, task: TaskNumber, path: &str) {
    watch_of(debugger, task, &[(path, None)], DataAccess::Write);
}

fn watch_access(debugger: &mut Debugger, paths: &[(&str, Option<&str>)], access: DataAccess) {
    let task = debugger.controller.vm.tasks()[0].id;
    watch_of(debugger, task, paths, access);
}

fn watch_of(debugger: &mut Debugger, task: TaskNumber, paths: &[(&str, Option<&str>)], access: DataAccess) {
    let breakpoints = (20..).zip(paths).map(|(id, (path, hits))| DataBreakpoint {
        id: BreakpointId(id),
        data: WatchedData::new(&mut debugger.controller, FragmentContext::Frame(task, 0), path).unwrap(),
        access,
        condition: None,
        hits: hits.map(|hits| hits.parse().unwrap()),
    });
    let breakpoints = breakpoints.collect();
    debugger.set_data_breakpoints(breakpoints);
}

/// Formats a data stop: `task line: old -> new`.
pub(crate) fn change(debugger: &Debugger, stop: &Stop) -> String {
    let Stop::Data(stop) = stop else { return shown(debugger, Some(stop.clone())) };
    let DataStop { task, line, changes } = &**stop;
    let name = |id| debugger.controller.vm.tasks().iter().find(|task| task.id == id).map_or("?", |task| &task.name);
    let line =
        line.as_ref().map(|line| format!("{}:{}", line.program, line.row + 1 - first_row(debugger, &line.program)));
    let changes: Vec<_> =
        changes.iter().map(|change| format!("[{}] {} -> {}", change.id.0, change.old, change.new)).collect();
    format!("{} {}: {}", task.map_or("outside", name), line.unwrap_or_default(), changes.join(", "))
}

fn all(debugger: &mut Debugger) -> String {
    let mut all = String::new();
    for _ in 0..40 {
        let Some(stop) = run(debugger) else { return all + "end\n" };
        all += &(change(debugger, &stop) + "\n");
    }
    all
}

fn check(listing: &str, paths: &[(&str, Option<&str>)], expected: Expect) {
    let mut debugger = debugger(listing);
    watch(&mut debugger, paths);
    expected.assert_eq(&all(&mut debugger));
}

pub(crate) const DATA: &str = r#"
num nCount
num nGrid[2,2]
string sName
trsf trPart[2]
num nSame
program start()
num l_nSum
begin
  taskCreate "other",10,other(l_nSum)
  nCount=1
  nSame=0
  nSame=0/(-1)
  nGrid[1,0]=nGrid[1,0]+5
  nGrid[0,1]=7
  sName="bolt"
  trPart[1].x=2.5
  trPart[0].x=9
  call add(nCount)
  wait(nCount>10)
end
program add(num& x_nTotal)
begin
  x_nTotal=x_nTotal+1
end
program other(num x_nOnce)
begin
  delay(0.1)
  nCount=11
end
"#;

#[test]
fn a_change_stops_after_its_line() {
    check(
        DATA,
        &[("nCount", None)],
        expect![[r#"
            main~ start:2: [20] 0 -> 1
            main~ add:1: [20] 1 -> 2
            ? other:2: [20] 2 -> 11
            end
        "#]],
    );
}

#[test]
fn elements_fields_and_texts_are_watched() {
    check(
        DATA,
        &[("nGrid[1,0]", None), ("sName", None), ("trPart[1].x", None), ("trPart[1]", None), ("nGrid", None)],
        expect![[r#"
            main~ start:5: [20] 0 -> 5, [24] {0, 0, 0, 0} -> {0, 0, 5, 0}
            main~ start:6: [24] {0, 0, 5, 0} -> {0, 7, 5, 0}
            main~ start:7: [21] "" -> "bolt"
            main~ start:8: [22] 0 -> 2.5, [23] {0,0,0,0,0,0} -> {2.5,0,0,0,0,0}
            end
        "#]],
    );
}

/// The sign of zero counts.
#[test]
fn values_are_compared_bit_by_bit() {
    check(
        DATA,
        &[("nSame", None)],
        expect![[r#"
            main~ start:4: [20] 0 -> 0
            end
        "#]],
    );
}

/// The last line before `end` or a closing keyword with a breakpoint has two stops.
#[test]
fn a_change_before_another_stop_is_not_lost() {
    let listing =
        "num nCount\nprogram start()\nnum l_n\nbegin\n  for l_n=1 to 2\n    nCount=l_n\n  endFor\n  nCount=9\nend\n";
    let mut debugger = Debugger::new(Running::debugged_on(Running::devices(), listing).controller);
    debugger.stop_at_exit(true);
    watch(&mut debugger, &[("nCount", None)]);
    set(&mut debugger, "start", &[(3, None)]);
    expect![[r#"
        main~ start:2: [20] 0 -> 1
        [0] main~: start:3
        main~ start:2: [20] 1 -> 2
        [0] main~: start:3
        main~ start:4: [20] 2 -> 9
        exit main~: start:5
        end
    "#]]
    .assert_eq(&all(&mut debugger));
}

#[test]
fn changes_are_counted() {
    check(
        DATA,
        &[("nCount", Some("%2"))],
        expect![[r#"
            main~ add:1: [20] 1 -> 2
            end
        "#]],
    );
}

/// Locals belong to a stack frame, and no longer exist after it.
#[test]
fn a_local_is_watched_until_its_program_ends() {
    let mut debugger = debugger(
        "program start()\nnum l_n\nbegin\n  for l_n=1 to 3\n    call work(l_n)\n  endFor\nend\nprogram work(num& x_n)\n\
         num l_nOwn\nbegin\n  l_nOwn=x_n\n  l_nOwn=l_nOwn*2\n  ? l_nOwn\nend\n",
    );
    set(&mut debugger, "work", &[(1, Some("1"))]);
    run(&mut debugger).unwrap();
    watch(&mut debugger, &[("l_nOwn", None), ("x_n", None)]);
    expect![[r#"
        main~ work:1: [20] 0 -> 1
        main~ work:2: [20] 1 -> 2
        end
    "#]]
    .assert_eq(&all(&mut debugger));
}

#[test]
fn keys_and_fields_of_collections_are_watched() {
    check(
        "num cCount[\"\"]\nprogram start()\nbegin\n  insert(cCount[\"a\"])\n  cCount[\"a\"]=1\n  insert(cCount[\"b\"])\n  \
         cCount[\"b\"]=2\n  cCount[\"a\"]=3\n  delete(cCount[\"a\"])\n  cCount[\"b\"]=4\nend\n",
        &[("cCount", None)],
        expect![[r#"
            main~ start:1: [20] {} -> 0
            main~ start:2: [20] 0 -> 1
            main~ start:3: [20] 1 -> {1, 0}
            main~ start:4: [20] {1, 0} -> {1, 2}
            main~ start:5: [20] {1, 2} -> {3, 2}
            main~ start:6: [20] {3, 2} -> 2
            ? start:7: [20] 2 -> 4
            end
        "#]],
    );
}

#[test]
fn identities_name_the_data() {
    let mut debugger = debugger(DATA);
    let context = FragmentContext::Frame(debugger.controller.vm.tasks()[0].id, 0);
    for (path, id, is_local) in [
        ("nGrid[1,0]", "main:nGrid[1,0]", false),
        ("trPart[1].rx", "main:trPart[1].rx", false),
        ("l_nSum", "main~/0/l_nSum", true),
    ] {
        let data = WatchedData::new(&mut debugger.controller, context, path).unwrap();
        assert_eq!((data.id(), data.is_local()), (id, is_local));
    }
    for wrong in
        ["", "nNone", "nGrid[2,0]", "nGrid[", "trPart[0].q", "nCount.x", "lib:nCount", "nGrid[\"a]", ".x", "[0]"]
    {
        assert!(WatchedData::new(&mut debugger.controller, context, wrong).is_err(), "{wrong}");
    }
    assert!(WatchedData::signal(&debugger.controller, "Io\\none").is_err());
}

/// A run back stops at the previous change, and the run then makes the same changes again. At each change, also at the
/// end of a wait, the memory is the same.
#[test]
fn a_run_back_stops_at_the_last_change() {
    for (listing, path) in [(DATA, "nCount"), (WAITS, "bSeen"), (WAITS, "bGo")] {
        let mut debugger = debugger(listing);
        debugger.record(PastLimits::snapshots(100));
        watch(&mut debugger, &[(path, None)]);
        let mut forward = Vec::new();
        while let Some(stop) = run(&mut debugger) {
            forward.push((change(&debugger, &stop), state(&debugger.controller)));
        }
        assert!(forward.len() > 2);
        let mut back = Vec::new();
        loop {
            let stop = debugger.run_back();
            if stop == Stop::Beginning {
                break;
            }
            back.push((change(&debugger, &stop), state(&debugger.controller)));
        }
        back.reverse();
        assert!(back == forward, "{path}");
        assert_eq!(all(&mut debugger).lines().count(), forward.len() + 1);
    }
}

/// Time, values and threads.
pub(crate) fn state(controller: &Controller) -> String {
    let vm = &controller.vm;
    let threads: Vec<_> = vm.tasks().iter().map(|task| &task.thread).collect();
    let memory = format!("{:?}", vm.space.memory.stores);
    // The reported size follows the capacities of the vectors, which may differ.
    let (values, _) = memory.split_once(", room").unwrap();
    format!("{} {values} {threads:?}", controller.now())
}

/// Data breakpoints do not change the events of a run.
#[test]
fn a_watched_run_has_the_same_events() {
    for listing in [CALLS, DATA] {
        let expected = format!("{:?}", Running::start(listing).to_the_end().events);
        let mut debugger = debugger(listing);
        let data = if listing == DATA { "nCount" } else { "l_nRound" };
        watch(&mut debugger, &[(data, None)]);
        let mut events = Vec::new();
        while let Some(stop) = run(&mut debugger) {
            if let Some(task) = task_of(&stop) {
                debugger.step(task, StepKind::In);
            }
            events.extend(debugger.controller.devices.take_events());
        }
        events.extend(debugger.controller.devices.take_events());
        assert_eq!(format!("{events:?}"), expected);
    }
}

/// An application with an input and two outputs, one of which is watched.
pub(crate) fn with_signals(listing: &str, path: &str, access: DataAccess) -> Debugger {
    let mut devices = Running::devices();
    for path in ["Io\\start", "Io\\lamp", "Io\\other"] {
        devices.state.io.declare(Signal {
            direction: if path == "Io\\start" { Direction::Input } else { Direction::Output },
            ..Signal::from_path(path, true)
        });
    }
    let mut debugger = Debugger::new(Running::on(devices, listing).controller);
    link_all(&mut debugger.controller, "diAll", &["Io\\lamp", "Io\\other"]);
    let data = WatchedData::signal(&debugger.controller, path).unwrap();
    assert_eq!(data.id(), format!("io:{path}"));
    debugger.set_data_breakpoints(vec![DataBreakpoint {
        id: BreakpointId(20),
        data,
        access,
        condition: None,
        hits: None,
    }]);
    debugger
}

/// Links the array's elements, if it exists.
fn link_all(Controller { vm, devices, .. }: &mut Controller, array: &str, paths: &[&str]) {
    let (_, application) = vm.space.loaded().next().unwrap();
    let Some(number) = application.image.data(array) else { return };
    let store = application.data[usize::from(number)];
    let links = paths.iter().map(|path| LinkPlace::Port(devices.state.io.link(path).number()));
    vm.space.memory.store_mut(store).unwrap().links = links.collect();
}

/// Inputs change from outside, before the first line of a cycle.
#[test]
fn signals_are_watched() {
    let listing = "program start()\nbegin\n  while true\n    delay(0)\n  endWhile\nend\n";
    let mut debugger = with_signals(listing, "Io\\start", DataAccess::Write);
    for _ in 0..50 {
        assert!(matches!(debugger.advance(), AdvanceResult::Ran(_)));
    }
    let io = &mut debugger.controller.devices.state.io;
    let signal = io.find("Io\\start").unwrap();
    io.set(signal, 1.0);
    let stop = run(&mut debugger).unwrap();
    assert_eq!(change(&debugger, &stop), "outside : [20] false -> true");
}

/// Reads through any variable or instruction count; reads of other elements in the array do not.
#[test]
fn reads_of_signals_are_watched() {
    let listing = r#"
dio diAll[2]
dio diCopy
num nBits
program start()
bool l_b
begin
  taskCreate "poller",10,poller()
  l_b=diAll[0]
  l_b=diAll[1]
  diAll[0]=true
  dioLink(diCopy,diAll[0])
  nBits=dioGet(diAll)
  if diCopy
    l_b=false
  endIf
  wait(diCopy)
  call look(diAll[0])
end
program look(dio& x_diSignal)
begin
  wait(x_diSignal==false)
end
program poller()
begin
  delay(0.02)
  diAll[0]=false
end
"#;
    let mut debugger = with_signals(listing, "Io\\lamp", DataAccess::Read);
    expect![[r#"
        main~ start:2: [20] false -> false
        main~ start:6: [20] true -> true
        main~ start:7: [20] true -> true
        main~ start:10: [20] true -> true
        main~ look:1: [20] true -> true
        end
    "#]]
    .assert_eq(&all(&mut debugger));
    let mut debugger = with_signals(listing, "Io\\lamp", DataAccess::ReadWrite);
    debugger.record(PastLimits::default());
    let first = run(&mut debugger).unwrap();
    let second = run(&mut debugger).unwrap();
    assert_eq!(debugger.run_back(), first, "the reads are found again");
    assert_eq!(run(&mut debugger), Some(second));
}

const READS: &str = r#"
num nCount
num nOther
string sName
trsf trPart[2]
num nValues[3]
program start()
num l_n
num l_m
begin
  l_n=nCount
  nCount=5
  l_m=l_n+1
  nOther=l_m
  sName=toString(".2",nCount)
  ? sName
  trPart[1].x=nCount*2
  trPart[0]=trPart[1]
  nValues[l_m]=3
  l_n=nValues[2]
  call show(nCount,nOther)
  if nOther>3 and nCount==5
    nOther=0
  endIf
  for l_n=1 to nValues[0]+1
    l_m=l_n
  endFor
  nCount=nCount+1
end
program show(num& x_nCount, num x_nOther)
begin
  x_nCount=1
  ? x_nCount
  ? x_nOther
end
"#;

/// Returns the lines that access the data.
fn readers(path: &str, access: DataAccess) -> String {
    let mut debugger = debugger(READS);
    watch_access(&mut debugger, &[(path, None)], access);
    let mut lines = Vec::new();
    while let Some(Stop::Data(stop)) = run(&mut debugger) {
        let line = stop.line.unwrap();
        let mark = if stop.changes[0].is_write { "!" } else { "" };
        lines.push(format!("{}:{}{mark}", line.program, line.row + 1 - first_row(&debugger, &line.program)));
    }
    lines.join(" ")
}

#[test]
fn lines_that_read_data_stop_the_run() {
    let shown: String = ["nCount", "nOther", "sName", "trPart", "trPart[1].x", "nValues", "l_n", "l_m"]
        .into_iter()
        .map(|path| format!("{path}: {}\n", readers(path, DataAccess::Read)))
        .collect();
    expect![[r#"
        nCount: start:1 start:5 start:7 show:2 start:12 start:18
        nOther: start:11 start:12
        sName: start:6
        trPart: start:8
        trPart[1].x: start:8
        nValues: start:10 start:15
        l_n: start:3 start:15 start:16 start:15
        l_m: start:4 start:9
    "#]]
    .assert_eq(&shown);
}

#[test]
fn reads_and_changes_are_told_apart() {
    expect!["start:1 start:2! start:5 start:7 show:1! show:2 start:12 start:18!"]
        .assert_eq(&readers("nCount", DataAccess::ReadWrite));
}

/// A change by the last line of a program is reported before the program returns, also if nothing follows in the task.
#[test]
fn a_change_by_the_last_line_is_not_lost() {
    let listing = "num nCount\nprogram start()\nnum l_nLast\nbegin\n  call work()\n  l_nLast=7\nend\nprogram work()\n\
                   num l_n\nbegin\n  l_n=1\n  l_n=2\nend\n";
    check(
        listing,
        &[("l_nLast", None)],
        expect![[r#"
            main~ start:2: [20] 0 -> 7
            end
        "#]],
    );
    let mut debugger = debugger(listing);
    debugger.record(PastLimits::default());
    set(&mut debugger, "work", &[(1, None)]);
    let task = task_of(&run(&mut debugger).unwrap()).unwrap();
    set(&mut debugger, "work", &[]);
    watch_in(&mut debugger, task, "l_n");
    expect![[r#"
        main~ work:1: [20] 0 -> 1
        main~ work:2: [20] 1 -> 2
        end
    "#]]
    .assert_eq(&all(&mut debugger));
    let stop = debugger.run_back();
    assert_eq!(change(&debugger, &stop), "main~ work:2: [20] 1 -> 2");
    let row = frames(&debugger.controller.vm, task)[0].row;
    assert_eq!(row - first_row(&debugger, "work"), 2, "before its `end`");
    debugger.step(task, StepKind::Over);
    assert_eq!(run(&mut debugger), Some(Stop::Step { task }));
    assert_eq!(frames(&debugger.controller.vm, task)[0].program, "start");
}
