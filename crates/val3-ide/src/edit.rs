//! Changes of files, as values.

use camino::Utf8PathBuf;
use val3_analysis::db::{Db, File, FileRange};
use val3_syntax::{TextRange, TextSize};

/// What a refactoring does: new files, then edits of texts, then files that get another name, then files that go.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct SourceChange {
    /// Files that are created, with their text. None of them exists.
    pub creates: Vec<(Utf8PathBuf, String)>,
    /// Edits. Those of one file are sorted and do not overlap.
    pub edits: Vec<FileEdit>,
    /// Files that move: from where to where.
    pub moves: Vec<(Utf8PathBuf, Utf8PathBuf)>,
    /// Files that go.
    pub deletes: Vec<Utf8PathBuf>,
    /// The place of a name that was made up, in the text after the edits.
    pub new_name: Option<FileRange>,
    /// The place of an expression that the user replaces, in the text after the edits.
    pub placeholder: Option<FileRange>,
}

/// Replaces a range of a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FileEdit {
    /// The file.
    pub file: File,
    /// The replaced range; empty for an insertion.
    pub range: TextRange,
    /// The new text, as it is written in the file.
    pub text: String,
}

impl SourceChange {
    /// A change of texts alone.
    pub(crate) fn of(edits: impl IntoIterator<Item = FileEdit>) -> Self {
        Self { edits: edits.into_iter().collect(), ..Self::default() }
    }

    /// The same, which made up the name that the edit at `start` writes first.
    pub(crate) fn with_new_name(mut self, file: File, start: TextSize, name: &str) -> Self {
        self.new_name = self.written(file, start, name);
        self
    }

    /// The same with a placeholder, which the edit at `start` writes first.
    pub(crate) fn with_placeholder(mut self, file: File, start: TextSize, text: &str) -> Self {
        self.placeholder = self.written(file, start, text);
        self
    }

    /// The first place of a text in that of the edit at `start`, after all edits.
    fn written(&self, file: File, start: TextSize, text: &str) -> Option<FileRange> {
        let edits = || self.edits.iter().filter(|edit| edit.file == file);
        let inside = edits().find(|edit| edit.range.start() == start).and_then(|edit| edit.text.find(text))?;
        let before = || edits().filter(|edit| edit.range.start() < start);
        let added: usize = before().map(|edit| edit.text.len()).sum();
        let removed: TextSize = before().map(|edit| edit.range.len()).sum();
        let at = start + TextSize::try_from(added + inside).ok()? - removed;
        Some(FileRange { file, range: TextRange::at(at, TextSize::of(text)) })
    }

    /// The same with its edits in order of file and place, each once.
    pub(crate) fn sorted(mut self, db: &dyn Db) -> Self {
        self.edits.sort_by(|a, b| (a.file.path(db), a.range.start()).cmp(&(b.file.path(db), b.range.start())));
        self.edits.dedup();
        self
    }

    /// It changes nothing.
    pub fn is_empty(&self) -> bool {
        *self == Self::default()
    }
}
