//! Compares `docs/fidelity.md` with the catalogue: each manual section lists its instructions, all of which are
//! implemented, and every test that it names exists.

#![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "a test may fail loudly")]

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use val3_lang::instruction::{Availability, Instruction};
use val3_lang::{instructions, keywords};

const PAGE: &str = include_str!("../../../docs/fidelity.md");

/// Cells of the table rows: sections, contents, "kept by".
fn rows() -> Vec<[&'static str; 3]> {
    let (_, table) = PAGE.split_once("### Section by section").unwrap();
    let table = table.split("\n### ").next().unwrap();
    let lines = table.lines().filter(|line| line.starts_with("| ")).skip(1);
    lines
        .map(|line| line.trim_matches('|').split(" |").map(str::trim).collect::<Vec<_>>().try_into().unwrap())
        .collect()
}

/// Texts in backticks.
fn quoted(cell: &'static str) -> impl Iterator<Item = &'static str> {
    cell.split('`').skip(1).step_by(2)
}

/// Pairs of section and instruction that the page lists; other texts in backticks are operators.
fn listed() -> BTreeSet<(&'static str, &'static str)> {
    let mut listed = BTreeSet::new();
    for [sections, texts, _] in rows() {
        let names: Vec<_> = quoted(texts).filter(|text| text.chars().all(char::is_alphanumeric)).collect();
        listed.extend(sections.split(", ").flat_map(|section| names.iter().map(move |name| (section, *name))));
    }
    listed
}

/// Whether the instruction is implemented. The compiler converts `wait`, `watch` and task creation to operations.
fn runs(row: &Instruction) -> bool {
    let is_compiled = keywords::is_task_creation(row.name) || ["wait", "watch"].contains(&row.name);
    is_compiled || row.overloads.iter().all(|form| form.run.is_some())
}

fn of_the_manual() -> impl Iterator<Item = &'static Instruction> {
    instructions::all().iter().copied().filter(|row| row.availability == Availability::Manual)
}

#[test]
fn every_instruction_is_listed_in_its_sections() {
    let catalogue: BTreeSet<_> =
        of_the_manual().flat_map(|row| row.section.split(", ").map(|section| (section, row.name))).collect();
    let page = listed();
    let missing: Vec<_> = catalogue.difference(&page).collect();
    let unknown: Vec<_> = page.difference(&catalogue).collect();
    assert!(missing.is_empty() && unknown.is_empty(), "missing: {missing:#?}\nunknown: {unknown:#?}");
    assert!(of_the_manual().all(runs));
}

/// Ensures that the test above does not pass because nothing was read.
#[test]
fn the_page_is_read() {
    assert!(listed().len() > 120 && listed().contains(&("3.2.3", "sin")) && listed().contains(&("9.7.6", "config")));
}

#[test]
fn paths_named_by_a_section_exist() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut kept: BTreeMap<&str, usize> = BTreeMap::new();
    for [section, there, by] in rows() {
        for path in quoted(by) {
            assert!(root.join(path).exists(), "{section}: no {path}");
        }
        kept.insert(section, by.len());
        assert_eq!(there.is_empty(), by.is_empty(), "{section}");
    }
    assert!(kept.len() > 25);
}
