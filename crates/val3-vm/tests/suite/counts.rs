//! Counters of lines and of branch sides.

use std::collections::BTreeSet;

use val3_vm::CycleEnd;

use crate::host::Bench;

/// A loop of three iterations, whose condition has two sides. `start` calls `library` in each iteration.
const LOOP: &str = r#"
image main ""
file "start"
library lib "lib" autoload
import lib add program ()
program start
    frame n3
    nums n1=3, n2=1
    branch 3 "true" 2 "false" 3
    line 1 counter 0 Jump test
again:
    line 2 counter 2 Call import 0 ()
    Add n0 n0 n2
test:
    line 3 counter 1 IfLess n0 n1 again
    side 3
    Line
    line 9 counter 4 Return
    line 10 counter 5 Return
end
"#;

const LIBRARY: &str = r#"
image lib ""
file "add"
program unused
    line 1 counter 0 Return
end
program public add
    frame n1
    line 1 Line
    side 0
    Line
    line 2 counter 1 Return
end
"#;

/// Returns the names of the counted images with their counters.
fn counts(bench: &Bench) -> Vec<(String, Vec<u64>)> {
    bench.vm.space.counts.images().map(|(image, hits)| (image.name.clone(), hits.to_vec())).collect()
}

#[test]
fn lines_and_sides_are_counted_in_applications_and_libraries() {
    let bench = Bench::with_libraries(LOOP, &[LIBRARY]).run();
    let expected = [("main".to_owned(), vec![1, 4, 3, 1, 1, 0]), ("lib".to_owned(), vec![0, 3, 3])];
    assert_eq!(counts(&bench), expected);
}

/// A side uses no line of the budget and no time.
#[test]
fn counters_change_neither_time_nor_turns() {
    let counted = Bench::with_libraries(LOOP, &[LIBRARY]).run();
    let uncounted = Bench::with_libraries(&plain(LOOP), &[&plain(LIBRARY)]).run();
    assert!(counts(&uncounted).is_empty());
    assert_eq!(counted.schedule.now, uncounted.schedule.now);
    assert_eq!((counted.host.record, counted.host.changes), (uncounted.host.record, uncounted.host.changes));
}

/// The text of an image without its counters.
fn plain(text: &str) -> String {
    let mut words = text.split_whitespace();
    let mut kept = Vec::new();
    while let Some(word) = words.next() {
        if word == "counter" {
            words.next();
        } else {
            kept.push(word);
        }
    }
    kept.join(" ").replace("side 3 Line", "").replace("side 0 Line", "")
}

#[test]
fn a_copy_of_the_machine_keeps_its_own_counters() {
    let mut bench = Bench::with_libraries(LOOP, &[LIBRARY]);
    let initial = bench.vm.clone();
    let bench_after = {
        while !matches!(bench.cycle(), CycleEnd::Waiting(_)) {
            assert!(bench.schedule.now < 1_000_000_000);
        }
        bench
    };
    assert_eq!(counts(&bench_after)[0].1, [1, 4, 3, 1, 1, 0]);
    let before = Bench { vm: initial, ..bench_after };
    assert_eq!(counts(&before)[0].1, [0; 6]);
}

/// A stop replaces only the mark on its line.
#[test]
fn other_lines_of_a_file_with_stops_are_counted() {
    let mut bench = Bench::with_libraries(LOOP, &[LIBRARY]);
    bench.vm.set_stops("start", BTreeSet::from([9]));
    bench.vm.set_stops("start", BTreeSet::new());
    let counted = bench.run();
    // The stop was set after loading, so the image's counters remain.
    assert_eq!(counts(&counted)[0].1, [1, 4, 3, 1, 0, 0]);
}
