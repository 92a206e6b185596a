//! Recorded texts: compared after a test, or recorded again (`--update`).

use std::fmt::Display;
use std::fs;

use camino::{Utf8Path, Utf8PathBuf};
use val3_analysis::paths::normalise;
use val3_files::{FileClass, Unreadable, replace};
use val3_suite::{Failure, GoldenText, TestCase, TestResult};

use super::cell::check_file;
use super::golden::RecordedFile;
use crate::user_error::UserError;

/// Compares the texts of a test with the files that its expectations name, or records them there. A failure becomes one of
/// the test. Only tests without failures are recorded.
///
/// # Errors
/// A file cannot be written.
pub(super) fn judge(case: &TestCase, result: &mut TestResult, update: bool) -> Result<Vec<RecordedFile>, UserError> {
    let mut recorded = Vec::new();
    for golden in std::mem::take(&mut result.golden_texts) {
        let path = path(case, &golden)?;
        if let Some(failure) = golden.empty() {
            result.failures.push(failure);
        } else if !update {
            result.failures.extend(compared(&golden, &path));
            continue;
        }
        if update {
            let action = if result.has_passed() {
                record(&path, &golden)?
            } else {
                "not recorded, because the test has failed:"
            };
            recorded.push(RecordedFile { path, action });
        }
    }
    Ok(recorded)
}

/// Compares the texts of a test with the files that its expectations name, and writes nothing.
///
/// # Errors
/// A file lies where tests have none.
pub(super) fn judge_only(case: &TestCase, result: &mut TestResult) -> Result<(), UserError> {
    for golden in std::mem::take(&mut result.golden_texts) {
        let path = path(case, &golden)?;
        result.failures.extend(golden.empty().or_else(|| compared(&golden, &path)));
    }
    Ok(())
}

fn path(case: &TestCase, golden: &GoldenText) -> Result<Utf8PathBuf, UserError> {
    let folder = Utf8Path::new(&case.file).parent().unwrap_or(Utf8Path::new("."));
    let path = folder.join(golden.file());
    check_file(folder, &normalise(&path), golden.key())?;
    Ok(path)
}

fn compared(golden: &GoldenText, path: &Utf8Path) -> Option<Failure> {
    match val3_files::read_text(path, FileClass::Record) {
        Ok(text) => golden.judge(&text),
        Err(Unreadable::Missing) => Some(golden.missing()),
        Err(reason) => Some(golden.refused(&reason.to_string())),
    }
}

/// Writes a file unless it has this text already. Returns what has happened. A file of another kind stays.
fn record(path: &Utf8Path, golden: &GoldenText) -> Result<&'static str, UserError> {
    let text = golden.text();
    let action = match val3_files::read_text(path, FileClass::Record) {
        Ok(known) if known == text => return Ok("unchanged:"),
        Ok(known) if golden.is_recorded(&known) => "changed:",
        Ok(_) => {
            return Err(refused(path, golden, &"it exists and is no recorded text; remove it, or name another file"));
        }
        Err(Unreadable::Missing) => "recorded:",
        Err(reason) => return Err(refused(path, golden, &reason)),
    };
    path.parent().map_or(Ok(()), fs::create_dir_all).map_err(|error| refused(path, golden, &error))?;
    replace(path, text.as_bytes()).map_err(|reason| refused(path, golden, &reason))?;
    Ok(action)
}

fn refused(path: &Utf8Path, golden: &GoldenText, error: &dyn Display) -> UserError {
    UserError::new(format!("cannot write `{path}`: {error}"))
        .with_help(format!("`{}` names a file of a folder that you may write to", golden.key()))
}
