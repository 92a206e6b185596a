//! The list of decisions contains every page, in order and under its title.

#![allow(clippy::unwrap_used, reason = "a test may fail loudly")]

use std::fs;

use camino::Utf8Path;

/// Returns the numbers, files and titles of all pages.
fn pages() -> Vec<(usize, String, String)> {
    let folder = xtask::project::root().join("docs/adr");
    let names = folder.read_dir_utf8().unwrap().map(|entry| entry.unwrap().file_name().to_owned());
    let mut names: Vec<_> = names.filter(|name| name != "README.md").collect();
    names.sort();
    names.into_iter().map(|name| page(&folder, name)).collect()
}

fn page(folder: &Utf8Path, name: String) -> (usize, String, String) {
    let text = fs::read_to_string(folder.join(&name)).unwrap();
    let title = text.lines().next().unwrap().strip_prefix("# ").unwrap();
    let (number, title) = title.split_once(". ").unwrap();
    assert!(name.starts_with(&format!("{number:0>4}-")), "{name}: {number}");
    (number.parse().unwrap(), name, title.to_owned())
}

#[test]
fn numbers_have_no_gap() {
    let numbers: Vec<_> = pages().into_iter().map(|(number, ..)| number).collect();
    assert_eq!(numbers, (1..=numbers.len()).collect::<Vec<_>>());
}

#[test]
fn every_page_is_listed_in_order() {
    let list = xtask::project::read("docs/adr/README.md").unwrap();
    let rows: Vec<_> = list.lines().filter(|line| line.contains("](")).collect();
    let pages = pages();
    assert_eq!(rows.len(), pages.len());
    for (row, (number, file, title)) in rows.iter().zip(pages) {
        assert!(row.starts_with(&format!("| {number} | [{title}]({file}) | ")), "{row}");
    }
}
