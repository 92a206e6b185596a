//! `--fix`, `--unsafe-fixes` and `--diff`.

use std::fs;

use crate::support::{CLEAN, FAULTY, Folder, UNUSUAL};

const PROGRAM: &str = "usrapp/main/start.pgx";
/// Two keywords in an unusual spelling, and a name that is nearly one.
const MIXED: &str = "num nCount\nIF nCount==1\nnCuont=2\nendif\n";

#[test]
fn safe_fixes_are_written_and_the_rest_is_reported() {
    let folder = Folder::with(MIXED);
    let before = folder.read(PROGRAM);
    let run = folder.val3(&["check", "--fix"]);
    assert_eq!(run.code, 1, "{run:?}");
    assert!(run.stdout.contains("error[V0101]") && !run.stdout.contains("V0701"), "{run:?}");
    assert!(run.stderr.contains("2 of 3 findings mended"), "{run:?}");
    assert_eq!(folder.read(PROGRAM), before.replace("IF", "if").replace("endif", "endIf"));
}

#[test]
fn guesses_are_made_when_they_are_asked_for() {
    let folder = Folder::with(MIXED);
    let run = folder.val3(&["check", "--fix", "--unsafe-fixes"]);
    assert_eq!((run.code, run.stdout.as_str()), (0, ""), "{run:?}");
    assert!(run.stderr.contains("3 of 3 findings mended"), "{run:?}");
    assert!(folder.read(PROGRAM).contains("nCount=2"));
}

#[test]
fn only_selected_findings_are_mended() {
    let folder = Folder::with(MIXED);
    let before = folder.read(PROGRAM);
    folder.val3(&["check", "--fix", "--unsafe-fixes", "--ignore", "V0701"]);
    assert_eq!(folder.read(PROGRAM), before.replace("nCuont", "nCount"));
}

#[test]
fn what_is_known_or_silenced_is_not_mended() {
    let folder = Folder::with(MIXED);
    folder.val3(&["check", "--write-baseline", "--baseline", "known.json"]);
    let before = folder.read(PROGRAM);
    let run = folder.val3(&["check", "--fix", "--unsafe-fixes", "--baseline", "known.json"]);
    assert!(run.stderr.contains("0 of 0 findings mended"), "{run:?}");
    let run = folder.val3(&["check", "--fix", "--unsafe-fixes", "--ignore", "all"]);
    assert_eq!((run.code, folder.read(PROGRAM)), (0, before), "{run:?}");
}

#[test]
fn nothing_to_mend_writes_nothing() {
    let folder = Folder::with(FAULTY);
    let written = || fs::metadata(folder.path().join(PROGRAM)).unwrap().modified().unwrap();
    let before = written();
    let run = folder.val3(&["check", "--fix"]);
    assert!(run.stderr.contains("0 of 1 finding mended"), "{run:?}");
    assert_eq!(written(), before);
}

#[test]
fn fixing_twice_is_fixing_once() {
    let folder = Folder::with(MIXED);
    folder.val3(&["check", "--fix", "--unsafe-fixes"]);
    let once = folder.read(PROGRAM);
    let run = folder.val3(&["check", "--fix", "--unsafe-fixes"]);
    assert!(run.stderr.contains("0 of 0 findings mended"), "{run:?}");
    assert_eq!(folder.read(PROGRAM), once);
}

#[test]
fn a_diff_shows_and_writes_nothing() {
    let folder = Folder::with(UNUSUAL);
    let before = folder.read(PROGRAM);
    let run = folder.val3(&["check", "--diff"]);
    assert_eq!((run.code, run.stderr.as_str()), (1, ""), "{run:?}");
    assert!(run.stdout.starts_with("--- a/usrapp/main/start.pgx\n+++ b/usrapp/main/start.pgx\n@@ "), "{run:?}");
    assert!(run.stdout.contains("\n-IF nCount==1\n+if nCount==1\n"), "{run:?}");
    assert_eq!(folder.read(PROGRAM), before);
    assert_eq!(folder.val3(&["check", "--diff", "--exit-zero"]).code, 0);
}

#[test]
fn nothing_to_change_is_an_empty_diff() {
    for listing in [CLEAN, FAULTY] {
        let run = Folder::with(listing).val3(&["check", "--diff"]);
        assert_eq!((run.code, run.stdout.as_str()), (0, ""), "{run:?}");
    }
    let run = Folder::with(FAULTY).val3(&["check", "--diff", "--unsafe-fixes"]);
    assert_eq!(run.code, 1, "{run:?}");
}

/// A program of s5: ISO-8859-1, escaped, with line ends of Windows.
const OLD: &[u8] = b"<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?>\r\n\
    <programList xmlns=\"ProgramNameSpace\">\r\n\
    <program name=\"start\" public=\"false\" >\r\n\
    <description>gr\xf6\xdfe</description>\r\n\
    <paramSection/>\r\n<localSection/>\r\n\
    <source>\r\n<code>begin\r\n  // pr\xeat\r\n  IF 1&lt;2 // d\xe9j&amp;\r\n  endIf\r\nend</code>\r\n</source>\r\n\
    </program>\r\n</programList>\r\n";

#[test]
fn bytes_of_old_files_stay() {
    let folder = Folder::with(CLEAN);
    let path = folder.path().join(PROGRAM);
    fs::write(&path, OLD).unwrap();
    let run = folder.val3(&["check", "--fix", "--select", "V0701,V0024"]);
    assert!(run.stderr.contains("2 of 2 findings mended"), "{run:?}");
    let latin1 = |bytes: &[u8]| bytes.iter().map(|byte| char::from(*byte)).collect::<String>();
    let expected = latin1(OLD).replace("  IF 1&lt;2 // d\u{e9}j&amp;", "  // d\u{e9}j&amp;\r\n  if 1&lt;2");
    assert_eq!(latin1(&fs::read(&path).unwrap()), expected);
}

#[cfg(unix)]
#[test]
fn a_file_that_must_not_be_written_is_an_error() {
    use std::os::unix::fs::PermissionsExt;
    let folder = Folder::with(UNUSUAL);
    fs::set_permissions(folder.path().join(PROGRAM), fs::Permissions::from_mode(0o444)).unwrap();
    let run = folder.val3(&["check", "--fix"]);
    assert_eq!(run.code, 2, "{run:?}");
    assert!(run.stderr.contains("cannot write `usrapp/main/start.pgx`: it is read-only"), "{run:?}");
}

#[test]
fn options_that_do_not_go_together() {
    let folder = Folder::with(UNUSUAL);
    for options in
        [&["--fix", "--diff"][..], &["--fix", "--write-baseline"], &["--unsafe-fixes"], &["--diff", "--statistics"]]
    {
        let run = folder.val3(&[&["check"], options].concat());
        assert_eq!(run.code, 2, "{options:?} {run:?}");
    }
}

#[test]
fn the_summary_says_what_can_be_mended() {
    let run = Folder::with(MIXED).val3(&["check"]);
    assert!(run.stderr.contains("2 can be mended by --fix, 1 more may be by --unsafe-fixes"), "{run:?}");
}
