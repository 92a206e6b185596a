//! Command-line behaviour that all commands share: colours, repeated options, and another settings file.

use std::process::Command;

use expect_test::expect;

use crate::support::{CLEAN, FAULTY, Folder, run};

/// Standard output of a command with these environment variables.
fn with_variables(folder: &Folder, args: &[&str], variables: &[(&str, &str)]) -> String {
    let mut command: Command = folder.command(args);
    command.envs(variables.iter().copied());
    run(command).stdout
}

#[test]
fn options_and_variables_decide_on_colours_also_of_the_help() {
    let folder = Folder::with(FAULTY);
    let force = ("FORCE_COLOR", "1");
    for args in [&["check", "--help"][..], &["--help"], &["check"], &["help", "run"]] {
        let output =
            |more: &[&str], variables: &[(&str, &str)]| with_variables(&folder, &[more, args].concat(), variables);
        assert!(!is_colored(&output(&[], &[])), "{args:?}");
        assert!(is_colored(&output(&[], &[force])) && is_colored(&output(&[], &[("CLICOLOR_FORCE", "1")])), "{args:?}");
        assert!(!is_colored(&output(&[], &[force, ("NO_COLOR", "1")])), "{args:?}");
        assert!(!is_colored(&output(&["--color", "never"], &[force])), "{args:?}");
        assert!(is_colored(&output(&["--color=never", "--color=always"], &[("NO_COLOR", "1")])), "{args:?}");
    }
}

fn is_colored(output: &str) -> bool {
    output.contains('\u{1b}')
}

#[test]
fn a_later_option_replaces_an_earlier_one() {
    let folder = Folder::with(FAULTY);
    let human = folder.val3(&["check", "--format", "human"]);
    assert_eq!(folder.val3(&["check", "--format", "json", "--format", "human"]).stdout, human.stdout);
    assert_eq!(folder.val3(&["check", "--quiet", "--quiet"]).stdout, human.stdout);
    let several = folder.val3(&["check", "--ignore", "V0101", "--ignore", "V0102"]);
    assert!(!several.stdout.contains("V0101"), "lists are not replaced: {several:?}");
}

#[test]
fn another_file_has_the_settings() {
    let folder = Folder::with(FAULTY);
    folder.write("val3.toml", "[rules]\nV0101 = \"off\"\n");
    folder.write("other/strict.toml", "[rules]\nV0101 = \"warning\"\n");
    assert_eq!(folder.val3(&["check"]).stdout, "");
    let strict = folder.val3(&["check", "--config", "other/strict.toml"]);
    assert!(strict.stdout.contains("warning[V0101]"), "{strict:?}");
    let listed = folder.val3(&["check", "--explain-config", "--config", "other/strict.toml"]);
    assert!(listed.stdout.contains("other/strict.toml"), "{listed:?}");
    let missing = folder.val3(&["check", "--config", "none.toml"]);
    assert_eq!((missing.code, missing.stdout.as_str()), (2, ""));
    expect![[r#"
        error: cannot read the settings `none.toml`: it does not exist
          help: name a file like val3.toml
    "#]]
    .assert_eq(&missing.stderr);
}

#[test]
fn verbose_names_settings_and_arm() {
    let folder = Folder::with(CLEAN);
    folder.write("val3.toml", "arm = \"tx2-60l\"\n");
    for args in [&["check", "--verbose"][..], &["run", "-v"]] {
        let output = folder.val3(args);
        let lines: Vec<&str> = output.stderr.lines().filter_map(|line| line.strip_prefix("verbose: ")).collect();
        assert!(lines[0].starts_with("val3 0."), "{output:?}");
        assert_eq!(lines[1], "usrapp/main: settings val3.toml, arm TX2-60L", "{output:?}");
    }
}

#[test]
fn nothing_to_do_is_wrong_usage() {
    let folder = Folder::empty();
    let fmt = folder.val3(&["fmt"]);
    assert_eq!(fmt.code, 2);
    expect![[r#"
        error: `.`: there is no program (`.pgx`) here
          help: name a program, or a folder that contains some
    "#]]
    .assert_eq(&fmt.stderr);
    folder.val3(&["new", "app"]);
    for args in [&["test", "--filter", "zzz"][..], &["test", "--filter", "zzz", "--list"]] {
        let test = folder.val3(args);
        assert_eq!((test.code, test.stdout.as_str()), (2, ""));
        assert!(test.stderr.contains("there is no test whose name contains `zzz`"), "{test:?}");
    }
}

#[test]
fn faults_of_settings_name_file_and_line() {
    for (text, words) in [
        ("\narm = \"tx2-61\"\n", "the arm `tx2-61` is not known"),
        ("\nversion = \"s9\"\n", "`s9` is not a version of VAL 3 from s5 to s8"),
        ("[run]\nstart = [1, 2]\n", "`start` has 6 numbers, for a SCARA arm 4, and this list has 2"),
        ("\nbaseline = \"none.json\"\n", "cannot read the baseline `none.json`"),
    ] {
        let folder = Folder::with(CLEAN);
        folder.write("val3.toml", text);
        for args in [&["check"][..], &["run"]] {
            if args == ["run"] && text.contains("baseline") {
                continue;
            }
            let output = folder.val3(args);
            assert_eq!((output.code, output.stdout.as_str()), (2, ""), "{output:?}");
            assert!(output.stderr.contains(words) && output.stderr.contains("val3.toml:2"), "{args:?} {output:?}");
        }
    }
}

#[test]
fn messages_have_relative_paths() {
    let folder = Folder::with(CLEAN);
    folder.write("notes.txt", "");
    let diff = folder.val3(&["diff", "notes.txt", "usrapp"]);
    assert_eq!(diff.stderr.lines().next(), Some("error: a file cannot be compared with a folder: `notes.txt`"));
    let init = folder.val3(&["test", "--init", "usrapp/main"]);
    assert_eq!(
        init.stderr,
        "wrote usrapp/val3assert\nwrote usrapp/mainTest\nrun the tests: val3 test usrapp/mainTest\n"
    );
}
