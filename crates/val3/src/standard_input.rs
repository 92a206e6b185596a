//! The standard input, or the file that `--input` names.

use std::io;

use camino::{Utf8Path, Utf8PathBuf};
use val3_analysis::paths::normalise;
use val3_files::FileClass;
use val3_syntax::encoding::decode;

use crate::args::InputArgs;
use crate::paths::current_folder;
use crate::user_error::UserError;

/// A file whose content comes from the standard input.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct StandardInput {
    /// Absolute path without `.` and `..`.
    pub(crate) path: Utf8PathBuf,
    /// Content.
    pub(crate) bytes: Vec<u8>,
}

impl StandardInput {
    /// Reads the standard input as the file at `path`.
    pub(crate) fn read(path: &Utf8Path, input: &InputArgs) -> Result<Self, UserError> {
        Ok(Self { path: normalise(&current_folder()?.join(path)), bytes: bytes(input)? })
    }
}

/// Reads the bytes of the standard input, or of the program or data file in `--input`.
pub(crate) fn bytes(input: &InputArgs) -> Result<Vec<u8>, UserError> {
    match &input.input {
        Some(path) => val3_files::read(path, FileClass::Program)
            .map_err(|reason| UserError::new(format!("cannot read `{path}`: {reason}"))),
        None => val3_files::read_stream(io::stdin(), FileClass::Program)
            .map_err(|reason| UserError::new(format!("cannot read the standard input: {reason}"))),
    }
}

/// Reads the lines of the standard input, or of the file in `--input`.
pub(crate) fn lines(input: &InputArgs) -> Result<Box<dyn Iterator<Item = io::Result<String>>>, UserError> {
    if input.input.is_none() {
        return Ok(Box::new(io::stdin().lines()));
    }
    let text = decode(bytes(input)?).text;
    let lines: Vec<_> = text.lines().map(|line| Ok(line.to_owned())).collect();
    Ok(Box::new(lines.into_iter()))
}
