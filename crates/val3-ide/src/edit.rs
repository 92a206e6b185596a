//! File changes as values.

use camino::Utf8PathBuf;
pub use val3_analysis::db::FileEdit;
use val3_analysis::db::{Db, File, FileRange};
use val3_syntax::{TextRange, TextSize};

/// Change made by a refactoring. It is applied in this order: create files, edit texts, move files, delete files.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct SourceChange {
    /// Files to create, with their text. None of them exists.
    pub creates: Vec<(Utf8PathBuf, String)>,
    /// Text edits. The edits of a file are sorted and do not overlap.
    pub edits: Vec<FileEdit>,
    /// Files to move: old and new path.
    pub moves: Vec<(Utf8PathBuf, Utf8PathBuf)>,
    /// Files to delete.
    pub deletes: Vec<Utf8PathBuf>,
    /// Range of a generated name, in the text after the edits.
    pub new_name: Option<FileRange>,
    /// Range of a placeholder expression that the user replaces, in the text after the edits.
    pub placeholder: Option<FileRange>,
}

impl SourceChange {
    /// A change that consists only of text edits.
    pub(crate) fn of(edits: impl IntoIterator<Item = FileEdit>) -> Self {
        Self { edits: edits.into_iter().collect(), ..Self::default() }
    }

    /// Sets the range of a generated name: its first occurrence in the edit at `start`.
    pub(crate) fn with_new_name(mut self, file: File, start: TextSize, name: &str) -> Self {
        self.new_name = self.written(file, start, name);
        self
    }

    /// Sets the range of a placeholder: its first occurrence in the edit at `start`.
    pub(crate) fn with_placeholder(mut self, file: File, start: TextSize, text: &str) -> Self {
        self.placeholder = self.written(file, start, text);
        self
    }

    /// First occurrence of a text in the edit at `start`, as a range after all edits.
    fn written(&self, file: File, start: TextSize, text: &str) -> Option<FileRange> {
        let edits = || self.edits.iter().filter(|edit| edit.file == file);
        let inside = edits().find(|edit| edit.range.start() == start).and_then(|edit| edit.text.find(text))?;
        let before = || edits().filter(|edit| edit.range.start() < start);
        let added: usize = before().map(|edit| edit.text.len()).sum();
        let removed: TextSize = before().map(|edit| edit.range.len()).sum();
        let at = start + TextSize::try_from(added + inside).ok()? - removed;
        Some(FileRange { file, range: TextRange::at(at, TextSize::of(text)) })
    }

    /// Sorts the edits by file and offset, and removes duplicates.
    pub(crate) fn sorted(mut self, db: &dyn Db) -> Self {
        self.edits.sort_by(|a, b| (a.file.path(db), a.range.start()).cmp(&(b.file.path(db), b.range.start())));
        self.edits.dedup();
        self
    }

    /// Whether it changes nothing.
    pub fn is_empty(&self) -> bool {
        *self == Self::default()
    }
}
