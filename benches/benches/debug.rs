//! Debugging: `cargo bench --bench debug`.
//!
//! Targets: a step in under 5 ms, a step back after 10 million lines in under 100 ms, and 1,000 breakpoints that no
//! task reaches slow a run of a million lines by less than 5 %. A condition in a loop costs microseconds per hit, and
//! an expression is evaluated in under 5 ms.

#![allow(missing_docs, reason = "benchmarks are named by their functions")]
#![allow(clippy::expect_used, clippy::panic, reason = "an application that fails measures nothing")]

use divan::Bencher;
use val3_debug::{AdvanceResult, Breakpoint, BreakpointId, Debugger, DisplayFormat, PastLimits, StepKind, Stop};
use val3_lang::ports::TaskNumber;
use val3_session::{FrameEvaluator, Purpose};
use val3_tests::running::{Running, application};
use val3_vm::FragmentContext;

/// Lines that a program never executes.
const UNUSED: &str = "  while nEnd<0\n    nEnd=nEnd+1\n  endWhile\n";

fn main() {
    divan::main();
}

/// Starts an application that counts for some millions of lines.
fn counting() -> Debugger {
    Debugger::new(Running::start(&listing()).controller)
}

fn listing() -> String {
    let unused = UNUSED.repeat(1000);
    format!("num nEnd\nprogram start()\nnum l_n\nbegin\n  while true\n    l_n=l_n+1\n  endWhile\n{unused}end\n")
}

fn run_lines(debugger: &mut Debugger, lines: u64) {
    let end = debugger.controller.now() + lines * 2000;
    while debugger.controller.now() < end {
        if let AdvanceResult::Stopped(stop) = debugger.advance() {
            panic!("nothing stops the run: {stop:?}");
        }
    }
}

fn step(debugger: &mut Debugger, task: TaskNumber) -> Stop {
    debugger.step(task, StepKind::Over);
    loop {
        if let AdvanceResult::Stopped(stop) = debugger.advance() {
            return stop;
        }
    }
}

fn task(debugger: &Debugger) -> TaskNumber {
    debugger.controller.vm.tasks().first().expect("a task").id
}

#[divan::bench]
fn one_step(bencher: Bencher<'_, '_>) {
    let mut debugger = counting();
    let task = task(&debugger);
    bencher.bench_local(|| step(&mut debugger, task));
}

#[divan::bench(args = [0, 1000], sample_count = 10, sample_size = 1)]
fn a_million_lines_with_breakpoints(bencher: Bencher<'_, '_>, count: u32) {
    let mut debugger = counting();
    let (_, application) = debugger.controller.vm.space.loaded().next().expect("an application");
    let image = &application.image;
    let program = image.programs.first().expect("a program");
    let file = image.files.get(program.file as usize).expect("a file").clone();
    let rows = program.lines.iter().skip(4).map(|line| line.row);
    let breakpoint = |(id, row)| Breakpoint::new(BreakpointId(id), row);
    let breakpoints: Vec<_> = (0..count).zip(rows).map(breakpoint).collect();
    debugger.set_breakpoints(&file, breakpoints);
    bencher.bench_local(|| run_lines(&mut debugger, 1_000_000));
}

#[divan::bench(sample_count = 10, sample_size = 1)]
fn a_million_lines_with_a_past(bencher: Bencher<'_, '_>) {
    let mut debugger = counting();
    debugger.record(PastLimits::snapshots(200));
    bencher.bench_local(|| run_lines(&mut debugger, 1_000_000));
}

#[divan::bench(sample_count = 10, sample_size = 1)]
fn a_line_back_after_ten_million(bencher: Bencher<'_, '_>) {
    let mut debugger = counting();
    debugger.record(PastLimits::snapshots(200));
    run_lines(&mut debugger, 10_000_000);
    let task = task(&debugger);
    bencher.bench_local(|| debugger.step_back(task, StepKind::Over));
}

/// Every second line is a hit.
#[divan::bench(sample_count = 10, sample_size = 1)]
fn hits_of_a_condition_50_000(bencher: Bencher<'_, '_>) {
    let mut debugger = counting();
    let mut evaluator = FrameEvaluator::new(application(&listing()));
    let (_, instance) = debugger.controller.vm.space.loaded().next().expect("an application");
    let program = instance.image.programs.first().expect("a program");
    let (file, row) =
        (instance.image.files.first().expect("a file").clone(), program.lines.get(1).expect("a line").row);
    let condition = evaluator.condition(&debugger.controller.vm, &file, "l_n<0 and nEnd==0").expect("a condition");
    let breakpoint = Breakpoint { condition: Some(condition), ..Breakpoint::new(BreakpointId(0), row) };
    debugger.set_breakpoints(&file, vec![breakpoint]);
    bencher.bench_local(|| run_lines(&mut debugger, 100_000));
}

/// The text differs each time, so that it is compiled again.
#[divan::bench]
fn an_expression(bencher: Bencher<'_, '_>) {
    let mut debugger = counting();
    run_lines(&mut debugger, 1000);
    let mut evaluator = FrameEvaluator::new(application(&listing()));
    let (context, mut number) = (FragmentContext::Frame(task(&debugger), 0), 0);
    bencher.bench_local(|| {
        number += 1;
        let text = format!("l_n+{number}");
        evaluator.evaluate(&mut debugger.controller, context, &text, Purpose::Watch, DisplayFormat::default())
    });
}
