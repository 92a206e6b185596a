//! Files that exist but cannot be read: no command blocks on them, fills the memory, or reports success without them.
//!
//! The tests may run as root, for whom missing permissions have no effect. Folders, pipes and sockets are used instead.

use std::fs;
use std::os::unix::net::UnixListener;

use rustix::fs::{CWD, FileType, Mode, mknodat};

use crate::support::{CLEAN, CommandOutput, Folder};

/// An application with two programs.
const TWO: &str =
    "num nCount\nprogram start()\nbegin\n  call helper()\nend\n\nprogram helper()\nbegin\n  nCount=1\nend\n";

/// Creates an entry at a path.
type Create = fn(&str);

/// Unreadable entries and their reasons.
const UNREADABLE: [(Create, &str); 3] =
    [(pipe, "it is a pipe"), (socket, "it is a socket"), (folder, "it is a folder")];

/// Application of [`TWO`], with an unreadable entry in place of `helper.pgx`.
fn with_helper(replace: impl FnOnce(&str)) -> Folder {
    let folder = Folder::with(TWO);
    replace_entry(&folder, "usrapp/main/helper.pgx", replace);
    folder
}

fn replace_entry(folder: &Folder, path: &str, replace: impl FnOnce(&str)) {
    let path = folder.path().join(path);
    fs::remove_file(&path).ok();
    fs::create_dir_all(path.parent().unwrap()).unwrap();
    replace(path.to_str().unwrap());
}

fn pipe(path: &str) {
    mknodat(CWD, path, FileType::Fifo, Mode::from_raw_mode(0o600), 0).unwrap();
}

fn socket(path: &str) {
    UnixListener::bind(path).unwrap();
}

fn folder(path: &str) {
    fs::create_dir(path).unwrap();
}

#[track_caller]
fn assert_refused(run: &CommandOutput, message: &str) {
    assert_eq!(run.code, 2, "{run:?}");
    assert!(format!("{}{}", run.stdout, run.stderr).contains(message), "{message}: {run:?}");
}

#[test]
fn a_listed_program_that_cannot_be_read_is_an_error_at_its_entry() {
    let run = with_helper(folder).val3(&["check"]);
    assert_eq!(run.code, 2, "{run:?}");
    insta::assert_snapshot!(run.stdout);
}

#[test]
fn every_command_names_the_reason() {
    for (replace, reason) in UNREADABLE {
        let folder = with_helper(replace);
        let message = format!("the file `helper.pgx` cannot be read: {reason}");
        assert_refused(&folder.val3(&["check"]), &message);
        assert_refused(&folder.val3(&["run", "usrapp/main"]), &message);
        assert_refused(&folder.val3(&["eval", "--app", "usrapp/main", "1"]), &format!("helper.pgx`: {reason}"));
    }
    let folder = with_helper(pipe);
    let named = folder.val3(&["check", "usrapp/main/helper.pgx"]);
    assert_refused(&named, "the file `helper.pgx` cannot be read: it is a pipe");
    assert_refused(&folder.val3(&["diff", "usrapp/main", "usrapp/main"]), "helper.pgx`: it is a pipe");
    assert_refused(&folder.val3(&["fmt", "--check"]), "helper.pgx`: it is a pipe");
}

#[test]
fn every_format_has_the_finding() {
    let folder = with_helper(pipe);
    for format in ["human", "concise", "json", "json-lines", "val3check", "sarif", "github", "gitlab", "azure", "junit"]
    {
        let run = folder.val3(&["check", "--format", format]);
        assert_refused(&run, "cannot be read: it is a pipe");
    }
    let sarif = folder.val3(&["check", "--format", "sarif"]).stdout;
    assert!(sarif.contains("\"executionSuccessful\": false"), "{sarif}");
}

#[test]
fn no_setting_hides_the_finding() {
    let folder = with_helper(pipe);
    folder.write("val3.toml", "[rules]\nall = \"off\"\n");
    let message = "V0502";
    assert_refused(&folder.val3(&["check"]), message);
    assert_refused(&folder.val3(&["check", "--select", "V0701"]), message);
    assert_refused(&folder.val3(&["check", "--ignore", "V0502", "--exit-zero"]), message);
}

#[test]
fn a_baseline_keeps_the_findings_of_unread_files() {
    let folder = Folder::with(&TWO.replace("nCount=1", "nCuont=1"));
    let check = |more: &[&str]| folder.val3(&[&["check", "--baseline", "known.json"], more].concat());
    assert_eq!(check(&["--write-baseline"]).code, 0);
    let known = folder.read("known.json");
    let program = folder.read("usrapp/main/helper.pgx");
    replace_entry(&folder, "usrapp/main/helper.pgx", pipe);
    for mode in ["--prune-baseline", "--write-baseline"] {
        let run = check(&[mode]);
        assert_refused(&run, "the baseline is not changed, because files could not be read");
        assert_eq!(folder.read("known.json"), known, "{mode}");
    }
    fs::remove_file(folder.path().join("usrapp/main/helper.pgx")).unwrap();
    folder.write("usrapp/main/helper.pgx", &program);
    assert_eq!(check(&[]).code, 0);
}

