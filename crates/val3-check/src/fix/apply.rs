//! Applies fixes to texts.

use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::Arc;

use camino::Utf8PathBuf;
use rustc_hash::FxHashMap;
use val3_analysis::db::{Db, File, FileEdit, FileStatus};
use val3_syntax::encoding::Encoding;

use super::guard::NewText;
use crate::diagnostic::Fix;

/// A file before and after fixes.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FixedFile {
    /// Path.
    pub path: Utf8PathBuf,
    /// Encoding of the file.
    pub encoding: Encoding,
    /// Original text.
    pub before: Arc<str>,
    /// Text with the fixes.
    pub after: Arc<str>,
}

/// Selects fixes that change something and do not touch an earlier fix, so that they can be applied together.
pub(super) fn apart<'f>(fixes: impl IntoIterator<Item = &'f Fix>) -> Vec<&'f Fix> {
    let mut edited = EditedRanges::default();
    let mut chosen = Vec::new();
    for fix in fixes {
        if !fix.edits.is_empty() && !fix.edits.iter().any(|edit| edited.touch(edit)) {
            chosen.push(fix);
            fix.edits.iter().for_each(|edit| edited.add(edit));
        }
    }
    chosen
}

/// Byte ranges of the selected edits in each file: ends by starts.
#[derive(Default)]
struct EditedRanges(FxHashMap<File, BTreeMap<u32, u32>>);

impl EditedRanges {
    fn add(&mut self, edit: &FileEdit) {
        let range = range(edit);
        self.0.entry(edit.file).or_default().insert(range.start, range.end);
    }

    /// Whether one of the ranges overlaps the edit or is adjacent to it.
    fn touch(&self, edit: &FileEdit) -> bool {
        let range = range(edit);
        let before = self.0.get(&edit.file).and_then(|others| others.range(..=range.end).next_back());
        before.is_some_and(|(_, end)| *end >= range.start)
    }
}

fn range(edit: &FileEdit) -> Range<u32> {
    edit.range.start().into()..edit.range.end().into()
}

/// Files that `fixes` edit, unchanged.
pub(super) fn edited_files(db: &dyn Db, fixes: &[&Fix]) -> FxHashMap<File, FixedFile> {
    let files = fixes.iter().flat_map(|fix| &fix.edits).map(|edit| edit.file);
    files.filter_map(|file| Some((file, unchanged(db, file)?))).collect()
}

fn unchanged(db: &dyn Db, file: File) -> Option<FixedFile> {
    let FileStatus::Read { encoding, .. } = file.status(db) else { return None };
    let text = file.text(db);
    let (before, after) = (Arc::clone(text), Arc::clone(text));
    Some(FixedFile { path: file.path(db).clone(), encoding: *encoding, before, after })
}

/// Sets the texts of `files` to the result of exactly these fixes.
pub(super) fn apply(files: &mut FxHashMap<File, FixedFile>, fixes: &[&Fix]) {
    let mut edits = edits_by_file(fixes);
    for (file, fixed) in files {
        fixed.after = match edits.remove(file) {
            Some(edits) => edited(&fixed.before, edits).into(),
            None => Arc::clone(&fixed.before),
        };
    }
}

/// Texts of all files that `fixes` edit, in any encoding.
pub(super) fn new_texts(db: &dyn Db, fixes: &[&Fix]) -> Vec<NewText> {
    let texts = edits_by_file(fixes).into_iter().map(|(file, edits)| {
        let before = Arc::clone(file.text(db));
        NewText { path: file.path(db).clone(), after: edited(&before, edits).into(), before }
    });
    texts.collect()
}

fn edits_by_file<'f>(fixes: &[&'f Fix]) -> FxHashMap<File, Vec<&'f FileEdit>> {
    let mut edits: FxHashMap<File, Vec<&FileEdit>> = FxHashMap::default();
    for edit in fixes.iter().flat_map(|fix| &fix.edits) {
        edits.entry(edit.file).or_default().push(edit);
    }
    edits
}

/// Applies edits that do not overlap to `text`.
fn edited(text: &str, mut edits: Vec<&FileEdit>) -> String {
    edits.sort_by_key(|edit| edit.range.start());
    FileEdit::apply_all(text, edits)
}

#[cfg(test)]
mod tests {
    use camino::Utf8PathBuf;
    use val3_analysis::load::{Workspace, load};
    use val3_analysis::system::Memory;
    use val3_syntax::TextRange;
    use val3_test::{Fixture, ROOT};

    use super::*;

    const PROGRAM: &str = "start.pgx";

    fn workspace() -> Workspace {
        let files = Fixture::parse("num nA\nnA=1\nnA=2").files;
        let files = files.into_iter().map(|(path, text)| (format!("{ROOT}/{path}"), text.into_bytes()));
        load(&Memory::new(files), &[Utf8PathBuf::from(ROOT)]).unwrap()
    }

    /// A fix that replaces each `old` of the program by `new`.
    fn fix(workspace: &Workspace, changes: &[(&str, &str)]) -> Fix {
        let files = val3_analysis::db::Sources::get(&workspace.db).files(&workspace.db);
        let file = *files.values().find(|file| file.path(&workspace.db).as_str().ends_with(PROGRAM)).unwrap();
        let text = file.text(&workspace.db);
        let edits = changes.iter().map(|(old, new)| {
            let start = u32::try_from(text.find(old).unwrap()).unwrap();
            let range = TextRange::at(start.into(), u32::try_from(old.len()).unwrap().into());
            FileEdit { file, range, text: (*new).to_owned() }
        });
        Fix::safe("", edits.collect())
    }

    /// Statements after fixes, and the number of applied fixes.
    fn applied(changes: &[&[(&str, &str)]]) -> (Vec<String>, usize) {
        let workspace = workspace();
        let fixes: Vec<_> = changes.iter().map(|changes| fix(&workspace, changes)).collect();
        let chosen = apart(&fixes);
        let mut files = edited_files(&workspace.db, &chosen);
        apply(&mut files, &chosen);
        let code = files.values().next().unwrap().after.split("begin\n").nth(1).unwrap().split("\nend").next().unwrap();
        (code.lines().map(str::to_owned).collect(), chosen.len())
    }

    #[test]
    fn separate_fixes_are_applied_together() {
        let (code, fixes) = applied(&[&[("nA=2", "nA=20")], &[("nA=1", "nA=10")]]);
        assert_eq!((code, fixes), (vec!["nA=10".to_owned(), "nA=20".to_owned()], 2));
    }

    #[test]
    fn only_the_first_of_overlapping_fixes_is_applied() {
        let (code, fixes) = applied(&[&[("A=1", "B=1")], &[("=1", "=3")], &[("nA", "m"), ("=2", "=4")]]);
        assert_eq!((code, fixes), (vec!["nB=1".to_owned(), "nA=2".to_owned()], 1));
    }

    #[test]
    fn a_fix_is_applied_as_a_whole_or_not_at_all() {
        let (code, fixes) = applied(&[&[("=1", "=3")], &[("=1", "=5"), ("=2", "=4")]]);
        assert_eq!((code, fixes), (vec!["nA=3".to_owned(), "nA=2".to_owned()], 1));
    }
}
