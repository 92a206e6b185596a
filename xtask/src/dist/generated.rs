//! Shell completions and manual pages, which the packed command writes.

use std::fs;
use std::process::{Command, Stdio};

use anyhow::{Context, bail};
use camino::Utf8Path;

/// Shells, and the files in which they search completions.
const COMPLETIONS: &[(&str, &str)] = &[
    ("bash", "val3.bash"),
    ("elvish", "val3.elv"),
    ("fish", "val3.fish"),
    ("powershell", "_val3.ps1"),
    ("zsh", "_val3"),
];

/// Folders that [`write()`] creates.
pub(super) const FOLDERS: &[&str] = &["completions", "man"];

/// Writes the folders `completions` and `man` into `folder`.
///
/// # Errors
/// The command does not start on this system, or a file cannot be written.
pub(super) fn write(binary: &Utf8Path, folder: &Utf8Path) -> anyhow::Result<()> {
    let completions = folder.join("completions");
    fs::create_dir_all(&completions).with_context(|| format!("cannot make {completions}"))?;
    for (shell, file) in COMPLETIONS {
        let script = output(binary, &["completions", shell])?;
        let path = completions.join(file);
        fs::write(&path, script).with_context(|| format!("cannot write {path}"))?;
    }
    output(binary, &["man", folder.join("man").as_str()])?;
    Ok(())
}

/// Returns the standard output of the packed command.
fn output(binary: &Utf8Path, arguments: &[&str]) -> anyhow::Result<Vec<u8>> {
    let mut command = Command::new(binary);
    command.args(arguments).stderr(Stdio::inherit());
    let output = command.output().with_context(|| {
        format!("cannot start {binary}: the packages of a target are made on a system that runs it")
    })?;
    if !output.status.success() {
        bail!("`{binary} {}` ended with {}", arguments.join(" "), output.status);
    }
    Ok(output.stdout)
}
