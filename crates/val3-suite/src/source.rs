//! Locations of expectations in their file.

use std::ops::Range;

use val3_lines::LineIndex;

use crate::failure::FailureLocation;

/// A file with expectations.
#[derive(Debug, Clone)]
pub(crate) struct ExpectationSource {
    path: String,
    lines: LineIndex,
}

impl Default for ExpectationSource {
    fn default() -> Self {
        Self::new("", "")
    }
}

impl ExpectationSource {
    pub(crate) fn new(path: &str, text: &str) -> Self {
        Self { path: path.to_owned(), lines: LineIndex::new(text) }
    }

    /// Line number of a range in the text, from 1.
    pub(crate) fn line(&self, range: Range<usize>) -> u32 {
        u32::try_from(self.lines.line(range.start) + 1).unwrap_or(u32::MAX)
    }

    /// An expectation's place: a key such as `expect.screen` with its line.
    pub(crate) fn place(&self, key: &str, range: Range<usize>) -> FailureLocation {
        FailureLocation { program: key.to_owned(), file: self.path.clone(), line: self.line(range) }
    }
}
