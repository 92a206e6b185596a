//! The files in `editors/` are up to date with the catalogue.

use val3_generate::editors;

use crate::root;

#[test]
fn the_shipped_files_are_up_to_date() {
    for file in editors::generated(&root()).unwrap() {
        let found = std::fs::read_to_string(root().join(file.path)).unwrap();
        assert!(found == file.text, "{} is out of date: run `cargo run -p val3-generate editors`", file.path);
    }
}
