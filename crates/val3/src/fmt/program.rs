//! One program with its layout.

use camino::Utf8PathBuf;
use val3_files::{FileClass, replace_unchanged};
use val3_fmt::{Style, apply, format};
use val3_syntax::document;
use val3_syntax::encoding::{Encoding, decode};
use val3_syntax::foreign::ForeignContent;

use super::bare;
use crate::fixing::{encoded, unencodable};
use crate::user_error::UserError;
use crate::write_scope::WriteScope;

/// A program before and after.
pub(super) struct Formatted {
    path: Utf8PathBuf,
    /// The path as people open it.
    pub(super) shown: String,
    /// The text as it was read.
    pub(super) before: String,
    /// The text with its layout.
    pub(super) after: String,
    /// Some of the code cannot be read.
    pub(super) left_alone: bool,
    bytes: Vec<u8>,
    encoding: Encoding,
}

impl Formatted {
    /// The layout of the program in `bytes`, in memory.
    ///
    /// # Errors
    /// The bytes are no text, or the elements of the file cannot be told apart.
    pub(super) fn new(path: Utf8PathBuf, shown: String, bytes: Vec<u8>, style: &Style) -> Result<Self, UserError> {
        if let Some(foreign) = ForeignContent::of(&bytes) {
            return Err(UserError::new(format!("cannot read `{shown}`: {foreign}")));
        }
        let decoded = decode(bytes.clone());
        let parse = val3_syntax::parse(&decoded.text);
        if let Some(fault) = document::fault(&decoded.text, parse.errors()) {
            let error = UserError::new(format!("cannot format `{shown}`: {fault}"));
            return Err(error.with_help("`val3 check` shows the place"));
        }
        let after = apply(&decoded.text, &format(&decoded.text, &parse, style));
        let left_alone = !parse.errors().is_empty();
        Ok(Self { path, shown, before: decoded.text, after, left_alone, bytes, encoding: decoded.encoding })
    }

    /// As [`Self::new`], for a program or for its code alone, as the standard input may hold it.
    ///
    /// # Errors
    /// If the bytes are neither.
    pub(super) fn of_stream(
        path: Utf8PathBuf,
        shown: String,
        bytes: Vec<u8>,
        style: &Style,
    ) -> Result<Self, UserError> {
        let decoded = decode(bytes.clone());
        if !bare::is_bare(&decoded.text) {
            return Self::new(path, shown, bytes, style);
        }
        let (after, left_alone) = bare::format(&decoded.text, style).ok_or_else(no_program)?;
        Ok(Self { path, shown, before: decoded.text, after, left_alone, bytes, encoding: decoded.encoding })
    }

    /// Whether the layout changes.
    pub(super) fn changes(&self) -> bool {
        self.before != self.after
    }

    /// The program as the file holds it.
    ///
    /// # Errors
    /// If its encoding cannot be written.
    pub(super) fn bytes(&self) -> Result<Vec<u8>, UserError> {
        if !self.changes() {
            return Ok(self.bytes.clone());
        }
        encoded(self.encoding, &self.after).ok_or_else(|| unencodable(&self.shown))
    }

    /// Checks that the file may be changed if it has to be.
    ///
    /// # Errors
    /// It is outside of the scope.
    pub(super) fn check_scope(&self, scope: &WriteScope) -> Result<(), UserError> {
        if self.changes() { scope.check(&self.path, &self.shown) } else { Ok(()) }
    }

    /// Replaces the file where it changes.
    ///
    /// # Errors
    /// If it cannot be written.
    pub(super) fn write(&self) -> Result<(), UserError> {
        if !self.changes() {
            return Ok(());
        }
        replace_unchanged(&self.path, FileClass::Program, &self.bytes, &self.bytes()?)
            .map_err(|reason| UserError::new(format!("cannot write `{}`: {reason}", self.shown)))
    }
}

fn no_program() -> UserError {
    UserError::new("the standard input is not a VAL 3 program: it is not XML, and does not start with `begin`")
        .with_help("pass a whole `.pgx`, or its code from `begin` to `end`")
}
