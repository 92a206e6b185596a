//! The files in `editors/` are up to date with the catalogue.

#![allow(clippy::unwrap_used, clippy::disallowed_methods, reason = "files are read from the disk, and a test may stop")]

use camino::Utf8Path;

#[test]
fn the_shipped_files_are_up_to_date() {
    let root = Utf8Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    for file in val3_editors::generated(&root).unwrap() {
        let found = std::fs::read_to_string(root.join(file.path)).unwrap();
        assert!(found == file.text, "{} is out of date: run `cargo run -p val3-editors`", file.path);
    }
}
