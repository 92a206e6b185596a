//! Quality of completion: each name in the code of the example cell is reduced to its first letters and completed.

#![allow(clippy::unwrap_used, clippy::indexing_slicing, clippy::string_slice, reason = "a test may fail loudly")]

use std::sync::Arc;

use camino::Utf8PathBuf;
use salsa::Setter;
use val3_analysis::db::{Database, File, Sources};
use val3_analysis::items::project::program_files;
use val3_analysis::load::load;
use val3_analysis::occurrences::{Usage, occurrences};
use val3_analysis::system::Memory;
use val3_ide::{FilePosition, completions, owner};
use val3_syntax::{TextRange, TextSize};
use val3_tests::cell;

fn open() -> Database {
    let files = cell::files("palletiser").into_iter();
    let system = Memory::new(files.map(|(path, bytes)| (Utf8PathBuf::from("/").join(path), bytes)));
    load(&system, &[Utf8PathBuf::from("/")]).unwrap().db
}

/// Returns the names in the code, with their locations.
fn names(db: &Database) -> Vec<(File, TextRange, String)> {
    let mut files: Vec<File> = Sources::get(db).files(db).values().copied().collect();
    files.sort_by_key(|file| file.path(db).clone());
    let mut names = Vec::new();
    for file in files {
        let Some(project) = owner(db, file).filter(|project| program_files(db, *project).contains(&file)) else {
            continue;
        };
        let text = file.text(db);
        let code = text.find("begin").unwrap_or(0);
        for name in occurrences(db, project, file) {
            let range = std::ops::Range::<usize>::from(name.range);
            if name.usage != Usage::Declaration && range.start > code && !text[..range.start].ends_with('"') {
                names.push((file, name.range, text[range].to_owned()));
            }
        }
    }
    names
}

/// Returns the number of names among the first `top` completions after `letters` letters, and the names that are not
/// among them.
fn found(letters: usize, top: usize) -> (usize, Vec<String>) {
    let mut db = open();
    let (mut hits, mut misses) = (0, Vec::new());
    for (file, range, name) in names(&db) {
        let text = Arc::clone(file.text(&db));
        let kept = name.len().min(letters);
        let written = usize::from(range.start()) + kept;
        let broken = format!("{} {}", &text[..written], &text[usize::from(range.end())..]);
        file.set_text(&mut db).to(Arc::from(broken));
        let at = FilePosition { file, offset: TextSize::try_from(written).unwrap() };
        let offered = completions(&db, at);
        if offered.iter().take(top).any(|item| item.label == name) {
            hits += 1;
        } else {
            let first: Vec<&str> = offered.iter().take(3).map(|item| item.label.as_str()).collect();
            let line = text[..usize::from(range.end())].rsplit('\n').next().unwrap_or("").trim();
            misses.push(format!("{}: {line} {first:?}", file.path(&db).file_name().unwrap_or("")));
        }
        file.set_text(&mut db).to(text);
    }
    (hits, misses)
}

#[test]
fn one_letter_brings_a_name_into_the_first_ten() {
    let (hits, misses) = found(1, 10);
    assert!(hits > 400 && misses.len() * 20 < hits, "{hits} found, {} not: {misses:#?}", misses.len());
}

#[test]
fn two_letters_bring_a_name_into_the_first_three() {
    let (hits, misses) = found(2, 3);
    assert!(hits > 400 && misses.len() * 20 < hits, "{hits} found, {} not: {misses:#?}", misses.len());
}

#[test]
fn every_name_is_proposed_somewhere() {
    let (_, misses) = found(0, usize::MAX);
    assert!(misses.is_empty(), "{misses:#?}");
}
