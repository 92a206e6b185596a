//! Files about a run.

use std::fs::File;
use std::io;

use camino::Utf8Path;

use crate::user_error::UserError;

/// Creates a file.
pub(super) fn create(path: &Utf8Path, what: &str) -> Result<File, UserError> {
    File::create(path).map_err(|error| refused(path, what, &error))
}

/// The message about a file that cannot be written.
pub(super) fn refused(path: &Utf8Path, what: &str, error: &io::Error) -> UserError {
    UserError::new(format!("cannot write the {what} to `{path}`: {error}"))
        .with_help("name a file in an existing folder that you may write to")
}
