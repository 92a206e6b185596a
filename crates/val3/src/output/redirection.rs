//! `--output FILE`: a file that replaces the standard output of a command.
//!
//! Like the standard output, the file is global to the process, so commands write in the same way with and without the
//! option.

use std::io::{self, Write};
use std::sync::{Mutex, MutexGuard, PoisonError};

use camino::{Utf8Path, Utf8PathBuf};
use val3_files::OutputFile;

use super::file;
use super::file_kind::OutputFileKind;
use crate::user_error::UserError;

/// File that replaces the standard output.
static FILE: Mutex<Option<Redirection>> = Mutex::new(None);

struct Redirection {
    path: Utf8PathBuf,
    file: OutputFile,
}

fn redirection() -> MutexGuard<'static, Option<Redirection>> {
    FILE.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Redirects the standard output to a file, which replaces `path` atomically when it is committed.
///
/// # Errors
/// The file cannot be written, or has other content.
pub(crate) fn redirect(path: &Utf8Path, kind: OutputFileKind) -> Result<(), UserError> {
    let file = file::create(path, kind, "output")?;
    *redirection() = Some(Redirection { path: path.to_owned(), file });
    Ok(())
}

/// Completes the file, if the output is redirected.
///
/// # Errors
/// The file cannot be written.
pub(crate) fn commit() -> Result<(), UserError> {
    let Some(Redirection { path, file }) = redirection().take() else { return Ok(()) };
    file.commit().map_err(|reason| file::refused(&path, "output", &reason))
}

/// Writes to the file; `None` if the standard output is not redirected.
pub(super) fn write(write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Option<Result<(), UserError>> {
    let mut guard = redirection();
    let Redirection { path, file } = guard.as_mut()?;
    Some(write(file).map_err(|error| file::refused(path, "output", &error)))
}

/// Whether the standard output is redirected to a file.
pub(super) fn is_redirected() -> bool {
    redirection().is_some()
}
