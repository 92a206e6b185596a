//! Formats one program.

use camino::Utf8PathBuf;
use val3_files::{FileClass, replace_unchanged};
use val3_fmt::{CodeStyle, format};
use val3_syntax::encoding::{Encoding, decode};
use val3_syntax::foreign::ForeignContent;
use val3_syntax::{TextEdit, document};

use super::bare;
use crate::fixing::{encoded, unencodable};
use crate::user_error::UserError;
use crate::write_scope::WriteScope;

/// A program before and after formatting.
pub(super) struct Formatted {
    path: Utf8PathBuf,
    /// Path as the user would open it.
    pub(super) shown: String,
    /// Text before formatting.
    pub(super) before: String,
    /// Formatted text.
    pub(super) after: String,
    /// Whether code with syntax errors was not formatted.
    pub(super) left_alone: bool,
    bytes: Vec<u8>,
    encoding: Encoding,
}

impl Formatted {
    /// Formats the program in `bytes`, in memory.
    ///
    /// # Errors
    /// The bytes are no text, or the XML elements cannot be separated.
    pub(super) fn new(path: Utf8PathBuf, shown: String, bytes: Vec<u8>, style: &CodeStyle) -> Result<Self, UserError> {
        if let Some(foreign) = ForeignContent::of(&bytes) {
            return Err(UserError::new(format!("cannot read `{shown}`: {foreign}")));
        }
        let decoded = decode(bytes.clone());
        let parse = val3_syntax::parse(&decoded.text);
        if let Some(fault) = document::fault(&decoded.text, parse.errors()) {
            let error = UserError::new(format!("cannot format `{shown}`: {fault}"));
            return Err(error.with_help("`val3 check` shows the place"));
        }
        let after = TextEdit::apply_all(&decoded.text, &format(&decoded.text, &parse, style));
        let left_alone = !parse.errors().is_empty();
        Ok(Self { path, shown, before: decoded.text, after, left_alone, bytes, encoding: decoded.encoding })
    }

    /// As [`Self::new`], for a program or code without XML from the standard input.
    ///
    /// # Errors
    /// The bytes are neither a program nor code.
    pub(super) fn of_stream(
        path: Utf8PathBuf,
        shown: String,
        bytes: Vec<u8>,
        style: &CodeStyle,
    ) -> Result<Self, UserError> {
        let decoded = decode(bytes.clone());
        if !bare::is_bare(&decoded.text) {
            return Self::new(path, shown, bytes, style);
        }
        let (after, left_alone) = bare::format(&decoded.text, style).ok_or_else(no_program)?;
        Ok(Self { path, shown, before: decoded.text, after, left_alone, bytes, encoding: decoded.encoding })
    }

    /// Whether formatting changes the program.
    pub(super) fn changes(&self) -> bool {
        self.before != self.after
    }

    /// Returns the encoded program.
    ///
    /// # Errors
    /// The encoding cannot represent the text.
    pub(super) fn bytes(&self) -> Result<Vec<u8>, UserError> {
        if !self.changes() {
            return Ok(self.bytes.clone());
        }
        encoded(self.encoding, &self.after).ok_or_else(|| unencodable(&self.shown))
    }

    /// Checks that the command may change the file, if formatting changes it.
    ///
    /// # Errors
    /// The file is outside of the scope.
    pub(super) fn check_scope(&self, scope: &WriteScope) -> Result<(), UserError> {
        if self.changes() { scope.check(&self.path, &self.shown) } else { Ok(()) }
    }

    /// Replaces the file if formatting changes it.
    ///
    /// # Errors
    /// The file cannot be written.
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
