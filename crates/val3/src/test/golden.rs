//! Recorded motion: compared after a test, or recorded once more (`--update`).

use std::fs;

use camino::{Utf8Path, Utf8PathBuf};
use val3_analysis::paths::normalise;
use val3_files::{FileClass, Unreadable, replace};
use val3_suite::{Judgement, RecordedMotion, TestCase, TestResult};
use val3_trace::is_recording;

use super::cell::check_file;
use super::recorded_file::{RecordedContents, RecordedFile, record, refused};
use super::tested::FinishedTest;
use crate::output::to_stderr;
use crate::paths::Paths;
use crate::user_error::UserError;

/// First bytes of a picture.
const PICTURE: &[u8] = b"<svg";

/// Expectation that names the file.
const KEY: &str = "expect.trace";

/// Compares the motion of a test with the file that its expectation names, or records it there. A difference is added
/// to the failures of the test. Only tests without failures are recorded.
///
/// # Errors
/// The file is outside of the permitted folders, or a file cannot be written.
pub(super) fn judge(case: &TestCase, result: &mut TestResult, update: bool) -> Result<Option<RecordedFile>, UserError> {
    let Some(motion) = result.motion.take() else { return Ok(None) };
    let folder = Utf8Path::new(&case.file).parent().unwrap_or(Utf8Path::new("."));
    let path = folder.join(motion.file());
    check_file(folder, &normalise(&path), KEY)?;
    if let Some(failure) = motion.at_rest() {
        result.failures.push(failure);
        remove_picture(&path)?;
        return Ok(update.then_some(RecordedFile { path, action: "not recorded, because the arm has not moved:" }));
    }
    if !update {
        compare(&motion, &path, result)?;
        return Ok(None);
    }
    if !result.has_passed() {
        return Ok(Some(RecordedFile { path, action: "not recorded, because the test has failed:" }));
    }
    let recording =
        RecordedContents { text: motion.text(), is_known: &is_recording, kind: "recorded motion", key: KEY };
    let action = record(&path, &recording)?;
    remove_picture(&path)?;
    Ok(Some(RecordedFile { path, action }))
}

/// Compares the motion of a test with the file that its expectation names, and writes nothing. A difference is added to
/// the failures of the test.
///
/// # Errors
/// The file is outside of the permitted folders.
pub(super) fn judge_only(case: &TestCase, result: &mut TestResult) -> Result<(), UserError> {
    let Some(motion) = result.motion.take() else { return Ok(()) };
    let folder = Utf8Path::new(&case.file).parent().unwrap_or(Utf8Path::new("."));
    let path = folder.join(motion.file());
    check_file(folder, &normalise(&path), KEY)?;
    result.failures.extend(motion.at_rest().or_else(|| judgement(&motion, &path).failure));
    Ok(())
}

fn judgement(motion: &RecordedMotion, path: &Utf8Path) -> Judgement {
    match val3_files::read_text(path, FileClass::Record) {
        Ok(text) => motion.judge(&text),
        Err(Unreadable::Missing) => motion.missing().into(),
        Err(reason) => motion.refused(&reason.to_string()).into(),
    }
}

/// Compares a motion with its file, and draws both if they differ.
fn compare(motion: &RecordedMotion, path: &Utf8Path, result: &mut TestResult) -> Result<(), UserError> {
    let judgement = judgement(motion, path);
    result.failures.extend(judgement.failure);
    match judgement.picture {
        None => remove_picture(path),
        Some(svg) => {
            if let Some(failure) = result.failures.last_mut() {
                failure.message += &format!("\nboth motions: {}", picture(motion.file().into()));
            }
            let path = picture(path);
            is_picture(&path)?;
            replace(&path, svg.as_bytes()).map_err(|reason| refused(&path, KEY, &reason))?;
            result.picture = Some(svg);
            Ok(())
        }
    }
}

/// Picture of a motion that differs from its file.
fn picture(path: &Utf8Path) -> Utf8PathBuf {
    path.with_extension("failed.svg")
}

/// Whether a picture exists that may be replaced or removed.
///
/// # Errors
/// The file at this path is no picture, or cannot be read.
fn is_picture(path: &Utf8Path) -> Result<bool, UserError> {
    match val3_files::read_head(path, PICTURE.len() as u64) {
        Ok(head) if head == PICTURE => Ok(true),
        Ok(_) => Err(refused(path, KEY, &"it exists and is no picture of motions; remove it, or rename it")),
        Err(Unreadable::Missing) => Ok(false),
        Err(reason) => Err(refused(path, KEY, &reason)),
    }
}

fn remove_picture(path: &Utf8Path) -> Result<(), UserError> {
    let path = picture(path);
    match is_picture(&path)? {
        true => fs::remove_file(&path).map_err(|error| refused(&path, KEY, &error)),
        false => Ok(()),
    }
}

/// Reports the files that `--update` has written.
pub(super) fn report(tested: &[FinishedTest], paths: &Paths) {
    for RecordedFile { path, action } in tested.iter().flat_map(|test| &test.recorded) {
        to_stderr(|out| writeln!(out, "{action} {}", paths.shown(path.as_path())));
    }
}
