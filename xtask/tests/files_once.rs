//! Only `val3-files` reads and writes files, so that each file has a size limit and is replaced completely.
//!
//! clippy's list of forbidden functions cannot check this: `val3` and `val3-lsp`, which read most files, may use the
//! clock and threads in the same list, and the tests of all crates prepare files.

#![allow(clippy::unwrap_used, reason = "a test may fail loudly")]

use camino::{Utf8Path, Utf8PathBuf};

/// Functions and types of the standard library that open files.
const FORBIDDEN: &[&str] = &[
    "fs::read",
    "fs::read_to_string",
    "fs::write",
    "fs::rename",
    "fs::copy",
    "File::open",
    "File::create",
    "File::create_new",
    "File::options",
    "OpenOptions",
    "NamedTempFile",
];

/// The crate itself, tools of the project, and the media and serial lines of running programs.
const EXCEPTIONS: &[&str] = &[
    "val3-files/src",
    "val3-generate/src",
    "val3-test/src",
    "val3-machine/src/files",
    "val3-machine/src/sio/serial.rs",
];

#[test]
fn files_are_opened_in_one_crate() {
    let crates = xtask::project::root().join("crates");
    let is_exception = |path: &Utf8Path| EXCEPTIONS.iter().any(|exception| path.starts_with(crates.join(exception)));
    let sources = sources(&crates);
    assert!(sources.len() > 500, "{}", sources.len());
    for path in sources.iter().filter(|path| !is_exception(path)) {
        let source = std::fs::read_to_string(path).unwrap();
        let code = source.split("#[cfg(test)]").next().unwrap_or_default();
        let code = code.split("#[cfg(all(test,").next().unwrap_or_default();
        let found: Vec<_> = FORBIDDEN.iter().filter(|name| has_word(code, name)).collect();
        assert!(found.is_empty(), "{path} opens files without val3-files: {found:?}");
    }
}

/// Whether a text contains a path of names that is not a part of a longer one.
fn has_word(text: &str, word: &str) -> bool {
    text.match_indices(word).any(|(at, _)| {
        let (before, after) = (text[..at].chars().next_back(), text[at + word.len()..].chars().next());
        !before.is_some_and(is_part_of_name) && !after.is_some_and(is_part_of_name)
    })
}

fn is_part_of_name(character: char) -> bool {
    character.is_alphanumeric() || character == '_'
}

#[test]
fn words_are_not_parts_of_others() {
    assert!(has_word("std::fs::read(path)", "fs::read") && has_word("map(File::create)", "File::create"));
    assert!(!has_word("fs::read_dir(path)", "fs::read") && !has_word("LogFile::open(path)", "File::open"));
}

/// Returns the sources of all crates, without their tests.
fn sources(folder: &Utf8Path) -> Vec<Utf8PathBuf> {
    let entries = folder.read_dir_utf8().unwrap().map(|entry| entry.unwrap().into_path());
    let entries = entries.filter(|path| !matches!(path.file_stem(), Some("tests" | "benches")));
    let (folders, files): (Vec<_>, Vec<_>) = entries.partition(|path| path.is_dir());
    let nested = folders.iter().flat_map(|folder| sources(folder));
    nested.chain(files.into_iter().filter(|path| path.extension() == Some("rs"))).collect()
}
