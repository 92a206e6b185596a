//! Changes of files, as values.

use camino::Utf8PathBuf;
use val3_analysis::db::File;
use val3_syntax::TextRange;

/// What a refactoring does: edits of texts, then files that get another name.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct SourceChange {
    /// Edits; those of one file do not overlap and stand in order.
    pub edits: Vec<FileEdit>,
    /// Files that move: from where to where.
    pub moves: Vec<(Utf8PathBuf, Utf8PathBuf)>,
}

/// Replaces a range of a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FileEdit {
    /// The file.
    pub file: File,
    /// What is replaced; empty where something is put in.
    pub range: TextRange,
    /// What stands there afterwards, as it is written in the file.
    pub text: String,
}
