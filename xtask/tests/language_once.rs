//! Only `val3-lang` contains the names of instructions.

#![allow(clippy::unwrap_used, reason = "a test may fail loudly")]

use std::collections::BTreeSet;

use camino::{Utf8Path, Utf8PathBuf};

const CRATES: &[&str] =
    &["val3-syntax", "val3-analysis", "val3-check", "val3-diff", "val3-ide", "val3-compile", "val3"];

/// Names of instructions that have another meaning too: attributes in files and types; `libLoad`, by which the loader
/// finds libraries before the analysis; `open` and `watch`, options of the command line; `close`, a word of HTTP;
/// `help`, a command; `round`, a side of a `for` in the coverage; `replace`, a key of tests; and `power`, a key of
/// scripts.
const SHARED: &[&str] =
    &["size", "config", "link", "position", "libLoad", "open", "close", "round", "help", "replace", "power", "watch"];

/// Returns the names in the manual's signatures: the word before the first bracket.
fn instructions(root: &Utf8Path) -> BTreeSet<String> {
    let table = std::fs::read_to_string(root.join("crates/val3-lang/tests/instructions.tsv")).unwrap();
    let signatures = table.lines().filter(|line| !line.starts_with('#')).filter_map(|line| line.split('\t').nth(1));
    let heads = signatures.filter_map(|signature| signature.split('(').next());
    let names = heads.filter_map(|head| head.rsplit([' ', ':']).next());
    names.filter(|name| !SHARED.contains(name)).map(str::to_owned).collect()
}

/// Returns the strings in the code, without tests and comments.
fn texts(source: &str) -> impl Iterator<Item = &str> {
    let code = source.split("#[cfg(test)]").next().unwrap_or_default();
    let lines = code.lines().filter(|line| !line.trim_start().starts_with("//"));
    lines.flat_map(|line| line.split('"').skip(1).step_by(2))
}

fn sources(folder: &Utf8Path) -> Vec<Utf8PathBuf> {
    let entries = folder.read_dir_utf8().unwrap().map(|entry| entry.unwrap().into_path());
    let (folders, files): (Vec<_>, Vec<_>) = entries.partition(|path| path.is_dir());
    let nested = folders.iter().flat_map(|folder| sources(folder));
    let written = files.into_iter().filter(|path| path.extension() == Some("rs"));
    nested.chain(written.filter(|path| path.file_stem() != Some("tests"))).collect()
}

#[test]
fn instructions_are_spelt_in_one_crate() {
    let root = xtask::project::root();
    let names = instructions(&root);
    assert!(names.contains("movej") && names.len() > 100, "{names:?}");
    for path in CRATES.iter().flat_map(|name| sources(&root.join("crates").join(name).join("src"))) {
        let source = std::fs::read_to_string(&path).unwrap();
        let wrong: Vec<_> = texts(&source).filter(|text| names.contains(*text)).collect();
        assert!(wrong.is_empty(), "{path} spells instructions: {wrong:?}");
    }
}
