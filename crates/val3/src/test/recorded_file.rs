//! Files that `--update` writes: recorded motions and texts.

use std::fmt::Display;
use std::fs;

use camino::{Utf8Path, Utf8PathBuf};
use val3_files::{FileClass, Unreadable, replace};

use crate::user_error::UserError;

/// File that `--update` has written or left unchanged.
pub(super) struct RecordedFile {
    pub(super) path: Utf8PathBuf,
    /// Result in a word, for example `changed:`.
    pub(super) action: &'static str,
}

/// New content of a recorded file.
pub(super) struct RecordedContents<'r> {
    /// Content.
    pub(super) text: String,
    /// Returns whether a text has this kind, so that its file may be replaced.
    pub(super) is_known: &'r dyn Fn(&str) -> bool,
    /// Name of the kind in messages, for example `recorded motion`.
    pub(super) kind: &'static str,
    /// Key of the expectation that names the file.
    pub(super) key: &'static str,
}

/// Writes a file unless it already has this content. Returns the result in a word.
///
/// # Errors
/// The file cannot be written, or its content has another kind.
pub(super) fn record(path: &Utf8Path, recording: &RecordedContents<'_>) -> Result<&'static str, UserError> {
    let RecordedContents { text, is_known, kind, key } = recording;
    let action = match val3_files::read_text(path, FileClass::Record) {
        Ok(known) if known == *text => return Ok("unchanged:"),
        Ok(known) if is_known(&known) => "changed:",
        Ok(_) => {
            let reason = format!("it exists and is no {kind}; remove it, or name another file");
            return Err(refused(path, key, &reason));
        }
        Err(Unreadable::Missing) => "recorded:",
        Err(reason) => return Err(refused(path, key, &reason)),
    };
    path.parent().map_or(Ok(()), fs::create_dir_all).map_err(|error| refused(path, key, &error))?;
    replace(path, text.as_bytes()).map_err(|reason| refused(path, key, &reason))?;
    Ok(action)
}

/// Error for a file that cannot be written. `key` is the expectation that names the file.
pub(super) fn refused(path: &Utf8Path, key: &str, error: &dyn Display) -> UserError {
    UserError::new(format!("cannot write `{path}`: {error}"))
        .with_help(format!("`{key}` names a file of a folder that you may write to"))
}
