//! Check output for the shipped cell with one fault per rule family.

use std::process::Command;

use crate::support::run;

#[test]
fn the_report_of_the_faulty_cell_is_unchanged() {
    let mut command = Command::new(env!("CARGO_BIN_EXE_val3"));
    command.args(["check", "examples/faulty"]).env_remove("NO_COLOR");
    command.current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."));
    let run = run(command);
    assert_eq!(run.code, 1);
    insta::assert_snapshot!(run.stdout);
}
