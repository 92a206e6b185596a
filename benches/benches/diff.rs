//! Comparison between two backups: `cargo bench --bench diff`.
//!
//! Target on a single core in an ordinary machine: under one second for the comparison, and for the report in each
//! format. The backups contain 10,000 points in 100 frames, which all differ because the frames and the points were
//! moved. Equal files are not read.

#![allow(missing_docs, reason = "benchmarks are named by their functions")]
#![allow(clippy::expect_used, reason = "a benchmark may fail loudly")]

use std::fmt::Write as _;

use divan::{Bencher, black_box};
use val3_diff::format::{html, human, json, markdown};
use val3_diff::report::Detail;
use val3_diff::{Comparison, FileTree, compare};

const FRAMES: usize = 100;
const POINTS: usize = 10_000;

fn main() {
    divan::main();
}

/// Returns a data file in which every frame is moved by `offset` mm, and every point by the same distance.
fn backup(offset: f64) -> FileTree {
    let mut data = String::from("<Database><Datas>");
    data.push_str(&declaration("fTray", "frame", FRAMES));
    for index in 0..FRAMES {
        let father = index.checked_sub(1).map_or("world[0]".to_owned(), |father| format!("fTray[{father}]"));
        let father = if index % 5 == 0 { "world[0]" } else { &father };
        let _ = write!(data, "<Value key=\"{index}\" x=\"{}\" rz=\"30\" fatherId=\"{father}\"/>", offset + 500.0);
    }
    data.push_str("</Data>");
    data.push_str(&declaration("pPick", "pointRx", POINTS));
    for index in 0..POINTS {
        let (x, father) = (offset + index as f64 / 8.0, index % FRAMES);
        let _ = write!(
            data,
            "<Value key=\"{index}\" x=\"{x}\" rx=\"180\" shoulder=\"lefty\" fatherId=\"fTray[{father}]\"/>"
        );
    }
    data.push_str("</Data></Datas></Database>");
    FileTree::new([("cell/cell.dtx", data)])
}

fn declaration(name: &str, ty: &str, size: usize) -> String {
    format!("<Data name=\"{name}\" access=\"private\" xsi:type=\"array\" type=\"{ty}\" size=\"{size}\">")
}

fn compared() -> Comparison {
    compare(&backup(0.0), &backup(0.5))
}

#[divan::bench(sample_count = 10)]
fn moved(bencher: Bencher<'_, '_>) {
    let trees = (backup(0.0), backup(0.5));
    let found = compare(&trees.0, &trees.1);
    assert_eq!(
        found.applications.iter().flat_map(|found| &found.data).map(|data| data.values.len()).sum::<usize>(),
        FRAMES + POINTS
    );
    bencher.bench_local(|| compare(black_box(&trees.0), black_box(&trees.1)));
}

#[divan::bench(sample_count = 10)]
fn same(bencher: Bencher<'_, '_>) {
    let trees = (backup(0.0), backup(0.0));
    bencher.bench_local(|| compare(black_box(&trees.0), black_box(&trees.1)));
}

#[divan::bench(sample_count = 10)]
fn for_people(bencher: Bencher<'_, '_>) {
    let found = compared();
    bencher.bench_local(|| human::lines(black_box(&found), Detail::Full));
}

#[divan::bench(sample_count = 10)]
fn as_json(bencher: Bencher<'_, '_>) {
    let found = compared();
    bencher.bench_local(|| json::write(black_box(&found), Detail::Full).expect("a document"));
}

#[divan::bench(sample_count = 10)]
fn as_markdown(bencher: Bencher<'_, '_>) {
    let found = compared();
    bencher.bench_local(|| markdown::write(black_box(&found), Detail::Full));
}

#[divan::bench(sample_count = 10)]
fn as_html(bencher: Bencher<'_, '_>) {
    let found = compared();
    bencher.bench_local(|| html::write(black_box(&found), Detail::Full));
}
