//! Laws of refactorings for programs outside this repository.
//!
//! `VAL3_PROGRAMS=FOLDER cargo test -p val3-tests --test it assists::public -- --ignored --nocapture` applies every
//! assist at 50 random ranges below the folder and prints a table. `VAL3_ASSIST` selects one assist, and `VAL3_DRAWS`
//! is the number of ranges for which assists are requested.

#![allow(clippy::disallowed_methods, reason = "the programs are named by the environment, not by this repository")]

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use camino::Utf8PathBuf;
use val3_analysis::db::FileRange;

use crate::assists::edited_cell::{EditedCell, Files};
use crate::assists::laws::{Laws, Returned, RunStatus, has_inverse};
use crate::assists::places::offering;
use crate::assists::task_names;

/// Number of ranges per assist.
const PLACES: usize = 50;

/// Default of `VAL3_DRAWS`.
const DRAWS: usize = 20_000;

/// Number of printed failures per assist.
const SHOWN: usize = 6;

#[test]
#[ignore = "it needs a folder of programs in VAL3_PROGRAMS"]
fn the_laws_hold_in_public_programs() {
    let folder = std::env::var("VAL3_PROGRAMS").expect("VAL3_PROGRAMS names a folder of VAL 3 programs");
    let mut files = Files::new();
    collect(Path::new(&folder), Path::new(&folder), &mut files);
    let draws = std::env::var("VAL3_DRAWS").ok().map_or(DRAWS, |number| number.parse().unwrap());
    let mut laws = Laws::of(EditedCell::open(files));
    let offering = offering(&laws.cell, draws, PLACES);
    let only = std::env::var("VAL3_ASSIST").ok();
    let chosen = offering.iter().filter(|(id, _)| only.as_ref().is_none_or(|only| only == *id));
    let failed: usize = chosen.map(|(id, places)| report(&mut laws, id, places)).sum();
    let failed = failed + report_tasks(&mut laws);
    assert_eq!(failed, 0, "failures");
}

/// Prints an assist's row and failures, and returns the number of failed ranges.
fn report(laws: &mut Laws, id: &str, places: &[FileRange]) -> usize {
    let outcomes: Vec<(FileRange, RunStatus)> = places.iter().map(|place| (*place, laws.check(id, *place))).collect();
    let failed = outcomes.iter().filter(|(_, status)| !status.failures.is_empty()).count();
    let back = |wanted| outcomes.iter().filter(|(_, status)| status.returned == Some(wanted)).count();
    println!(
        "| {id} | {} places | {failed} failed | returned: {} bytes, {} lines, {} other | findings gone: {} |",
        outcomes.len(),
        back(Returned::Bytes),
        back(Returned::Lines),
        back(Returned::Other),
        gone(&outcomes),
    );
    for (place, status) in outcomes.iter().filter(|(_, status)| !status.failures.is_empty()).take(SHOWN) {
        println!("    {}", shown(&laws.cell, *place));
        status.failures.iter().take(SHOWN).for_each(|failure| println!("        {failure}"));
        status.texts.iter().take(SHOWN).for_each(|text| println!("        edit: {text:?}"));
    }
    let stuck = outcomes.iter().filter(|(_, status)| has_inverse(id) && status.returned.is_none());
    stuck.take(SHOWN).for_each(|(place, _)| println!("    no way back: {}", shown(&laws.cell, *place)));
    failed
}

/// Prints the row of task names, and returns the number of failed names.
fn report_tasks(laws: &mut Laws) -> usize {
    let tasks = task_names::tasks(&laws.cell, PLACES);
    let mut refusals = Vec::new();
    let mut failed = Vec::new();
    for task in &tasks {
        match task_names::there_and_back(&mut laws.cell, &laws.findings, task) {
            Ok(failures) if failures.is_empty() => {}
            Ok(failures) => failed.push(failures),
            Err(refusal) => refusals.push(refusal.0),
        }
    }
    println!("| rename of tasks | {} names | {} refused | {} failed |", tasks.len(), refusals.len(), failed.len());
    refusals.dedup();
    refusals.iter().chain(failed.iter().flatten()).take(SHOWN).for_each(|line| println!("    {line}"));
    failed.len()
}

/// Formats the codes of the removed findings with their numbers.
fn gone(outcomes: &[(FileRange, RunStatus)]) -> String {
    let mut codes: BTreeMap<&str, usize> = BTreeMap::new();
    let removed = outcomes.iter().flat_map(|(_, status)| &status.removed);
    removed.for_each(|finding| *codes.entry(finding.split(' ').next().unwrap_or("")).or_default() += 1);
    codes.into_iter().map(|(code, count)| format!("{code} {count} ")).collect()
}

fn shown(cell: &EditedCell, place: FileRange) -> String {
    let text = place.file.text(cell.db());
    let range = std::ops::Range::<usize>::from(place.range);
    let line = 1 + text[..range.start].matches('\n').count();
    let selected = text[range].lines().next().unwrap_or("");
    format!("{}:{line} {selected}", place.file.path(cell.db()))
}

fn collect(root: &Path, folder: &Path, files: &mut Files) {
    for path in fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
        let inside = path.strip_prefix(root).unwrap().to_str().map(|inside| Utf8PathBuf::from("/").join(inside));
        match inside {
            Some(_) if path.is_dir() => collect(root, &path, files),
            Some(inside) => _ = files.insert(inside, fs::read(&path).unwrap()),
            // The analysis omits such names.
            None => {}
        }
    }
}
