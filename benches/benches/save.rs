//! Speed of `libSave`: `cargo bench --bench save`.
//!
//! Target: the time per value does not depend on the number of values.

#![allow(missing_docs, reason = "benchmarks are named by their functions")]
#![allow(clippy::unwrap_used, reason = "numbers that cannot be saved measure nothing")]

use divan::Bencher;
use divan::counter::ItemsCount;
use val3_data::{SavedContainer, SavedContent, SavedData, SavedValue};
use val3_machine::files::{LibraryFile, LibraryFiles};

const COUNTS: [u32; 3] = [1_000, 8_000, 64_000];

fn main() {
    divan::main();
}

/// Every value differs from the file.
#[divan::bench(args = COUNTS)]
fn changed(bencher: Bencher<'_, '_>, count: u32) {
    let files = library(count, count);
    bencher.counter(ItemsCount::new(count)).bench_local(|| files.with_data(&[numbers(count)]).unwrap());
}

/// Every second value is not in the file yet.
#[divan::bench(args = COUNTS)]
fn added(bencher: Bencher<'_, '_>, count: u32) {
    let files = library(count, count / 2);
    bencher.counter(ItemsCount::new(count)).bench_local(|| files.with_data(&[numbers(count)]).unwrap());
}

/// Returns the data file for an array with `count` numbers, of which the first `written` have a value.
fn library(count: u32, written: u32) -> LibraryFiles {
    let values: String =
        (0..written).map(|index| format!("      <Value key=\"{index}\" value=\"{}\" />\n", index + 1)).collect();
    let text = format!(
        "<?xml version=\"1.0\" encoding=\"utf-8\" ?>\n<Database>\n  <Datas>\n    <Data name=\"nList\" \
         access=\"public\" xsi:type=\"array\" type=\"num\" size=\"{count}\">\n{values}    </Data>\n  </Datas>\n\
         </Database>\n"
    );
    LibraryFiles { files: vec![LibraryFile { path: "main.dtx".into(), bytes: text.into_bytes() }], encrypted: false }
}

fn numbers(count: u32) -> SavedData {
    SavedData {
        name: "nList".into(),
        type_name: "num".into(),
        shape: SavedContainer::Sizes(vec![count]),
        values: (0..count).map(value).collect(),
        is_part: false,
    }
}

fn value(index: u32) -> SavedValue {
    let content = SavedContent::Attributes(vec![("value".into(), (index + 2).to_string())]);
    SavedValue { key: index.to_string(), content }
}
