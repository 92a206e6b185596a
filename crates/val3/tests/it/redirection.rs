//! `--output` and `--input`: files that replace the standard output and the standard input.

use crate::support::{CLEAN, FAULTY, Folder, UNUSUAL, piped};

/// Writes a command's output to a file, and checks that it equals the standard output.
fn same_in_file(folder: &Folder, words: &[&str], args: &[&str]) {
    let printed = folder.val3(&[words, args].concat());
    let written = folder.val3(&[words, &["--output", "out.txt"], args].concat());
    assert_eq!(
        (written.code, written.stdout.as_str(), &written.stderr),
        (printed.code, "", &printed.stderr),
        "{args:?}"
    );
    assert_eq!(folder.read("out.txt"), printed.stdout, "{args:?}");
    assert!(!printed.stdout.is_empty(), "{args:?}");
    std::fs::remove_file(folder.path().join("out.txt")).unwrap();
}

#[test]
fn text_of_each_command_can_be_written_to_a_file() {
    let folder = Folder::with(UNUSUAL);
    folder.write("other/other.pjx", "<Project><Parameters version=\"s8.10\"/></Project>");
    for (words, args) in [
        (&["schema"][..], &[][..]),
        (&["schema"], &["--debugger"]),
        (&["explain"], &[]),
        (&["explain"], &["movej"]),
        (&["completions"], &["zsh"]),
        (&["eval"], &["1+1", "\"a\""]),
        (&["eval"], &["1+"]),
        (&["fmt"], &["--diff"]),
        (&["fmt"], &["--check"]),
        (&["run"], &["usrapp/main", "--screen"]),
        (&["run"], &["usrapp/main", "--scene"]),
        (&["diff"], &["usrapp/main", "other"]),
        (&["diff"], &["usrapp/main", "other", "--format", "json"]),
        (&["diff"], &["usrapp/main", "other", "--format", "html"]),
        (&["diff"], &["usrapp/main", "other", "--format", "markdown"]),
        (&["diff"], &["--textconv", "usrapp/main/start.pgx"]),
        (&["arm", "list"], &[]),
        (&["arm", "show"], &["tx2-60l"]),
    ] {
        same_in_file(&folder, words, args);
    }
}

#[test]
fn patch_and_settings_of_a_check_are_written_in_their_only_form() {
    let folder = Folder::with(UNUSUAL);
    for option in ["--diff", "--explain-config"] {
        let printed = folder.val3(&["check", option]);
        let written = folder.val3(&["check", option, "--output", "human=out.txt"]);
        assert_eq!((written.code, written.stdout.as_str()), (printed.code, ""), "{written:?}");
        assert_eq!(folder.read("out.txt"), printed.stdout);
        for other in [&["--format", "json"][..], &["--output", "json=out.json"]] {
            let refused = folder.val3(&[&["check", option], other].concat());
            assert_eq!((refused.code, refused.stdout.as_str()), (2, ""), "{refused:?}");
            assert!(refused.stderr.contains("prints only the format `human`"), "{refused:?}");
        }
    }
}

#[test]
fn a_formatted_copy_leaves_the_program_unchanged() {
    let folder = Folder::with(UNUSUAL);
    let before = folder.read("usrapp/main/start.pgx");
    let copy = folder.val3(&["fmt", "usrapp/main/start.pgx", "--output", "copy.pgx"]);
    assert_eq!((copy.code, copy.stdout.as_str()), (0, ""), "{copy:?}");
    assert_eq!(folder.read("usrapp/main/start.pgx"), before);
    assert!(folder.read("copy.pgx").contains("if nCount==1"), "{copy:?}");
    let bytes = before.as_bytes();
    assert_eq!(folder.read("copy.pgx"), piped(&folder, &["fmt", "-"], bytes).stdout);
    // A program only replaces a program.
    assert_eq!(folder.val3(&["fmt", "usrapp/main/start.pgx", "--output", "copy.pgx"]).code, 0);
    let refused = folder.val3(&["fmt", "usrapp/main/start.pgx", "--output", "usrapp/main/main.dtx"]);
    assert!(refused.code == 2 && refused.stderr.contains("does not replace it"), "{refused:?}");
    folder.write("usrapp/main/second.pgx", &before);
    let several = folder.val3(&["fmt", "--output", "new.pgx"]);
    assert!(several.code == 2 && several.stderr.contains("--output needs one program"), "{several:?}");
}

#[test]
fn a_file_replaces_the_standard_input() {
    let folder = Folder::with(CLEAN);
    let faulty = Folder::with(FAULTY).read("usrapp/main/start.pgx");
    folder.write("changed.txt", &faulty);
    folder.write("lines.txt", "num nA\nnA=2\nnA*21\n");
    let path = "usrapp/main/start.pgx";
    let check = folder.val3(&["check", "-", "--stdin-path", path, "--input", "changed.txt"]);
    let concise = ["check", "-", "--stdin-path", path, "--format", "concise"];
    let by_file = folder.val3(&[&concise[..], &["--input", "changed.txt"]].concat());
    assert_eq!(by_file.stdout, piped(&folder, &concise, faulty.as_bytes()).stdout);
    assert!(check.stdout.contains("nCuont"), "{check:?}");
    let fmt = folder.val3(&["fmt", "-", "--input", "changed.txt"]);
    assert_eq!(fmt.stdout, piped(&folder, &["fmt", "-"], faulty.as_bytes()).stdout);
    let eval = folder.val3(&["eval", "--local", "num nA", "--input", "lines.txt"]);
    assert_eq!(eval.stdout, piped(&folder, &["eval", "--local", "num nA"], b"num nA\nnA=2\nnA*21\n").stdout);
    for args in [&["check", "--input", "changed.txt"][..], &["fmt", "--input", "changed.txt"]] {
        let refused = folder.val3(args);
        assert!(refused.code == 2 && refused.stderr.contains("--input requires the path `-`"), "{refused:?}");
    }
    let missing = folder.val3(&["eval", "--input", "none.txt"]);
    assert!(missing.code == 2 && missing.stderr.contains("cannot read `none.txt`"), "{missing:?}");
}
