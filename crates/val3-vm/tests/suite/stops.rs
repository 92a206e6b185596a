//! Stop marks, cycles that stop after each line, and tasks that are held from outside.

use std::collections::BTreeSet;

use expect_test::expect;
use val3_lang::ports::TaskNumber;
use val3_vm::{CycleEnd, CycleWatch};

use crate::host::{Bench, LINE};

/// `start` calls `add` in a loop of three iterations, while an asynchronous and a synchronous task count.
const TASKS: &str = r#"
file "add"
file "count"
file "each"
file "start"
data nSum num[1]
data bLate bool[1]
program add
    file 0
    frame n1
    line 1 LoadFirst n0 $nSum 0
    line 2 Instruction print (num n0)
    closing 3 Return
end
program count
    file 1
    frame n2
    nums n1=1
again:
    line 1 LoadFirst n0 $nSum 0 Add n0 n0 n1 StoreFirst $nSum 0 n0
    line 2 Jump again
end
program each
    file 2
    frame n3
    nums n1=1
again:
    line 1 LoadFirst n0 $nSum 0 Add n0 n0 n1 StoreFirst $nSum 0 n0
    line 2 Instruction delay (num n2)
    line 3 Jump again
end
program start
    file 3
    frame n5
    nums n2=3, n3=1, n4=0.004
    line 1 CreateTask "count" n2 count ()
    CreateTask "each" n4 overrun $bLate each ()
again:
    line 2 Call add ()
    line 3 Add n0 n0 n3
    line 4 UnlessLess n0 n2 end
    line 5 Jump again
end:
    closing 6 Return
end
"#;

const FILES: [&str; 4] = ["add", "count", "each", "start"];

/// Returns the line before which a task is: `program:row`.
fn position(bench: &Bench, task: TaskNumber) -> String {
    let task = bench.vm.tasks().iter().find(|known| known.id == task).unwrap();
    let frame = task.thread.frames.last().unwrap();
    let program = &bench.vm.space.instance(frame.instance).unwrap().image.programs[usize::from(frame.program)];
    format!("{}:{}", program.name, program.halt_at(task.thread.next).unwrap().row)
}

/// Returns the stops of a run up to a time.
fn stops(bench: &mut Bench, until: u64) -> String {
    let mut stops = Vec::new();
    bench.schedule.limit = Some(until);
    loop {
        match bench.cycle() {
            CycleEnd::AtStop(task) => stops.push(position(bench, task)),
            CycleEnd::Limit => return stops.join(" "),
            _ => {}
        }
    }
}

fn stop_at(bench: &mut Bench, file: &str, rows: &[u32]) {
    bench.vm.set_stops(file, rows.iter().copied().collect::<BTreeSet<_>>());
}

#[test]
fn a_task_stops_before_each_marked_line_once() {
    let mut bench = Bench::new(TASKS);
    stop_at(&mut bench, "add", &[2]);
    stop_at(&mut bench, "start", &[4]);
    expect!["add:2 start:4 add:2 start:4 add:2 start:4"].assert_eq(&stops(&mut bench, 200 * LINE));
}

#[test]
fn a_task_stops_before_a_closing_keyword_and_before_its_end() {
    let mut bench = Bench::new(TASKS);
    stop_at(&mut bench, "add", &[3]);
    stop_at(&mut bench, "start", &[6]);
    bench.vm.stop_at_ends(true);
    // A mark on the `end` of the task and the stop before the end are two stops at one place.
    expect!["add:3 add:3 add:3 start:6 start:6"].assert_eq(&stops(&mut bench, 200 * LINE));
}

#[test]
fn a_removed_mark_stops_no_task() {
    let mut bench = Bench::new(TASKS);
    stop_at(&mut bench, "add", &[2]);
    assert!(matches!(bench.cycle(), CycleEnd::AtStop(_)));
    stop_at(&mut bench, "add", &[]);
    stop_at(&mut bench, "add", &[2]);
    expect!["add:2 add:2 add:2"].assert_eq(&stops(&mut bench, 200 * LINE));
}

#[test]
fn stops_change_no_line_and_no_time() {
    let whole = record(&[], CycleWatch::Nothing);
    assert_eq!(whole[0].lines().count(), 3);
    for rows in [&[1][..], &[2], &[1, 2], &[3], &[6], &[0, 1, 2, 3, 4, 5, 6]] {
        assert_eq!(record(rows, CycleWatch::Failures), whole, "{rows:?}");
        assert_eq!(record(rows, CycleWatch::Lines), whole, "{rows:?}");
    }
    assert_eq!(record(&[], CycleWatch::Lines), whole);
}

