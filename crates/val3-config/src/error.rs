//! Errors in a configuration file.

use std::fmt;
use std::ops::Range;

use camino::Utf8PathBuf;
use val3_lines::LineIndex;

/// An error in a configuration file, with all parts of the message.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ConfigError {
    /// Path of the file.
    pub path: Utf8PathBuf,
    /// Content of the file; empty if the file cannot be read.
    pub text: String,
    /// Byte range of the error; empty for the entire file.
    pub range: Range<usize>,
    /// One sentence that describes the error.
    pub message: String,
    /// A suggestion for the correction; may be empty.
    pub help: String,
}

impl ConfigError {
    /// Returns the line number, from 1.
    pub fn line(&self) -> usize {
        line_of(&self.text, self.range.start)
    }

    /// Returns the line of the error, and the marks below the range.
    fn excerpt(&self) -> Option<(&str, String)> {
        let start = self.text.floor_char_boundary(self.range.start);
        let end = self.text.floor_char_boundary(self.range.end);
        let lines = LineIndex::new(&self.text);
        let line = lines.line_range(lines.line(start))?;
        let before = self.text.get(line.start..start.min(line.end))?;
        let marked = self.text.get(start.min(line.end)..end.clamp(start.min(line.end), line.end))?;
        let blanks: String = before.chars().map(|c| if c == '\t' { '\t' } else { ' ' }).collect();
        Some((self.text.get(line)?, format!("{blanks}{}", "^".repeat(marked.chars().count().max(1)))))
    }
}

impl fmt::Display for ConfigError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.message)?;
        if let Some((line, marks)) = self.excerpt().filter(|_| !self.text.is_empty()) {
            let number = self.line().to_string();
            let margin = " ".repeat(number.len());
            write!(f, "\n{margin}--> {}:{number}\n{margin} |\n{number} | {line}\n{margin} | {marks}", self.path)?;
        }
        if !self.help.is_empty() {
            write!(f, "\n  help: {}", self.help)?;
        }
        Ok(())
    }
}

impl std::error::Error for ConfigError {}

/// Returns the line number of a byte offset, from 1.
pub(crate) fn line_of(text: &str, offset: usize) -> usize {
    LineIndex::new(text).line(offset) + 1
}
