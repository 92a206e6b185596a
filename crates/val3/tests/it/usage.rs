//! Wrong usage ends with exit code 2 and a remedy.

use crate::support::{CLEAN, Folder};

fn refused(folder: &Folder, arguments: &[&str], words: &[&str]) {
    let run = folder.val3(arguments);
    assert_eq!((run.code, run.stdout.as_str()), (2, ""), "{arguments:?} {run:?}");
    for word in words {
        assert!(run.stderr.contains(word), "{arguments:?} lacks `{word}`: {run:?}");
    }
}

#[test]
fn a_missing_path_is_refused() {
    refused(&Folder::empty(), &["check", "no/such"], &["error: `no/such`", "no such"]);
}

#[test]
fn a_folder_without_applications_is_refused() {
    let folder = Folder::empty();
    folder.write("notes.txt", "none");
    refused(&folder, &["check"], &["error: `.`", ".pjx"]);
}

#[test]
fn a_file_that_is_no_project_is_refused() {
    let folder = Folder::empty();
    folder.write("notes.txt", "none");
    refused(&folder, &["check", "notes.txt"], &["error: `notes.txt`", ".pjx"]);
}

#[test]
fn unknown_codes_are_refused() {
    let folder = Folder::with(CLEAN);
    refused(&folder, &["check", "--select", "V9"], &["--select", "`V9`", "help: "]);
    refused(&folder, &["check", "--ignore", "unknown-nam"], &["did you mean `unknown-name`?"]);
}

#[test]
fn impossible_outputs_are_refused() {
    let folder = Folder::with(CLEAN);
    refused(&folder, &["check", "--output", "yaml=x"], &["`yaml` is not a format", "json-lines"]);
    refused(&folder, &["check", "--output", "json"], &["FORMAT=FILE"]);
    refused(&folder, &["check", "--output", "json=no/such/x.json"], &["no/such/x.json", "help: "]);
}

#[test]
fn values_out_of_range_are_refused() {
    let folder = Folder::with(CLEAN);
    refused(&folder, &["check", "--jobs", "0"], &["--jobs"]);
    refused(&folder, &["check", "--val3check-template", "%x"], &["`%x`"]);
    refused(&folder, &["check", "--format", "jsn"], &["json"]);
}

#[test]
fn no_command_prints_the_help() {
    refused(&Folder::empty(), &[], &["check", "explain"]);
}

#[test]
fn the_help_names_the_exit_codes() {
    let run = Folder::empty().val3(&["check", "--help"]);
    assert_eq!(run.code, 0, "{run:?}");
    assert!(run.stdout.contains("Exit codes:"), "{run:?}");
}
