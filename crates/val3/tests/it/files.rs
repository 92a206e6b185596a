//! Single files: `check FILE.pgx`, and `-` with `--stdin-path`.

use crate::support::{CLEAN, CommandOutput, FAULTY, Folder, piped};

const PROGRAM: &str = "usrapp/main/start.pgx";

/// Two programs and the data, each with a fault.
const TWO: &str = "num nCount\nnum nCount\n\nprogram start()\nbegin\n  nCuont=1\n  call other()\nend\n\n\
    program other()\nbegin\n  nOther=1\nend\n";

/// File names in the findings.
fn files(run: &CommandOutput) -> Vec<&str> {
    run.stdout.lines().filter_map(|line| line.split(':').next()?.rsplit('/').next()).collect()
}

#[test]
fn a_file_is_reported_alone() {
    let folder = Folder::with(TWO);
    let check = |paths: &[&str]| folder.val3(&[&["check", "--format", "concise"], paths].concat());
    assert_eq!(files(&check(&["usrapp"])), ["main.dtx", "other.pgx", "start.pgx"]);
    assert_eq!(files(&check(&["usrapp/main/other.pgx"])), ["other.pgx"]);
    assert_eq!(files(&check(&["usrapp/main/main.dtx"])), ["main.dtx"]);
    assert_eq!(files(&check(&["usrapp/main/main.dtx", PROGRAM])), ["main.dtx", "start.pgx"]);
    assert_eq!(files(&check(&["usrapp/main/main.pjx"])).len(), 3);
    assert_eq!(files(&check(&["usrapp/main/other.pgx", "usrapp"])).len(), 3);
}

#[test]
fn the_exit_code_is_that_of_the_file() {
    let folder =
        Folder::with("program start()\nbegin\n  call other()\nend\n\nprogram other()\nbegin\n  nOther=1\nend\n");
    assert_eq!(folder.val3(&["check"]).code, 1);
    let run = folder.val3(&["check", PROGRAM]);
    assert_eq!((run.code, run.stdout.as_str()), (0, ""), "{run:?}");
}

#[test]
fn only_the_file_is_fixed() {
    let folder = Folder::with(
        "program start()\nbegin\n  IF 1<>2\n  endIf\nend\n\nprogram other()\nbegin\n  IF 1<>2\n  endIf\nend\n",
    );
    let other = folder.read("usrapp/main/other.pgx");
    folder.val3(&["check", "--fix", PROGRAM]);
    assert!(folder.read(PROGRAM).contains("  if 1!=2"));
    assert_eq!(folder.read("usrapp/main/other.pgx"), other);
}

#[test]
fn a_file_that_no_project_lists_is_checked() {
    let folder = Folder::with(CLEAN);
    let stray = Folder::with(FAULTY).read(PROGRAM).replace("name=\"start\"", "name=\"stray\"");
    folder.write("usrapp/main/stray.pgx", &stray);
    let run = folder.val3(&["check", "--format", "concise", "usrapp/main/stray.pgx"]);
    assert_eq!((run.code, files(&run)), (1, vec!["stray.pgx"]), "{run:?}");
}

#[test]
fn the_standard_input_replaces_the_file() {
    let folder = Folder::with(CLEAN);
    let faulty = Folder::with(FAULTY).read(PROGRAM);
    let stored = folder.read(PROGRAM);
    let check = |path: &str, text: &str| check_input(&folder, path, text);
    let run = check(PROGRAM, &faulty);
    assert_eq!((run.code, files(&run)), (1, vec!["start.pgx"]), "{run:?}");
    assert!(run.stdout.starts_with("usrapp/main/start.pgx:"), "{run:?}");
    assert_eq!(check(PROGRAM, &stored).code, 0);
    assert_eq!(check("./usrapp/../usrapp/main/START.pgx", &faulty).code, 1);
    // The replaced file need not exist.
    let run = check("usrapp/main/new.pgx", &faulty.replace("name=\"start\"", "name=\"new\""));
    assert_eq!((run.code, files(&run)), (1, vec!["new.pgx"]), "{run:?}");
    let manifest = folder.read("usrapp/main/main.pjx").replace("start.pgx", "gone.pgx");
    assert_eq!(check("usrapp/main/main.pjx", &manifest).code, 1);
    assert_eq!(folder.read(PROGRAM), stored);
}

fn check_input(folder: &Folder, path: &str, text: &str) -> CommandOutput {
    piped(folder, &["check", "--format", "concise", "-", "--stdin-path", path], text.as_bytes())
}

#[test]
fn a_diff_of_the_standard_input_is_printed() {
    let folder = Folder::with(CLEAN);
    let unusual = Folder::with("num nCount\nIF nCount==1\nendIf\n").read(PROGRAM);
    let run = piped(&folder, &["check", "--diff", "-", "--stdin-path", PROGRAM], unusual.as_bytes());
    assert!(run.code == 1 && run.stdout.contains("-IF nCount==1\n+if nCount==1"), "{run:?}");
}

#[test]
fn the_standard_input_needs_a_path_and_is_not_written() {
    let folder = Folder::with(CLEAN);
    let wrong: [&[&str]; 6] = [
        &["-"],
        &["--stdin-path", PROGRAM],
        &["-", "usrapp", "--stdin-path", PROGRAM],
        &["-", "--stdin-path", PROGRAM, "--fix"],
        &["-", "--stdin-path", PROGRAM, "--watch"],
        &["-", "--stdin-path", "usrapp/main/notes.txt"],
    ];
    for options in wrong {
        let run = folder.val3(&[&["check"], options].concat());
        assert!(run.code == 2 && run.stderr.starts_with("error: "), "{options:?} {run:?}");
    }
}
