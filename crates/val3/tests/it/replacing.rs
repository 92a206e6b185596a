//! Files are replaced atomically, and only by output of the same kind.

use std::fs;
use std::os::unix::fs::MetadataExt as _;

use crate::support::{CLEAN, FAULTY, Folder, UNUSUAL};

const PROGRAM: &str = "usrapp/main/start.pgx";

/// An endless run.
const ENDLESS: &str = "num nCount\nwhile true\nnCount=nCount+1\nendWhile\n";

fn names(folder: &Folder, path: &str) -> Vec<String> {
    let entries = folder.path().join(path).read_dir().unwrap();
    let mut names: Vec<_> = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

#[test]
fn a_fix_keeps_mode_and_hard_links() {
    let folder = Folder::with(UNUSUAL);
    let (program, other) = (folder.path().join(PROGRAM), folder.path().join("other.bak"));
    fs::hard_link(&program, &other).unwrap();
    let before = fs::metadata(&program).unwrap();
    let run = folder.val3(&["check", "--fix"]);
    assert_eq!(run.code, 0, "{run:?}");
    let after = fs::metadata(&program).unwrap();
    assert_eq!((after.ino(), after.mode(), after.nlink()), (before.ino(), before.mode(), 2));
    assert!(folder.read("other.bak").contains("if nCount"));
    assert_eq!(names(&folder, "usrapp/main"), ["main.dtx", "main.pjx", "start.pgx", "stop.pgx"]);
}

#[test]
fn a_leftover_of_a_killed_run_is_no_file_of_the_cell() {
    let folder = Folder::with(UNUSUAL);
    folder.write("usrapp/main/.start.pgx.val3-tmp", "<half");
    fs::copy(folder.path().join(PROGRAM), folder.path().join("usrapp/main/.other.pgx.val3-tmp")).unwrap();
    let run = folder.val3(&["check", "--fix"]);
    assert_eq!(run.code, 0, "{run:?}");
    assert!(run.stderr.contains("in 4 files"), "{run:?}");
    assert_eq!(names(&folder, "usrapp/main"), [".other.pgx.val3-tmp", "main.dtx", "main.pjx", "start.pgx", "stop.pgx"]);
    let same = folder.val3(&["diff", "usrapp/main", "usrapp/main"]);
    assert_eq!(same.code, 0, "{same:?}");
}

#[test]
fn a_run_that_is_killed_keeps_the_old_picture_and_page() {
    let folder = Folder::with(ENDLESS);
    folder.write("plot.svg", "<svg>old</svg>");
    folder.write("page.html", "<!doctype html>old");
    let arguments =
        ["run", "usrapp/main", "--time", "real", "--plot", "plot.svg", "--export", "page.html", "--events", "e"];
    let mut child = folder.command(&arguments).spawn().unwrap();
    // Waits until the record shows that the run has begun.
    while fs::metadata(folder.path().join("e")).map_or(true, |record| record.len() == 0) {
        std::thread::sleep(std::time::Duration::from_millis(10));
    }
    child.kill().unwrap();
    child.wait().unwrap();
    assert_eq!(folder.read("plot.svg"), "<svg>old</svg>");
    assert_eq!(folder.read("page.html"), "<!doctype html>old");
    let again = ["run", "usrapp/main", "--until", "0.1", "--plot", "plot.svg", "--export", "page.html"];
    let run = folder.val3(&again);
    assert_eq!(run.code, 3, "{run:?}");
    assert!(folder.read("page.html").contains("recording") && folder.read("plot.svg").starts_with("<svg"));
    assert_eq!(names(&folder, ""), ["e", "page.html", "plot.svg", "usrapp"]);
}

#[test]
fn output_does_not_replace_programs_or_other_files() {
    let folder = Folder::with(CLEAN);
    folder.write("package.json", "{\"name\": \"cell\"}");
    let program = folder.read(PROGRAM);
    for option in ["--events", "--trace", "--plot", "--export"] {
        for target in [PROGRAM, "usrapp/main/main.pjx"] {
            let run = folder.val3(&["run", "usrapp/main", option, target]);
            assert_eq!(run.code, 2, "{option} {run:?}");
            assert!(run.stderr.contains("exists and has other content"), "{run:?}");
        }
    }
    let events = folder.val3(&["run", "usrapp/main", "--events", "package.json"]);
    assert_eq!((events.code, folder.read("package.json").as_str()), (2, "{\"name\": \"cell\"}"));
    let report = folder.val3(&["check", "--output", &format!("concise={PROGRAM}")]);
    assert_eq!((report.code, folder.read(PROGRAM)), (2, program), "{report:?}");
}

#[test]
fn output_replaces_older_output() {
    let folder = Folder::with(FAULTY);
    for format in
        ["human", "concise", "json", "json-lines", "sarif", "github", "gitlab", "junit", "checkstyle", "rdjson"]
    {
        for _ in 0..2 {
            let run = folder.val3(&["check", "--output", &format!("{format}=report")]);
            assert_eq!(run.code, 1, "{format} {run:?}");
        }
        fs::remove_file(folder.path().join("report")).unwrap();
    }
    let folder = Folder::with(CLEAN);
    let arguments =
        ["run", "usrapp/main", "--events", "e", "--trace", "t", "--plot", "p", "--export", "x", "--times=times.json"];
    for _ in 0..2 {
        let run = folder.val3(&arguments);
        assert_eq!(run.code, 0, "{run:?}");
    }
}

#[test]
fn devices_receive_output_as_a_stream() {
    let folder = Folder::with(CLEAN);
    let run = folder.val3(&["run", "usrapp/main", "--events", "/dev/stdout"]);
    assert_eq!(run.code, 0, "{run:?}");
    assert!(run.stdout.contains("\"kind\":\"end\""), "{run:?}");
    let check = folder.val3(&["check", "--output", "json=/dev/stdout"]);
    assert!(check.code == 0 && check.stdout.contains("\"version\":1"), "{check:?}");
}
