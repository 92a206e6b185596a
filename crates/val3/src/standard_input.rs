//! A file that is read from the standard input.

use std::io;

use camino::{Utf8Path, Utf8PathBuf};
use val3_analysis::paths::normalise;
use val3_files::FileClass;

use crate::paths::current_folder;
use crate::user_error::UserError;

/// A file that is read from the standard input.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct StandardInput {
    /// Its path, absolute and without `.` and `..`.
    pub(crate) path: Utf8PathBuf,
    /// Its content.
    pub(crate) bytes: Vec<u8>,
}

impl StandardInput {
    /// Reads the standard input as the file at `path`.
    pub(crate) fn read(path: &Utf8Path) -> Result<Self, UserError> {
        Ok(Self { path: normalise(&current_folder()?.join(path)), bytes: bytes()? })
    }
}

/// The bytes of the standard input, which is a program or a data file.
pub(crate) fn bytes() -> Result<Vec<u8>, UserError> {
    val3_files::read_stream(io::stdin(), FileClass::Program)
        .map_err(|reason| UserError::new(format!("cannot read the standard input: {reason}")))
}
