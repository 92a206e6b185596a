//! A file that is read from the standard input.

use std::io::{self, Read as _};

use camino::{Utf8Path, Utf8PathBuf};
use val3_analysis::paths::normalise;

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
        let mut bytes = Vec::new();
        io::stdin()
            .read_to_end(&mut bytes)
            .map_err(|error| UserError::new(format!("cannot read the standard input: {error}")))?;
        Ok(Self { path: normalise(&current_folder()?.join(path)), bytes })
    }
}
