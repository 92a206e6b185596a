//! Recorded texts: compared after a test, or recorded once more (`--update`).

use camino::{Utf8Path, Utf8PathBuf};
use val3_analysis::paths::normalise;
use val3_files::{FileClass, Unreadable};
use val3_suite::{Failure, GoldenText, TestCase, TestResult};

use super::cell::check_file;
use super::recorded_file::{RecordedContents, RecordedFile, record};
use crate::user_error::UserError;

/// Compares the texts of a test with the files that its expectations name, or records them there. A difference is added
/// to the failures of the test. Only tests without failures are recorded. Adds the recorded files to `recorded`.
///
/// # Errors
/// A file is outside of the permitted folders, or cannot be written.
pub(super) fn judge(
    case: &TestCase,
    result: &mut TestResult,
    update: bool,
    recorded: &mut Vec<RecordedFile>,
) -> Result<(), UserError> {
    for golden in std::mem::take(&mut result.golden_texts) {
        let path = path(case, &golden)?;
        if let Some(failure) = golden.empty() {
            result.failures.push(failure);
        } else if !update {
            result.failures.extend(compared(&golden, &path));
            continue;
        }
        if update {
            let recording = RecordedContents {
                text: golden.text(),
                is_known: &|text| golden.is_recorded(text),
                kind: "recorded text",
                key: golden.key(),
            };
            let action = match result.has_passed() {
                true => record(&path, &recording)?,
                false => "not recorded, because the test has failed:",
            };
            recorded.push(RecordedFile { path, action });
        }
    }
    Ok(())
}

/// Compares the texts of a test with the files that its expectations name, and writes nothing.
///
/// # Errors
/// A file is outside of the permitted folders.
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
