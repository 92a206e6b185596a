//! `val3 test`: tests of the example palletiser.

use std::path::Path;
use std::process::Command;

use serde_json::Value;

use crate::support::{CommandOutput, Folder, copy_folder, run};

fn tested(options: &[&str]) -> CommandOutput {
    let mut command = Command::new(env!("CARGO_BIN_EXE_val3"));
    command.current_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/palletiser/tests"));
    command.arg("test").args(options);
    run(command)
}

/// The cell's host is another machine, and the scenarios limit cycle times.
const NOTE: &str = "note: sockets are not connected in tests: `Socket\\host`\n  help: let the script of the test be the \
                    other end, or name the connection with --line 'Socket\\host=server:PORT'\nnote: times of a model arm: the speeds and accelerations of the TX90L are not measured; `val3 arm \
                    measure` measures yours\n";

#[test]
fn the_tests_of_the_palletiser_pass_in_any_order() {
    let first = tested(&["--jobs", "1"]);
    assert_eq!((first.code, first.stderr.as_str()), (0, NOTE), "{first:?}");
    assert_eq!(tested(&["--jobs", "2", "--seed", "7"]).stdout, first.stdout);
}

#[test]
fn the_tests_of_the_palletiser_are_programs_tables_and_scenarios() {
    let listed = tested(&["--list", "--format", "json"]);
    let listed: Value = serde_json::from_str(&listed.stdout).unwrap();
    let applications = listed["applications"].as_array().unwrap();
    let tests: Vec<&Value> = applications.iter().flat_map(|one| one["tests"].as_array().unwrap()).collect();
    for name in
        ["palletiserTest:testAverage", "palletiserTest:testTower[3]", "faultsTest:testInitFails", "palletiser:boxes"]
    {
        assert!(tests.iter().any(|test| test["name"] == name), "{name}: {listed}");
    }
}

/// An unpacked archive is not in a repository, and its user has trusted no folder.
#[test]
fn a_copy_of_the_palletiser_needs_nothing_outside_of_it() {
    let folder = Folder::empty();
    let example = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/palletiser");
    copy_folder(&example, &folder.path().join("cell"));
    assert_eq!(folder.val3(&["check", "cell"]).code, 0);
    let tested = folder.val3(&["test", "cell"]);
    assert_eq!((tested.code, tested.stderr.as_str()), (0, NOTE), "{tested:?}");
}
