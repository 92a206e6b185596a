//! The checked-in types of the Debug Adapter Protocol are up to date with the generator.

#![allow(clippy::unwrap_used, reason = "a test may fail loudly")]

#[test]
fn the_types_are_generated_from_the_schema() {
    for file in xtask::dap::files().unwrap() {
        let checked_in = xtask::project::read(&file.path).unwrap();
        assert!(checked_in == file.text, "{} is out of date; run `cargo xtask dap`", file.path);
    }
}
