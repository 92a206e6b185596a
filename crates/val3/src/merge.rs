//! `val3 merge`: three-way merge of one file, also as git's merge driver.

mod contents;
mod install;
mod report;

use std::process::ExitCode;

use camino::Utf8Path;
use val3_files::{FileClass, Unreadable};
use val3_merge::MergedKind;

use self::contents::merge;
pub(crate) use self::report::write_unmerged;
use crate::args::MergeArgs;
use crate::color::Color;
use crate::output::{OutputContent, to_stderr, to_stdout_as};
use crate::paths::current_folder;
use crate::user_error::UserError;

/// Exit code of a merge driver that has failed. From 129 on, git aborts the merge instead of recording a conflict (git 2.39
/// records one nevertheless).
const EXIT_FAILED: u8 = 129;

/// Paths that mean a base that does not exist.
const ABSENT: [&str; 3] = ["/dev/null", "NUL", "nul"];

/// File kinds by root element.
const ROOTS: [(&str, MergedKind); 6] = [
    ("<Programs", MergedKind::Program),
    ("<programList", MergedKind::Program),
    ("<Database", MergedKind::Data),
    ("<dataList", MergedKind::Data),
    ("<Project", MergedKind::Project),
    ("<project", MergedKind::Project),
];

/// Runs the command. The exit code states whether conflicts remain.
///
/// # Errors
/// The driver cannot be installed.
pub(crate) fn run(args: &MergeArgs) -> Result<ExitCode, UserError> {
    if args.install {
        return install::run(&current_folder()?).map(|()| ExitCode::SUCCESS);
    }
    // git would interpret the usual exit code of an error as a conflict.
    merge_files(args).or_else(|error| {
        to_stderr(|out| writeln!(out, "{error}"));
        Ok(ExitCode::from(EXIT_FAILED))
    })
}

fn merge_files(args: &MergeArgs) -> Result<ExitCode, UserError> {
    let [base, ours, theirs] = args.files.as_slice() else {
        return Err(UserError::new("three versions are needed: BASE OURS THEIRS"));
    };
    let current = current_folder()?;
    let versions = [read(&current, base, true)?, read(&current, ours, false)?, read(&current, theirs, false)?];
    let name = args.path.as_ref().unwrap_or(ours);
    let kind = kind(name, &versions);
    let outcome = merge(kind, &versions);
    report::write(&outcome, name, kind);
    let [_, old, _] = &versions;
    if args.stdout {
        to_stdout_as(OutputContent::File, Color::Never, |out| out.write_all(&outcome.bytes))?;
    } else if outcome.bytes != *old {
        let written = val3_files::replace(&current.join(ours), &outcome.bytes);
        written.map_err(|reason| UserError::new(format!("cannot write `{ours}`: {reason}")))?;
    }
    Ok(if outcome.is_clean() { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// Merges the versions of a file, BASE, OURS and THEIRS, and reports the result. Returns the merged content, and whether
/// it has all changes.
///
/// Returns `None`, after a report, for a file that is not merged: marks of conflicts would destroy a file of another kind,
/// and no check would find them.
pub(crate) fn merge_versions(name: &Utf8Path, versions: &[Vec<u8>; 3]) -> Option<(Vec<u8>, bool)> {
    let Some(kind) = MergedKind::of_name(name.as_str()) else {
        write_unmerged(name, "only data, programs, projects and settings are merged");
        return None;
    };
    let outcome = merge(kind, versions);
    match outcome.unmarked(kind, name.extension().unwrap_or_default()) {
        Some(reason) => {
            write_unmerged(name, &reason);
            None
        }
        None => {
            report::write(&outcome, name, kind);
            let is_clean = outcome.is_clean();
            Some((outcome.bytes, is_clean))
        }
    }
}

fn read(current: &Utf8Path, path: &Utf8Path, is_base: bool) -> Result<Vec<u8>, UserError> {
    if is_base && ABSENT.contains(&path.as_str()) {
        return Ok(Vec::new());
    }
    val3_files::read(&current.join(path), FileClass::Program).map_err(|reason| match reason {
        Unreadable::Missing => UserError::new(format!("`{path}`: there is no such file"))
            .with_help("name three versions of one file: `val3 merge BASE OURS THEIRS`"),
        reason => UserError::new(format!("cannot read `{path}`: {reason}")),
    })
}

/// File kind according to the name, or to the root element if a temporary file has another name.
fn kind(name: &Utf8Path, versions: &[Vec<u8>; 3]) -> MergedKind {
    let by_name = MergedKind::of_name(name.as_str());
    by_name.or_else(|| versions.iter().find_map(|bytes| kind_of_root(bytes))).unwrap_or(MergedKind::Settings)
}

/// File kind according to the root element, which begins in the first 2,000 bytes.
fn kind_of_root(bytes: &[u8]) -> Option<MergedKind> {
    let head = String::from_utf8_lossy(bytes.get(..2000).unwrap_or(bytes));
    ROOTS.iter().find(|(root, _)| head.contains(root)).map(|(_, kind)| *kind)
}
