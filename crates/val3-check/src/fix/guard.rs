//! Tests fixes for editors, which offer them one by one: determines fixes that add no error.

use std::sync::Arc;

use camino::Utf8PathBuf;
use val3_analysis::db::Db;

use super::apply::{apart, new_texts};
use super::errors::{ErrorCounts, TrialWorkspace};
use crate::diagnostic::Fix;

/// An error that fixes would add.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct AddedError {
    /// File with the error.
    pub path: Utf8PathBuf,
    /// Message of the error.
    pub message: String,
}

/// Tests fixes on a workspace, which is unchanged after each test.
#[derive(Debug)]
pub struct FixGuard<T> {
    target: T,
    before: ErrorCounts,
}

impl<T: TrialWorkspace> FixGuard<T> {
    /// Creates a guard that compares with the current errors of the workspace.
    pub fn new(mut target: T) -> Self {
        let before = ErrorCounts::of(&mut target);
        Self { target, before }
    }

    /// Returns the first error that these fixes would add if they were applied together. The files of the fixes belong
    /// to `db`.
    pub fn added_error(&mut self, db: &dyn Db, fixes: &[&Fix]) -> Option<AddedError> {
        let texts = new_texts(db, fixes);
        self.target.set_texts(texts.iter().map(|text| (text.path.as_path(), &text.after)));
        let found = self.target.all_findings();
        let files = self.target.db();
        let after = ErrorCounts::among(files, &found);
        let added = found.iter().find(|found| after.adds(files, found, &self.before));
        let added = added
            .map(|error| AddedError { path: error.place.file.path(files).clone(), message: error.message.clone() });
        self.target.set_texts(texts.iter().map(|text| (text.path.as_path(), &text.before)));
        added
    }

    /// Selects fixes that do not touch each other and can be applied together without adding an error.
    pub fn harmless<'f>(&mut self, db: &dyn Db, fixes: impl IntoIterator<Item = &'f Fix>) -> Vec<&'f Fix> {
        let mut harmless: Vec<&Fix> = Vec::new();
        let mut open = vec![apart(fixes)];
        while let Some(mut group) = open.pop() {
            if group.is_empty() {
                continue;
            }
            let trial = [harmless.as_slice(), &group].concat();
            if self.added_error(db, &trial).is_none() {
                harmless = trial;
            } else if group.len() > 1 {
                let second = group.split_off(group.len() / 2);
                open.extend([second, group]);
            }
        }
        harmless
    }
}

/// Text of a file before and after fixes.
#[derive(Debug)]
pub(super) struct NewText {
    pub(super) path: Utf8PathBuf,
    pub(super) before: Arc<str>,
    pub(super) after: Arc<str>,
}

#[cfg(test)]
mod tests {
    use val3_analysis::db::{FileEdit, Sources};
    use val3_analysis::load::load;
    use val3_analysis::system::Memory;
    use val3_syntax::TextRange;
    use val3_test::{Fixture, ROOT};

    use super::*;
    use crate::testing::MemoryTarget;

    #[test]
    fn only_fixes_that_add_no_error_are_harmless() {
        let files = Fixture::parse("num nA\nnA=1\nnA=2\nnA=3\nput(nA)").files;
        let files = files.into_iter().map(|(path, text)| (format!("{ROOT}/{path}"), text.into_bytes()));
        let files: Vec<(String, Vec<u8>)> = files.collect();
        let db = load(&Memory::new(files.clone()), &[Utf8PathBuf::from(ROOT)]).unwrap().db;
        let start = *Sources::get(&db).files(&db).values().find(|file| file.path(&db).ends_with("start.pgx")).unwrap();
        let fixes = [("nA=1", "nA=10"), ("nA=2", "nB=2"), ("nA=3", "nA=30")].map(|(old, new)| {
            let at = u32::try_from(start.text(&db).find(old).unwrap()).unwrap();
            let range = TextRange::at(at.into(), u32::try_from(old.len()).unwrap().into());
            Fix::safe("", vec![FileEdit { file: start, range, text: new.to_owned() }])
        });
        let mut guard = FixGuard::new(MemoryTarget::new(&files));
        assert_eq!(guard.harmless(&db, &fixes), [&fixes[0], &fixes[2]]);
        let [harmless, harmful, _] = &fixes;
        assert_eq!(guard.added_error(&db, &[harmless]), None);
        let error = guard.added_error(&db, &[harmless, harmful]).unwrap();
        assert_eq!((error.path.file_name(), error.message.contains("nB")), (Some("start.pgx"), true));
    }
}
