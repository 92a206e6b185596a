//! Findings and exit codes of `val3 check`.

use crate::support::{CLEAN, FAULTY, Folder, UNUSUAL, run};

#[test]
fn a_clean_application_ends_with_0() {
    let run = Folder::with(CLEAN).val3(&["check"]);
    assert_eq!((run.code, run.stdout.as_str()), (0, ""), "{run:?}");
    assert!(run.stderr.contains("no findings in 3 files (1 application, "), "{run:?}");
}

#[test]
fn a_fault_ends_with_1() {
    let run = Folder::with(FAULTY).val3(&["check"]);
    assert_eq!(run.code, 1, "{run:?}");
    assert!(run.stdout.contains("error[V0101]"), "{run:?}");
    assert!(run.stdout.contains("usrapp/main/start.pgx:"), "{run:?}");
    assert!(run.stderr.contains("val3 explain V0101"), "{run:?}");
    assert!(run.stderr.contains("1 error in 1 of 3 files"), "{run:?}");
}

#[test]
fn a_path_may_be_a_folder_an_application_or_a_project() {
    let folder = Folder::with(FAULTY);
    for path in [".", "usrapp", "usrapp/main", "usrapp/main/", "usrapp/main/main.pjx"] {
        let run = folder.val3(&["check", path, "--format", "json"]);
        assert_eq!(run.code, 1, "{path}: {run:?}");
        assert!(run.stdout.contains("V0101"), "{path}: {run:?}");
    }
}

#[test]
fn the_same_application_is_checked_once() {
    let folder = Folder::with(FAULTY);
    let run = folder.val3(&["check", "usrapp", "usrapp/main", ".", "--format", "concise"]);
    assert_eq!(run.stdout.lines().count(), 1, "{run:?}");
}

#[test]
fn the_fail_level_decides_on_the_exit_code() {
    let folder = Folder::with(UNUSUAL);
    for (arguments, code) in [
        (&["check"][..], 0),
        (&["check", "--fail-level", "warning"], 0),
        (&["check", "--fail-level", "info"], 1),
        (&["check", "--fail-level", "info", "--exit-zero"], 0),
    ] {
        let run = folder.val3(arguments);
        assert_eq!(run.code, code, "{arguments:?} {run:?}");
        assert!(run.stdout.contains("info[V0701]"), "{arguments:?} {run:?}");
    }
}

#[test]
fn rules_can_be_selected() {
    let folder = Folder::with(FAULTY);
    for (arguments, code) in [
        (["check", "--select", "V02"], 0),
        (["check", "--select", "V02,unknown-name"], 1),
        (["check", "--ignore", "v01"], 0),
        (["check", "--ignore", "V0102"], 1),
    ] {
        let run = folder.val3(&arguments);
        assert_eq!(run.code, code, "{arguments:?} {run:?}");
    }
}

#[test]
fn the_number_of_threads_changes_nothing() {
    let folder = Folder::with(&format!("{FAULTY}\n--- part\n{FAULTY}\n--- tray\n{FAULTY}"));
    let single = folder.val3(&["check", "--jobs", "1", "--format", "json-lines"]);
    let double = folder.val3(&["check", "--jobs", "2", "--format", "json-lines"]);
    assert_eq!(single.stdout.lines().count(), 3, "{single:?}");
    assert_eq!(single.stdout, double.stdout);
}

#[test]
fn a_closed_pipe_is_no_error() {
    let folder = Folder::with(FAULTY);
    let mut command = folder.command(&["check"]);
    let (reader, writer) = std::io::pipe().unwrap();
    drop(reader);
    command.stdout(writer).stderr(std::process::Stdio::piped());
    let output = command.spawn().unwrap().wait_with_output().unwrap();
    let stderr = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(1), "{stderr}");
    assert!(!stderr.contains("panicked") && !stderr.contains("cannot write"), "{stderr}");
}

#[test]
fn colours_are_for_terminals_and_on_request() {
    let folder = Folder::with(FAULTY);
    assert!(!folder.val3(&["check"]).stdout.contains('\u{1b}'));
    assert!(folder.val3(&["check", "--color", "always"]).stdout.contains('\u{1b}'));
    let mut command = folder.command(&["check", "--color", "auto"]);
    command.env("NO_COLOR", "1");
    assert!(!run(command).stdout.contains('\u{1b}'));
}
