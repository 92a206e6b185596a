//! What is wrong with a configuration file.

use std::fmt;
use std::ops::Range;

use camino::Utf8PathBuf;

/// A fault of a configuration file, for the person who wrote it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ConfigError {
    /// The file.
    pub path: Utf8PathBuf,
    /// Its text; empty where it cannot be read.
    pub text: String,
    /// Bytes of the text; empty where the whole file is meant.
    pub range: Range<usize>,
    /// What is wrong, in one sentence.
    pub message: String,
    /// What to write instead; may be empty.
    pub help: String,
}

impl ConfigError {
    /// The line of the fault, from 1.
    pub fn line(&self) -> usize {
        line_of(&self.text, self.range.start)
    }

    /// The line with the fault, and marks below the part that is meant.
    fn excerpt(&self) -> Option<(&str, String)> {
        let start = self.text.floor_char_boundary(self.range.start);
        let before = self.text.get(..start)?.rsplit('\n').next()?;
        let rest = self.text.get(start..)?.lines().next().unwrap_or("");
        let line = self.text.get(start - before.len()..start + rest.len())?;
        let end = self.text.floor_char_boundary(self.range.end);
        let meant = self.text.get(start..end)?.lines().next().unwrap_or("");
        let blanks: String = before.chars().map(|c| if c == '\t' { '\t' } else { ' ' }).collect();
        Some((line, format!("{blanks}{}", "^".repeat(meant.chars().count().max(1)))))
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

/// The line of an offset, from 1.
pub(crate) fn line_of(text: &str, offset: usize) -> usize {
    1 + text.bytes().take(offset).filter(|byte| *byte == b'\n').count()
}
