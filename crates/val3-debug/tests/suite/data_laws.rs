//! Laws of data breakpoints, on random programs of several tasks.

use proptest::collection::vec;
use proptest::prelude::*;
use val3_debug::{Debugger, PastLimits, Stop};

use crate::data::{change, state, watch};
use crate::debugger::{debugger, run};

/// Data that the interpreter compares itself.
const PLAIN: [&str; 8] = ["nCount", "nGrid[1,0]", "nGrid", "sName", "l_nSum", "trPart.x", "pPart", "fPart"];

/// A collection that no program changes. The interpreter does not compare collections, so tasks execute one line at a
/// time while one is watched.
const UNCHANGED: &str = "cUnused";

fn statement() -> impl Strategy<Value = String> {
    prop_oneof![
        (0..4).prop_map(|n| format!("nCount=nCount*{n}-1")),
        (0..2, 0..2).prop_map(|(i, j)| format!("nGrid[{i},{j}]=nGrid[{j},{i}]+nCount")),
        (0..3).prop_map(|n| format!("sName=sName+\"{n}\"")),
        (0..3).prop_map(|n| format!("sName=\"{n}\"")),
        (0..3).prop_map(|n| format!("l_nSum=l_nSum+{n}")),
        (0..3).prop_map(|n| format!("trPart.x=trPart.x+{n}")),
        (0..3).prop_map(|n| format!("pPart.trsf.y=pPart.trsf.y+{n}")),
        (0..3).prop_map(|n| format!("fPart.trsf.z={n}")),
        Just("link(pPart,fPart)".to_owned()),
        Just("link(pPart,world)".to_owned()),
        Just("call add(nCount)".to_owned()),
        Just("call add(l_nSum)".to_owned()),
        Just("call add(nGrid[1,0])".to_owned()),
        (0..9).prop_map(|n| format!("delay(0.00{n})")),
        Just("wait(nCount<100)".to_owned()),
        (1..4).prop_map(|n| format!("for l_nSum=1 to {n}\n nCount=nCount+1\nendFor")),
        Just("if nCount>3\nnCount=0\nelse\nl_nSum=nCount\nendIf".to_owned()),
        Just("nCount=nCount/l_nSum".to_owned()),
    ]
}

fn listing(start: &[String], other: &[String], period: Option<u32>) -> String {
    let create = match period {
        None => "taskCreate \"other\",10,other()".to_owned(),
        Some(cycles) => format!("taskCreateSync \"other\",{},bLate,other()", f64::from(cycles) * 0.004),
    };
    let (start, other) = (start.join("\n"), other.join("\n"));
    format!(
        "num nCount\nnum nGrid[2,2]\nstring sName\ntrsf trPart\npoint pPart\nframe fPart\nbool bLate\nnum cUnused[\"\"]\nprogram start()\nnum l_nSum\n\
         begin\n{create}\n{start}\nend\nprogram add(num& x_nTotal)\nbegin\nx_nTotal=x_nTotal+1\nend\n\
         program other()\nnum l_nSum\nbegin\n{other}\nend\n"
    )
}

/// Stop with its moment, and the state of the run.
type Stopped = (String, String);

/// Runs to the end, and returns the stops.
fn stops(listing: &str, paths: &[(&str, Option<&str>)]) -> (Vec<Stopped>, Debugger) {
    let mut debugger = debugger(listing);
    debugger.record(PastLimits::snapshots(1000));
    watch(&mut debugger, paths);
    let mut all = Vec::new();
    while let Some(stop) = run(&mut debugger) {
        all.push((change(&debugger, &stop), state(&debugger.controller)));
    }
    (all, debugger)
}

/// Runs back to the beginning, and returns the stops in chronological order.
fn stops_back(debugger: &mut Debugger) -> Vec<Stopped> {
    let mut all = Vec::new();
    loop {
        let stop = debugger.run_back();
        if stop == Stop::Beginning {
            break;
        }
        all.push((change(debugger, &stop), state(&debugger.controller)));
    }
    all.reverse();
    all
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// Stops are the same whether the interpreter compares the values or tasks execute one line at a time, forwards and
    /// backwards.
    #[test]
    fn stops_are_those_of_single_lines(
        start in vec(statement(), 1..12),
        other in vec(statement(), 1..8),
        period in prop::option::of(1u32..4),
        path in prop::sample::select(&PLAIN),
    ) {
        let listing = listing(&start, &other, period);
        let (plain, mut debugger) = stops(&listing, &[(path, None)]);
        let (lines, _) = stops(&listing, &[(path, None), (UNCHANGED, None)]);
        prop_assert!(plain == lines, "forwards: {listing}");
        prop_assert!(stops_back(&mut debugger) == plain, "backwards: {listing}");
    }
}
