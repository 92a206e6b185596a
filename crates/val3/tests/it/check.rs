//! Findings and exit codes of `val3 check`.

use crate::support::{CLEAN, FAULTY, Folder, UNUSUAL, run};

#[test]
fn a_clean_application_ends_with_0() {
    let run = Folder::with(CLEAN).val3(&["check"]);
    assert_eq!((run.code, run.stdout.as_str()), (0, ""), "{run:?}");
    assert!(run.stderr.contains("no findings in 4 files (1 application, "), "{run:?}");
}

#[test]
fn a_fault_ends_with_1() {
    let run = Folder::with(FAULTY).val3(&["check"]);
    assert_eq!(run.code, 1, "{run:?}");
    assert!(run.stdout.contains("error[V0101]"), "{run:?}");
    assert!(run.stdout.contains("usrapp/main/start.pgx:"), "{run:?}");
    assert!(run.stderr.contains("val3 explain V0101"), "{run:?}");
    assert!(run.stderr.contains("1 error in 1 of 4 files"), "{run:?}");
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

/// Each instruction name of another language, on a separate line.
#[test]
fn instructions_of_other_languages_are_errors_in_every_version_with_their_remedy() {
    let names: Vec<&str> = val3_lang::foreign_names::all().collect();
    let code: String = names.iter().map(|name| format!("  {name}(1)\n")).collect();
    for version in ["s6.8", "s7.11", "s8.13"] {
        let folder = Folder::with(&format!("version {version}\nprogram start()\nbegin\n{code}end"));
        let run = folder.val3(&["check", "--format", "json-lines", "--select", "V0103"]);
        assert_eq!(run.code, 1, "{run:?}");
        let found: Vec<serde_json::Value> =
            run.stdout.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
        for name in &names {
            let message = found.iter().find(|it| it["message"].as_str().unwrap().contains(&format!("`{name}`")));
            let Some(message) = message else { panic!("{version}: {name}: {run:?}") };
            assert_eq!(message["severity"], "error", "{version}: {name}");
            assert_ne!(message["help"], "", "{version}: {name}");
        }
    }
}

#[test]
fn an_instruction_that_s8_may_have_is_a_warning() {
    assert_eq!(level("s7.11"), "error[V0103]");
    assert_eq!(level("s8.13"), "warning[V0103]");
}

/// Level of the finding about an unknown instruction, for example `error[V0103]`.
fn level(version: &str) -> String {
    let folder = Folder::with(&format!("version {version}\nsomethingElse(1)\n"));
    let run = folder.val3(&["check", "--format", "concise"]);
    run.stdout.lines().find(|line| line.contains("V0103")).unwrap().split(' ').nth(1).unwrap().to_owned()
}

#[test]
fn a_do_block_that_ends_with_while_is_one_finding_with_a_fix() {
    let folder = Folder::with("num nCount\nprogram start()\nbegin\n  do\n    nCount=nCount+1\n  while nCount<3\nend");
    let run = folder.val3(&["check", "--format", "concise"]);
    assert_eq!(run.code, 1, "{run:?}");
    assert_eq!(run.stdout.matches("V0014").count(), 1, "{run:?}");
    assert!(run.stdout.contains("a `do` block ends with `until`, not with `while`"), "{run:?}");
    let fixed = folder.val3(&["check", "--fix", "--unsafe-fixes"]);
    assert_eq!(fixed.code, 0, "{fixed:?}");
    let program = folder.read("usrapp/main/start.pgx");
    assert!(program.contains("  until !(nCount&lt;3)") || program.contains("  until !(nCount<3)"), "{program}");
}

#[test]
fn the_changes_for_another_version_are_reported() {
    let folder = Folder::with(
        "version s7.11\nprogram start()\nbegin\n  cls()\n  put(1)\nend\n--- other\nversion s6.8\nprogram start()\nbegin\nend",
    );
    assert_eq!(folder.val3(&["check", "usrapp/main"]).stdout.matches("V054").count(), 0);
    let run = folder.val3(&["check", "usrapp/main", "--for", "s8.10", "--format", "concise"]);
    assert_eq!(run.code, 0, "{run:?}");
    assert_eq!(run.stdout.matches("warning[V0540]").count(), 2, "{run:?}");
    let run = folder.val3(&["check", "usrapp/main", "--for", "s6.8", "--format", "concise"]);
    assert!(run.stdout.contains("warning[V0542] the files have the form of s7, and s6.8 reads that of"), "{run:?}");
    folder.write("val3.toml", "[lint]\ntarget-version = \"s6.8\"\n");
    let configured = folder.val3(&["check", "usrapp/main", "--format", "concise"]);
    assert_eq!(configured.stdout, run.stdout, "the setting and the option agree");
    let run = folder.val3(&["check", "--for", "s9"]);
    assert!(run.code == 2 && run.stderr.contains("write a version from s5 to s8, such as s8.10"), "{run:?}");
}
