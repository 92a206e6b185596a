//! Output files that the command line names.

use std::fmt::Display;

use camino::Utf8Path;
use val3_files::{LogFile, OutputFile};

use super::file_kind::{OutputFileKind, check_replaceable};
use crate::user_error::UserError;

/// Creates a file that replaces `path` atomically when it is committed. `what` names it in messages.
pub(crate) fn create(path: &Utf8Path, content: OutputFileKind, what: &str) -> Result<OutputFile, UserError> {
    check_replaceable(path, content, what)?;
    OutputFile::open(path).map_err(|reason| refused(path, what, &reason))
}

/// Creates a file that grows while the command runs.
pub(crate) fn create_log(path: &Utf8Path, content: OutputFileKind, what: &str) -> Result<LogFile, UserError> {
    check_replaceable(path, content, what)?;
    LogFile::open(path).map_err(|reason| refused(path, what, &reason))
}

/// Error for a file that cannot be written.
pub(crate) fn refused(path: &Utf8Path, what: &str, reason: &dyn Display) -> UserError {
    UserError::new(format!("cannot write the {what} to `{path}`: {reason}"))
        .with_help("name a file in an existing folder that you may write to")
}
