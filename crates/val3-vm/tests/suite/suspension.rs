//! Turns and cycles that stop and resume: budgets, interrupts, limits.

use val3_vm::{CycleEnd, Grant, TaskState, TurnEnd};

use crate::host::{Bench, LINE};

/// Counts in `$nCount` without an end, in one-line steps.
const COUNT: &str = r#"
data nCount num[1]
program start
    frame n2
    nums n1=1
again:
    line 1 LoadFirst n0 $nCount 0 Add n0 n0 n1 StoreFirst $nCount 0 n0 Jump again
end
"#;

fn count(bench: &Bench) -> f64 {
    let instance = bench.vm.space.instance(val3_vm::InstanceId(0)).unwrap();
    let place = val3_lang::memory::Place::first(instance.data[0]);
    bench.vm.space.memory.num(place, 0).unwrap()
}

fn turn(bench: &mut Bench, lines: u32) -> val3_vm::TurnReport {
    bench.vm.turn(bench.start, Grant::once(lines), 0, LINE, &mut bench.host)
}

#[test]
fn a_turn_executes_the_lines_of_its_grant() {
    let mut bench = Bench::new(COUNT);
    let report = turn(&mut bench, 7);
    assert_eq!((report.end, report.lines, report.left), (TurnEnd::Busy, 7, 0));
    assert_eq!(count(&bench), 7.0);
}

#[test]
fn a_turn_resumes_after_the_last_line_of_the_previous_one() {
    let mut bench = Bench::new(COUNT);
    for lines in [1, 2, 3, 0, 4] {
        assert_eq!(turn(&mut bench, lines).lines, lines);
    }
    assert_eq!(count(&bench), 10.0);
}

#[test]
fn a_turn_ends_with_the_program() {
    let mut bench = Bench::new("program start\nline 1 Line\nline 2 Return\nend");
    let report = turn(&mut bench, 10);
    assert_eq!((report.end, report.lines), (TurnEnd::Finished, 2));
    assert!(bench.vm.tasks().is_empty());
}

#[test]
fn a_turn_ends_with_an_error_that_the_task_keeps() {
    let mut bench = Bench::new("program start\nframe n2\nline 1 Line\nline 4 Divide n0 n0 n1\nReturn\nend");
    let report = turn(&mut bench, 10);
    assert_eq!((report.end, report.lines), (TurnEnd::Failed(val3_lang::fault::Fault(10)), 2));
    assert_eq!(bench.vm.tasks()[0].state, TaskState::Failed(val3_lang::fault::Fault(10)));
    assert_eq!(bench.host.record, "error 10 at row 4\n");
}

#[test]
fn a_turn_that_waits_reports_the_time_of_its_end() {
    let mut bench = Bench::new("program start\nframe n1\nnums n0=0.5\nline 1 Instruction delay (num n0)\nReturn\nend");
    let report = turn(&mut bench, 10);
    assert_eq!((report.end, report.lines), (TurnEnd::Waiting(Some(LINE + 500_000_000)), 1));
}

#[test]
fn a_turn_stops_at_an_instruction_that_the_controller_lacks() {
    let mut bench = Bench::new("program start\nline 1 Line\nline 2 Instruction lacking \"odd\" ()\nReturn\nend");
    assert_eq!(turn(&mut bench, 10).end, TurnEnd::Unsupported);
    assert_eq!(bench.host.record, "no odd\n");
}

#[test]
fn a_cycle_lasts_4_ms() {
    let mut bench = Bench::new(COUNT);
    assert_eq!(bench.cycle(), CycleEnd::Busy);
    assert_eq!((count(&bench), bench.schedule.now), (2000.0, 4_000_000));
}

#[test]
fn a_cycle_stops_at_the_limit_and_resumes_with_a_later_one() {
    let mut bench = Bench::new(COUNT);
    bench.schedule.limit = Some(100 * LINE);
    assert_eq!((bench.cycle(), count(&bench)), (CycleEnd::Limit, 100.0));
    assert!(bench.schedule.is_within_cycle());
    bench.schedule.limit = None;
    assert_eq!((bench.cycle(), count(&bench)), (CycleEnd::Busy, 2000.0));
    assert!(!bench.schedule.is_within_cycle());
}

/// Prints numbers from 1 on, three in a line.
const PRINT: &str = r#"
program print
    frame n2
    nums n1=1
again:
    line 1
    Add n0 n0 n1 Instruction print (num n0)
    Add n0 n0 n1 Instruction print (num n0)
    Add n0 n0 n1 Instruction print (num n0)
    Jump again
end
program start
    frame n1
    nums n0=5
    line 1 CreateTask "a" n0 print ()
    line 2 CreateTask "b" n0 print ()
    Return
end
"#;

#[test]
fn an_interrupted_turn_stops_after_the_current_instruction() {
    let mut bench = Bench::new(PRINT);
    bench.schedule.limit = Some(4 * LINE);
    assert_eq!(bench.cycle(), CycleEnd::Limit);
    bench.host.record.clear();
    bench.schedule.limit = None;
    bench.host.is_interrupted = true;
    for _ in 0..3 {
        assert_eq!(bench.cycle(), CycleEnd::Suspended);
    }
    assert_eq!(bench.host.record.lines().count(), 3);
}

#[test]
fn a_cycle_that_was_interrupted_executes_the_same_operations() {
    let whole = {
        let mut bench = Bench::new(PRINT);
        (bench.cycle(), bench.host.record)
    };
    let mut bench = Bench::new(PRINT);
    for round in 0u64.. {
        bench.host.is_interrupted = round % 3 != 0;
        bench.schedule.limit = (round % 5 == 0).then(|| bench.schedule.now + LINE * (round % 7));
        let outcome = bench.cycle();
        if !bench.schedule.is_within_cycle() {
            assert_eq!((outcome, bench.host.record), whole);
            return;
        }
    }
}
