//! `val3 fmt`.

use std::fs;

use crate::support::{Folder, piped};

const PROGRAM: &str = "usrapp/main/start.pgx";
const UNTIDY: &str = "num nCount\nIF nCount == 1\nnCount = 2\nendif\n";

#[test]
fn programs_get_their_layout_and_nothing_else_changes() {
    let folder = Folder::with(UNTIDY);
    let before = folder.read(PROGRAM);
    let run = folder.val3(&["fmt"]);
    assert_eq!((run.code, run.stdout.as_str(), run.stderr.as_str()), (0, "", "1 of 1 program changed\n"));
    let expected = before
        .replace("IF nCount == 1", "  if nCount==1")
        .replace("nCount = 2", "    nCount=2")
        .replace("endif", "  endIf");
    assert_eq!(folder.read(PROGRAM), expected);
    let again = folder.val3(&["fmt", "usrapp"]);
    assert_eq!((again.code, again.stderr.as_str()), (0, "0 of 1 program changed\n"));
}

#[test]
fn check_lists_and_writes_nothing() {
    let folder = Folder::with(UNTIDY);
    let before = folder.read(PROGRAM);
    let run = folder.val3(&["fmt", "--check"]);
    assert_eq!(
        (run.code, run.stdout.as_str(), run.stderr.as_str()),
        (1, "usrapp/main/start.pgx\n", "1 of 1 program would change\n")
    );
    assert_eq!(folder.read(PROGRAM), before);
    folder.val3(&["fmt"]);
    let run = folder.val3(&["fmt", "--check"]);
    assert_eq!((run.code, run.stdout.as_str()), (0, ""));
}

#[test]
fn diff_shows_and_writes_nothing() {
    let folder = Folder::with(UNTIDY);
    let before = folder.read(PROGRAM);
    let run = folder.val3(&["fmt", "--check", "--diff", PROGRAM]);
    assert_eq!(run.code, 1, "{run:?}");
    assert!(run.stdout.starts_with("--- a/usrapp/main/start.pgx\n+++ b/usrapp/main/start.pgx\n@@ "), "{run:?}");
    assert!(run.stdout.contains("\n-IF nCount == 1\n"), "{run:?}");
    assert_eq!(folder.read(PROGRAM), before);
}

/// A program of s5: ISO-8859-1, escaped, with Windows line ends.
const OLD: &[u8] = b"<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?>\r\n\
    <programList xmlns=\"ProgramNameSpace\"><program name=\"start\" public=\"false\"><description>gr\xf6\xdfe</description>\
    <source><code>begin\r\n  // pr\xeat\r\nIF 1 &lt; 2\r\nendIf\r\nend</code></source></program></programList>\r\n";

#[test]
fn one_program_through_the_pipe_keeps_its_bytes() {
    let folder = Folder::empty();
    let run = piped(&folder, &["fmt", "-"], OLD);
    assert_eq!((run.code, run.stderr.as_str()), (0, ""));
    let old: String = OLD.iter().map(|byte| char::from(*byte)).collect();
    assert_eq!(run.stdout, old.replace("IF 1 &lt; 2\r\nendIf", "  if 1&lt;2\r\n  endIf"));
    assert_eq!(piped(&folder, &["fmt", "--check", "-"], OLD).code, 1);
}

#[test]
fn code_alone_is_formatted_or_refused_with_a_reason() {
    let folder = Folder::empty();
    let run = piped(&folder, &["fmt", "-"], b"begin\nIF a<1\nb = 1\nendif\nend\n");
    let expected = "begin\n  if a<1\n    b=1\n  endIf\nend\n";
    assert_eq!((run.code, run.stdout.as_str(), run.stderr.as_str()), (0, expected, ""));
    assert_eq!(piped(&folder, &["fmt", "--check", "-"], expected.as_bytes()).code, 0);
    let run = piped(&folder, &["fmt", "-"], b"begin\na = = 1\nend\n");
    assert_eq!((run.code, run.stdout.as_str()), (0, "begin\na = = 1\nend\n"));
    assert!(run.stderr.contains("code with syntax errors keeps its layout"), "{run:?}");
    for input in [&b"b = 1\n"[..], b""] {
        let run = piped(&folder, &["fmt", "-"], input);
        assert_eq!((run.code, run.stdout.as_str()), (2, ""));
        assert!(run.stderr.contains("does not start with `begin`"), "{run:?}");
    }
}

