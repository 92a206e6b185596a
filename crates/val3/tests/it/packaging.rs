//! `val3 completions`, `val3 man` and `val3 version`.

use std::process::Command;

use crate::support::{Folder, run};

#[test]
fn each_shell_gets_a_script_with_commands_and_options() {
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let script = Folder::empty().val3(&["completions", shell]);
        assert_eq!((script.code, script.stderr.as_str()), (0, ""), "{shell}");
        for word in ["check", "explain-config", "junit"] {
            assert!(script.stdout.contains(word), "{shell} lacks {word}");
        }
    }
}

#[cfg(unix)]
#[test]
fn bash_completes_commands_and_values() {
    let folder = Folder::empty();
    assert_eq!(folder.val3(&["completions", "bash", "--output", "val3.bash"]).code, 0);
    if Command::new("bash").arg("--version").output().is_err() {
        return;
    }
    let script = "set -u; source val3.bash
        complete_words() { COMP_WORDS=(val3 \"$@\"); COMP_CWORD=$#; COMPREPLY=(); _val3 val3 \"${COMP_WORDS[-1]}\" \"${COMP_WORDS[-2]}\"; echo \"${COMPREPLY[*]}\"; }
        complete_words ru; complete_words check --format jun; complete_words arm sh";
    let mut bash = Command::new("bash");
    bash.args(["--norc", "-c", script]).current_dir(folder.path());
    let output = run(bash);
    assert_eq!((output.code, output.stdout.as_str()), (0, "run\njunit\nshow\n"), "{output:?}");
}

#[test]
fn each_command_has_a_manual_page() {
    let folder = Folder::empty();
    let output = folder.val3(&["man", "man/man1"]);
    assert_eq!(output.code, 0, "{output:?}");
    for name in ["val3", "val3-check", "val3-run", "val3-arm-fit", "val3-new"] {
        let page = folder.read(&format!("man/man1/{name}.1"));
        assert!(page.contains(".SH NAME") && page.contains(".SH OPTIONS"), "{page}");
    }
    assert!(!folder.path().join("man/man1/val3-version.1").exists());
    let files = folder.path().join("man/man1").read_dir().unwrap().count();
    assert_eq!(output.stderr, format!("wrote {files} manual pages to man/man1\n"));
}

#[test]
fn the_version_has_commit_and_date_in_a_repository() {
    let folder = Folder::empty();
    let version = folder.val3(&["--version"]).stdout;
    for args in [&["-V"][..], &["version"], &["check", "--version"], &["run", "-V"]] {
        let same = folder.val3(args).stdout;
        assert_eq!(same.split_once(' ').unwrap().1, version.split_once(' ').unwrap().1, "{args:?}");
    }
    let (name, rest) = version.trim_end().split_once(' ').unwrap();
    let (number, commit) = rest.split_once(' ').map_or((rest, None), |(number, commit)| (number, Some(commit)));
    assert_eq!((name, number), ("val3", env!("CARGO_PKG_VERSION")));
    let Some(commit) = commit else { return };
    let commit = commit.strip_prefix('(').unwrap().strip_suffix(')').unwrap();
    let (hash, date) = commit.split_once(' ').unwrap();
    assert!(hash.len() >= 9 && hash.chars().all(|digit| digit.is_ascii_hexdigit()), "{version}");
    assert!(date.len() == 10 && date.starts_with("20") && date.matches('-').count() == 2, "{version}");
}