#[test]
fn data_and_projects_that_cannot_be_read_are_errors() {
    let folder = Folder::with(TWO);
    replace_entry(&folder, "usrapp/main/main.dtx", socket);
    assert_refused(&folder.val3(&["check"]), "the file `main.dtx` cannot be read: it is a socket");
    let folder = Folder::with(TWO);
    replace_entry(&folder, "usrapp/main/main.pjx", pipe);
    assert_refused(&folder.val3(&["check"]), "the file `main.pjx` cannot be read: it is a pipe");
    assert_refused(&folder.val3(&["run", "usrapp/main"]), "cannot be read: it is a pipe");
    let folder = Folder::with("library part \"Disk://part/part.pjx\"\n? 1\n--- part\npublic num nWeight\n");
    replace_entry(&folder, "usrapp/part/part.pjx", pipe);
    assert_refused(
        &folder.val3(&["check", "usrapp/main"]),
        "the file `Disk://part/part.pjx` cannot be read: it is a pipe",
    );
}

#[test]
fn an_unread_program_of_a_library_makes_the_check_incomplete() {
    let folder = Folder::with(&format!("library part \"Disk://part/part.pjx\"\n? 1\n--- part\n{TWO}"));
    replace_entry(&folder, "usrapp/part/helper.pgx", pipe);
    let run = folder.val3(&["check", "usrapp/main", "--ignore", "V0118"]);
    assert_refused(&run, "error: cannot read `usrapp/part/helper.pgx`: it is a pipe");
    assert!(run.stderr.contains("incomplete: no findings"), "{run:?}");
}

#[test]
fn a_file_that_no_project_lists_is_no_error() {
    let folder = Folder::with(TWO);
    replace_entry(&folder, "usrapp/main/x.pgx", pipe);
    assert_ne!(folder.val3(&["check"]).code, 2);
    assert_refused(&folder.val3(&["check", "usrapp/main/x.pgx"]), "the file `x.pgx` cannot be read: it is a pipe");
}

#[test]
fn files_of_the_cell_are_named() {
    for name in ["arm.cfx", "sio.cfx"] {
        let folder = Folder::with(&format!("=== /configs/none.cfx\n\n--- main\n{CLEAN}"));
        replace_entry(&folder, &format!("configs/{name}"), pipe);
        assert_refused(
            &folder.val3(&["check"]),
            &format!("the file `usr/configs/{name}` of the cell cannot be read: it is a pipe"),
        );
        assert_refused(&folder.val3(&["run", "usrapp/main"]), "it is a pipe");
    }
}

#[test]
fn settings_scripts_and_shapes_are_regular_files() {
    let folder = Folder::with(CLEAN);
    replace_entry(&folder, "script.toml", pipe);
    assert_refused(&folder.val3(&["run", "usrapp/main", "--script", "script.toml"]), "it is a pipe");
    assert_refused(&folder.val3(&["run", "usrapp/main", "--replay", "script.toml"]), "it is a pipe");
    assert_refused(&folder.val3(&["run", "usrapp/main", "--arm", "script.toml"]), "it is a pipe");
    assert_refused(&folder.val3(&["check", "--baseline", "script.toml"]), "it is a pipe");
    replace_entry(&folder, ".editorconfig", pipe);
    assert_refused(&folder.val3(&["fmt", "--check"]), ".editorconfig`: it is a pipe");
    folder.write("val3.toml", "add-ons = [\"script.toml\"]\n");
    assert_refused(&folder.val3(&["check"]), "it is a pipe");
    folder.write("val3.toml", "[run]\nshapes = { base = \"base.stl\" }\n");
    replace_entry(&folder, "base.stl", socket);
    assert_refused(&folder.val3(&["run", "usrapp/main"]), "base.stl`: it is a socket");
    replace_entry(&folder, "val3.toml", socket);
    for command in [&["check"][..], &["run", "usrapp/main"], &["fmt"], &["test"]] {
        assert_refused(&folder.val3(command), "val3.toml` cannot be read: it is a socket");
    }
}

#[test]
fn files_have_a_size_that_an_option_raises() {
    let folder = Folder::with(CLEAN);
    folder.write("val3.toml", &"# comment\n".repeat(110_000));
    assert_refused(&folder.val3(&["check"]), "it has 1100000 bytes, and at most 1048576 bytes are read");
    assert_eq!(folder.val3(&["check", "--max-file-size", "2M"]).code, 0);
    assert_refused(
        &folder.val3(&["check", "--max-file-size", "2M", "--max-workspace-size", "100"]),
        "more than 100 bytes",
    );
}

#[test]
fn a_file_that_may_be_a_scenario_is_read_or_named() {
    let folder = Folder::with(CLEAN);
    replace_entry(&folder, "tests/cell.toml", pipe);
    assert_refused(&folder.val3(&["test"]), "cell.toml`, which may be a test: it is a pipe");
}
