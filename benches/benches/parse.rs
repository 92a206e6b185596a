//! Parsing without analysis: `cargo bench --bench parse`.
//!
//! Target on a single core in an ordinary machine: 60 MB/s for a workspace's programs. The time is proportional to the
//! text: each row of `one_long_program` has ten times the text of the previous row and shows the same MB/s.

#![allow(missing_docs, reason = "benchmarks are named by their functions")]

use divan::counter::BytesCount;
use divan::{Bencher, black_box};

fn main() {
    divan::main();
}

/// Many files of the usual size.
#[divan::bench(args = ["pgx", "dtx", "pjx"], sample_count = 20)]
fn workspace(bencher: Bencher<'_, '_>, ending: &str) {
    let texts = val3_benches::texts(&val3_benches::generated(20_000), ending);
    let bytes: usize = texts.iter().map(String::len).sum();
    bencher.counter(BytesCount::new(bytes)).bench_local(|| {
        for text in &texts {
            black_box(val3_syntax::parse(black_box(text)));
        }
    });
}

/// One program, ten times longer in each row.
#[divan::bench(args = [10_000, 100_000, 1_000_000, 10_000_000], sample_count = 10)]
fn one_long_program(bencher: Bencher<'_, '_>, bytes: usize) {
    let text = val3_benches::long_program(bytes);
    bencher.counter(BytesCount::new(text.len())).bench_local(|| black_box(val3_syntax::parse(black_box(&text))));
}