/// Output, task changes, and state at the end of a run with stops at rows of all files.
fn record(rows: &[u32], watch: CycleWatch) -> [String; 3] {
    let mut bench = Bench::new(TASKS);
    for file in FILES {
        stop_at(&mut bench, file, rows);
    }
    bench.schedule.watch = watch;
    bench.vm.stop_at_ends(!rows.is_empty());
    stops(&mut bench, 9000 * LINE);
    let end = format!("{} {:?}", bench.schedule.now, bench.vm.tasks()[0].thread.next);
    [bench.host.record, format!("{:?}", bench.host.changes), end]
}

#[test]
fn a_cycle_can_stop_after_each_line() {
    let mut bench = Bench::new(TASKS);
    bench.schedule.watch = CycleWatch::Lines;
    bench.schedule.limit = Some(6 * LINE);
    let mut seen = Vec::new();
    while let CycleEnd::Seen(task) = bench.cycle() {
        let name = bench.vm.tasks().iter().find(|known| known.id == task).map_or("", |task| &task.name);
        seen.push(format!("{name} {}", position(&bench, task)));
    }
    expect!["start start:2, start add:1, start add:2, start start:3, start start:4, start start:5"]
        .assert_eq(&seen.join(", "));
}

#[test]
fn a_held_task_gets_no_turns_and_continues_where_it_was() {
    let mut bench = Bench::new(TASKS);
    stop_at(&mut bench, "add", &[1]);
    let CycleEnd::AtStop(start) = bench.cycle() else { panic!() };
    bench.vm.hold(start, true);
    let status = bench.vm.tasks()[0].status();
    bench.schedule.limit = Some(100 * LINE);
    assert_eq!(bench.cycle(), CycleEnd::Limit);
    assert_eq!((bench.host.record.as_str(), position(&bench, start).as_str()), ("", "add:1"));
    assert_eq!(bench.vm.tasks()[0].status(), status);
    stop_at(&mut bench, "add", &[]);
    bench.vm.hold(start, false);
    bench.schedule.limit = Some(200 * LINE);
    assert_eq!(bench.cycle(), CycleEnd::Limit);
    assert_eq!(bench.host.record.lines().count(), 3);
}

/// The rest of a line after a wait is a separate stop.
#[test]
fn a_watched_task_stops_after_the_line_that_it_has_waited_in() {
    let mut bench = Bench::new(
        "program start\nframe n1\nnums n0=0.001\nline 1 Instruction delay (num n0)\nline 2 Instruction print (num n0)\n\
         line 3 Return\nend",
    );
    bench.schedule.limit = Some(100 * LINE);
    assert_eq!(bench.cycle(), CycleEnd::Limit);
    bench.schedule.limit = None;
    bench.schedule.watch = CycleWatch::Lines;
    let mut seen = Vec::new();
    while let CycleEnd::Seen(task) = bench.cycle() {
        let is_left = bench.vm.tasks().iter().any(|known| known.id == task);
        seen.push(if is_left { position(&bench, task) } else { "end".to_owned() });
    }
    expect!["start:2 start:3 end"].assert_eq(&seen.join(" "));
}

#[test]
fn a_cycle_can_stop_after_a_run_time_error() {
    let mut bench = Bench::new("program start\nframe n2\nline 1 Line\nline 4 Divide n0 n0 n1\nReturn\nend");
    bench.schedule.watch = CycleWatch::Failures;
    assert_eq!(bench.cycle(), CycleEnd::Seen(bench.start));
    assert!(bench.schedule.is_within_cycle());
}

#[test]
fn stops_hold_for_libraries_that_are_loaded_later() {
    let application = r#"
library part "part"
import part show program ()
program start
    frame n1/t1
    line 1 TextMove t0 "part" Instruction libLoad (library part, string t0)
    line 2 Call import 0 ()
    Return
end"#;
    let mut bench = Bench::with_libraries(application, &[LIBRARY]);
    stop_at(&mut bench, "show", &[11]);
    expect!["show:11"].assert_eq(&stops(&mut bench, 200 * LINE));
}

/// A library with a program in the file `show`.
const LIBRARY: &str = r#"
image part "part.pjx"
file "show"
program public show
    line 11 Line
    Return
end"#;
