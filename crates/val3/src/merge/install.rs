//! Setup of git: the files that `val3 merge` merges, and its command line.

use std::process::{Command, Output, Stdio};

use camino::{Utf8Path, Utf8PathBuf};
use val3_files::{FileClass, Unreadable};

use crate::color::Color;
use crate::output::{OutputContent, to_stdout_as};
use crate::user_error::UserError;

/// Extensions of merged files.
const EXTENSIONS: [&str; 4] = ["dtx", "pjx", "pgx", "cfx"];

/// Repository settings: the driver's displayed name, and its command with the three versions and the path.
const SETTINGS: [(&str, &str); 2] =
    [("merge.val3.name", "val3 merge"), ("merge.val3.driver", "val3 merge --path=%P %O %A %B")];

/// Sets up the repository that contains a folder, and reports each change.
pub(super) fn run(folder: &Utf8Path) -> Result<(), UserError> {
    let root = successful(git(folder, &["rev-parse", "--show-toplevel"])?, folder)?;
    let root = Utf8PathBuf::from(root.trim_end_matches(['\n', '\r']));
    let mut report = attributes(&root)?;
    for (name, value) in SETTINGS {
        let known = git(&root, &["config", "--local", "--get", name])?;
        if String::from_utf8_lossy(&known.stdout).trim_end() != value {
            successful(git(&root, &["config", "--local", name, value])?, &root)?;
            report.push(format!("configuration of the repository: {name} = {value}"));
        }
    }
    if report.is_empty() {
        report.push("git merges the files of this repository with `val3 merge` already".to_owned());
    }
    to_stdout_as(OutputContent::Words, Color::Never, |out| report.iter().try_for_each(|line| writeln!(out, "{line}")))
}

/// Adds the missing lines to `.gitattributes`, and returns them.
fn attributes(root: &Utf8Path) -> Result<Vec<String>, UserError> {
    let path = root.join(".gitattributes");
    let mut missing = Vec::new();
    for extension in EXTENSIONS {
        let found = successful(git(root, &["check-attr", "merge", "--", &format!("any.{extension}")])?, root)?;
        if !found.trim_end().ends_with(": merge: val3") {
            missing.push(format!("*.{extension} merge=val3"));
        }
    }
    if missing.is_empty() {
        return Ok(missing);
    }
    let old = match val3_files::read(&path, FileClass::Settings) {
        Ok(bytes) => bytes,
        Err(Unreadable::Missing) => Vec::new(),
        Err(reason) => return Err(UserError::new(format!("cannot read `{path}`: {reason}"))),
    };
    let separator = if old.is_empty() || old.ends_with(b"\n") { "" } else { "\n" };
    let new = [old.as_slice(), separator.as_bytes(), missing.join("\n").as_bytes(), b"\n"].concat();
    val3_files::replace(&path, &new).map_err(|reason| UserError::new(format!("cannot write `{path}`: {reason}")))?;
    Ok(missing.into_iter().map(|line| format!(".gitattributes: {line}")).collect())
}

fn git(folder: &Utf8Path, arguments: &[&str]) -> Result<Output, UserError> {
    let mut command = Command::new("git");
    command.args(["-c", "core.fsmonitor=false", "-C", folder.as_str()]).args(arguments);
    command
        .env("LC_ALL", "C")
        .stdin(Stdio::null())
        .output()
        .map_err(|error| UserError::new(format!("cannot start git: {error}")).with_help("install git, and try again"))
}

/// Returns the standard output, or an error if the command has failed.
fn successful(output: Output, folder: &Utf8Path) -> Result<String, UserError> {
    if output.status.success() {
        return Ok(String::from_utf8_lossy(&output.stdout).into_owned());
    }
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    let error =
        UserError::new(format!("git cannot set up `{folder}`: {}", message.trim().trim_start_matches("fatal: ")));
    Err(error.with_help("run `val3 merge --install` in the working tree of a repository"))
}
