//! Git repositories in temporary folders.

use std::process::Command;

use crate::support::{CommandOutput, Folder, run};

/// Runs git without the machine's settings, and with the tested `val3` in PATH.
pub(crate) fn git(folder: &Folder, arguments: &[&str]) -> CommandOutput {
    let mut command = Command::new("git");
    command.args(arguments).current_dir(folder.path());
    let commands = std::path::Path::new(env!("CARGO_BIN_EXE_val3")).parent().unwrap();
    command.env("PATH", format!("{}:{}", commands.display(), std::env::var_os("PATH").unwrap().display()));
    for (name, value) in [
        ("GIT_CONFIG_GLOBAL", "/dev/null"),
        ("GIT_CONFIG_SYSTEM", "/dev/null"),
        ("GIT_PAGER", "cat"),
        ("GIT_EDITOR", "true"),
        ("GIT_AUTHOR_NAME", "a"),
        ("GIT_AUTHOR_EMAIL", "a@localhost"),
        ("GIT_COMMITTER_NAME", "a"),
        ("GIT_COMMITTER_EMAIL", "a@localhost"),
    ] {
        command.env(name, value);
    }
    run(command)
}

/// Runs git, which must not fail; a difference or a conflict is no failure.
#[track_caller]
pub(crate) fn git_ok(folder: &Folder, arguments: &[&str]) -> CommandOutput {
    let found = git(folder, arguments);
    assert!(found.code <= 1, "{arguments:?} {found:?}");
    found
}

/// Commits all files.
pub(crate) fn commit(folder: &Folder, message: &str) {
    git_ok(folder, &["add", "-A"]);
    git_ok(folder, &["commit", "-qm", message]);
}