#[test]
fn the_style_comes_from_the_settings() {
    let folder = Folder::with(UNTIDY);
    folder.write(".editorconfig", "root=true\n[*.pgx]\nindent_style=tab\n");
    folder.val3(&["fmt"]);
    assert!(folder.read(PROGRAM).contains("\n\t\tnCount=2\n"), "{}", folder.read(PROGRAM));
    folder.write("val3.toml", "[format]\nindent-style = \"space\"\nindent-size = 3\nblanks-around-assignment = true\n");
    folder.val3(&["fmt"]);
    assert!(folder.read(PROGRAM).contains("\n      nCount = 2\n"), "{}", folder.read(PROGRAM));
    let text = folder.read(PROGRAM);
    let run = piped(&folder, &["fmt", "--stdin-path", PROGRAM, "-"], text.as_bytes());
    assert_eq!(run.stdout, text);
}

#[test]
fn unreadable_code_is_kept() {
    let folder = Folder::with("num nCount\nnCount = 1\nnCount = = 2\n");
    let run = folder.val3(&["fmt"]);
    assert_eq!(run.code, 0, "{run:?}");
    assert!(run.stderr.starts_with("usrapp/main/start.pgx: code with syntax errors keeps"), "{run:?}");
    let text = folder.read(PROGRAM);
    assert!(text.contains("nCount=1\n") && text.contains("nCount = = 2\n"), "{text}");
}

#[test]
fn excluded_programs_are_left_out_of_a_search() {
    let folder = Folder::with(UNTIDY);
    folder.write("val3.toml", "exclude = [\"**/start.pgx\"]\n");
    let run = folder.val3(&["fmt", "--check"]);
    assert_eq!((run.code, run.stderr.as_str()), (0, "0 of 0 programs would change\n"));
    assert_eq!(folder.val3(&["fmt", "--check", PROGRAM]).code, 1);
}

#[test]
fn wrong_usage_is_refused() {
    let folder = Folder::with(UNTIDY);
    folder.write("notes.txt", "none");
    for (arguments, word) in [
        (&["fmt", "no/such"][..], "no such"),
        (&["fmt", "notes.txt"], ".pgx"),
        (&["fmt", "-", "usrapp"], "standard input"),
        (&["fmt", "--stdin-path", "a.pgx"], "`-`"),
        (&["fmt", "--chek"], "--check"),
    ] {
        let run = folder.val3(arguments);
        assert_eq!((run.code, run.stdout.as_str()), (2, ""), "{arguments:?} {run:?}");
        assert!(run.stderr.contains(word), "{arguments:?} {run:?}");
    }
    folder.write("val3.toml", "[format]\nindent = 2\n");
    let run = folder.val3(&["fmt"]);
    assert_eq!(run.code, 2, "{run:?}");
    assert!(run.stderr.contains("format.indent"), "{run:?}");
}

#[cfg(unix)]
#[test]
fn a_file_that_must_not_be_written_is_an_error() {
    use std::os::unix::fs::PermissionsExt;
    let folder = Folder::with(UNTIDY);
    fs::set_permissions(folder.path().join(PROGRAM), fs::Permissions::from_mode(0o444)).unwrap();
    let run = folder.val3(&["fmt"]);
    assert_eq!(run.code, 2, "{run:?}");
    assert!(run.stderr.contains("it is read-only"), "{run:?}");
}
