//! Laws of data breakpoints: a run forwards, a run back and the recorded writes report the same changes of a variable of
//! one call, on random programs, and of an input, with random scripts.

use std::ops::ControlFlow;

use proptest::collection::vec;
use proptest::prelude::*;
use val3_debug::{DataAccess, Debugger, PastLimits, Stop, WatchedData, WriteLimits};
use val3_machine::script::Script;
use val3_vm::FragmentContext;

use crate::data::{watch_in, with_signals};
use crate::debugger::{debugger, run, set, task_of};

const DATA: [&str; 7] = ["l_n", "l_s", "l_nList[1]", "x_n", "x_nAny", "nCount", "l_cAny"];

/// A statement of the called program, which calls itself at most twice.
fn statement() -> impl Strategy<Value = String> {
    prop_oneof![
        (0..3).prop_map(|n| format!("l_n=l_n+{n}")),
        (0..3).prop_map(|n| format!("l_s=l_s+\"{n}\"")),
        (0..3).prop_map(|n| format!("l_nList[1]={n}")),
        (0..3).prop_map(|n| format!("x_n=x_n+{n}")),
        (0..3).prop_map(|n| format!("x_nAny=x_nAny+{n}")),
        (0..3).prop_map(|n| format!("nCount=nCount-{n}")),
        Just("insert(l_cAny[toString(\"\",l_n)])".to_owned()),
        (0..9).prop_map(|n| format!("delay(0.00{n})")),
        Just("delay(0.2)".to_owned()),
        Just("if nDepth<2\ncall work(l_n,l_n)\nendIf".to_owned()),
        Just("for l_n=1 to 2\nnCount=nCount+1\nendFor".to_owned()),
        Just("if l_n>1\nreturn\nendIf".to_owned()),
    ]
}

fn listing(work: &[String], calls: u32, has_other: bool) -> String {
    let work = work.join("\n");
    let other = if has_other { "taskCreate \"other\",10,other()" } else { "nOwn=0" };
    format!(
        "num nCount\nnum nOwn\nnum nDepth\nprogram start()\nnum l_n\nbegin\n{other}\nfor l_n=1 to {calls}\n\
         call work(l_n,nOwn)\nendFor\nend\nprogram work(num x_n, num& x_nAny)\nnum l_n\nstring l_s\nnum l_nList[2]\n\
         num l_cAny[\"\"]\nbegin\nnDepth=nDepth+1\n{work}\nnDepth=nDepth-1\nend\n\
         program other()\nbegin\ncall work(1,nCount)\ndelay(0.1)\ncall work(2,nCount)\nend\n"
    )
}

/// A change: time, line in the program, new value.
type Change = (u64, Option<u32>, String);

fn stops(debugger: &mut Debugger, mut next: impl FnMut(&mut Debugger) -> Option<Stop>) -> Vec<Change> {
    let mut all = Vec::new();
    while let Some(stop) = next(debugger) {
        if let Stop::Data(stop) = stop {
            let row = stop.line.as_ref().map(|line| line.row);
            all.push((debugger.controller.now(), row, stop.changes[0].new.clone()));
        }
    }
    all
}

fn back(debugger: &mut Debugger) -> Option<Stop> {
    Some(debugger.run_back()).filter(|stop| *stop != Stop::Beginning)
}

/// Recorded writes, in chronological order.
fn writes(debugger: &mut Debugger, data: &WatchedData) -> Vec<Change> {
    let found = debugger.writes(data, WriteLimits::writes(1000), &mut |_| ControlFlow::Continue(())).unwrap();
    let changes = found.writes.into_iter().map(|write| (write.time, write.line.map(|line| line.row), write.value));
    changes.rev().collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]

    #[test]
    fn the_changes_of_a_call_are_the_same_in_both_directions(
        work in vec(statement(), 1..9),
        calls in 1u32..4,
        has_other: bool,
        hit in 1u32..5,
        line in 1u32..4,
        snapshots in prop::sample::select(&[3usize, 20, 1000]),
        path in prop::sample::select(&DATA),
    ) {
        let listing = listing(&work, calls, has_other);
        let mut debugger = debugger(&listing);
        debugger.record(PastLimits::snapshots(snapshots));
        set(&mut debugger, "work", &[(line, Some(&hit.to_string()))]);
        let Some(task) = run(&mut debugger).as_ref().and_then(task_of) else { return Ok(()) };
        set(&mut debugger, "work", &[]);
        let context = FragmentContext::Frame(task, 0);
        let Ok(data) = WatchedData::new(&mut debugger.controller, context, path) else { return Ok(()) };
        watch_in(&mut debugger, task, path);

        let mut recorded = writes(&mut debugger, &data);
        let forwards = stops(&mut debugger, |debugger| {
            let stop = run(debugger);
            if stop.is_some() {
                recorded = writes(debugger, &data);
            }
            stop
        });
        let backwards = { let mut all = stops(&mut debugger, back); all.reverse(); all };
        prop_assert!(backwards.ends_with(&forwards), "{listing}\n{forwards:?}\n{backwards:?}");
        prop_assert_eq!(&backwards, &recorded, "history: {}", listing);
        let again = stops(&mut debugger, run);
        prop_assert_eq!(&again, &recorded, "forwards again: {}", listing);
    }

    /// An input changes before the first line of a cycle, so its changes have no line.
    #[test]
    fn the_changes_of_an_input_are_the_same_in_both_directions(
        mut times in vec(0u32..300, 1..8),
        delay in 0u32..12,
        snapshots in prop::sample::select(&[3usize, 1000]),
    ) {
        times.sort_unstable();
        let entry = |(number, time): (usize, &u32)| {
            format!("[[at]]\nt = {}\nio = {{ \"Io\\\\start\" = {} }}\n", f64::from(*time) / 1000.0, number % 2 == 0)
        };
        let script: String = times.iter().enumerate().map(entry).collect();
        let listing = format!(
            "num nCount\nprogram start()\nbegin\nwhile nCount<40\ndelay(0.0{delay:02})\nnCount=nCount+1\nendWhile\nend\n"
        );
        let mut debugger = with_signals(&listing, "Io\\start", DataAccess::Write);
        debugger.controller.follow(Script::parse(&script).unwrap());
        debugger.record(PastLimits::snapshots(snapshots));
        let input = WatchedData::signal(&debugger.controller, "Io\\start").unwrap();
        let forwards = stops(&mut debugger, run);
        prop_assert!(forwards.iter().all(|(_, row, _)| row.is_none()), "{forwards:?}");
        let recorded = writes(&mut debugger, &input);
        prop_assert_eq!(&forwards, &recorded, "history: {} {}", script, listing);
        let mut backwards = stops(&mut debugger, back);
        backwards.reverse();
        prop_assert_eq!(&backwards, &forwards, "backwards: {} {}", script, listing);
    }
}
