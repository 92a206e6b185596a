//! A cell with its findings, to which changes are applied and undone.

use std::collections::BTreeMap;
use std::sync::Arc;

use camino::Utf8PathBuf;
use salsa::Setter as _;
use val3_analysis::db::{Database, File, FileStatus, Sources};
use val3_analysis::items::parse;
use val3_analysis::load::{Workspace, load};
use val3_analysis::paths::path_key;
use val3_analysis::system::Memory;
use val3_check::settings::{RuleSelection, WorkspaceSettings};
use val3_ide::{CheckSettings, FileEdit, SourceChange, project_diagnostics};
use val3_syntax::SyntaxNode;

/// Files of a cell, by absolute path.
pub(crate) type Files = BTreeMap<Utf8PathBuf, Vec<u8>>;

/// Items with their number of occurrences.
pub(crate) type Counts = BTreeMap<String, usize>;

/// Files that a change has touched, with their previous bytes.
pub(crate) type Before = Vec<(Utf8PathBuf, Option<Vec<u8>>)>;

/// A cell in one database. Only the queries that a change affects run again.
pub(crate) struct EditedCell {
    workspace: Workspace,
    files: Files,
    settings: CheckSettings,
}

impl EditedCell {
    pub(crate) fn open(files: Files) -> Self {
        let workspace = load(&Memory::new(files.clone()), &[Utf8PathBuf::from("/")]).unwrap();
        let settings = WorkspaceSettings::new(&workspace.db, &workspace.projects, &RuleSelection::default()).unwrap();
        let settings = CheckSettings::new(&workspace.db, settings);
        Self { workspace, files, settings }
    }

    pub(crate) fn db(&self) -> &Database {
        &self.workspace.db
    }

    /// Returns the files of all projects, by path.
    pub(crate) fn project_files(&self) -> Vec<File> {
        let mut files: Vec<File> = Sources::get(self.db()).files(self.db()).values().copied().collect();
        files.retain(|file| !val3_ide::projects_of(self.db(), *file).is_empty());
        files.sort_by_key(|file| file.path(self.db()).clone());
        files
    }

    pub(crate) fn tree(&self, file: File) -> SyntaxNode {
        parse(self.db(), file).root()
    }

    /// Returns the findings of all projects, without locations.
    pub(crate) fn findings(&self) -> Counts {
        let (db, projects) = (self.db(), &self.workspace.projects);
        let found = projects.iter().flat_map(|project| project_diagnostics(db, self.settings, projects, *project));
        counted(found.map(|found| format!("{} {}: {}", found.rule.code, found.place.file.path(db), found.message)))
    }

    /// Returns the new texts of the files that a change edits.
    ///
    /// Edits that overlap, are not sorted, or are outside their file cause an error.
    pub(crate) fn texts(&self, change: &SourceChange) -> Result<Vec<(File, String)>, String> {
        let mut texts = Vec::new();
        for edits in change.edits.chunk_by(|one, next| one.file == next.file) {
            let Some(file) = edits.first().map(|edit| edit.file) else { continue };
            if texts.iter().any(|(known, _)| *known == file) {
                return Err("the edits of a file are not next to each other".to_owned());
            }
            texts.push((file, edited(file.text(self.db()), edits)?));
        }
        Ok(texts)
    }

    /// Applies a change like an editor.
    pub(crate) fn apply(&mut self, change: &SourceChange) -> Result<Before, String> {
        let texts = self.texts(change)?;
        let mut before = Before::new();
        for (path, text) in &change.creates {
            before.push((path.clone(), self.files.insert(path.clone(), text.clone().into_bytes())));
        }
        if before.iter().any(|(_, known)| known.is_some()) {
            self.restore(&before);
            return Err("a file that is to be created exists".to_owned());
        }
        for (file, text) in &texts {
            let FileStatus::Read { encoding, .. } = file.status(self.db()) else {
                return Err("a file that cannot be read is edited".to_owned());
            };
            let (path, bytes) = (file.path(self.db()).clone(), encoding.encode(text));
            before.push((path.clone(), self.files.insert(path, bytes)));
        }
        for (from, to) in &change.moves {
            let bytes = self.files.remove(from).ok_or_else(|| format!("{from} moves and does not exist"))?;
            before.push((to.clone(), self.files.insert(to.clone(), bytes.clone())));
            before.push((from.clone(), Some(bytes)));
        }
        before.extend(change.deletes.iter().map(|path| (path.clone(), self.files.remove(path))));
        self.read(&before);
        Ok(before)
    }

    /// Restores the bytes before a change.
    pub(crate) fn restore(&mut self, before: &Before) {
        for (path, bytes) in before.iter().rev() {
            match bytes {
                Some(bytes) => self.files.insert(path.clone(), bytes.clone()),
                None => self.files.remove(path),
            };
        }
        self.read(before);
    }

    /// Returns the bytes of a file.
    pub(crate) fn bytes(&self, path: &Utf8PathBuf) -> Option<&Vec<u8>> {
        self.files.get(path)
    }

    /// Reads the files of a change again.
    fn read(&mut self, touched: &Before) {
        let is_known = |path: &Utf8PathBuf| self.known(path).is_some() && path.extension() != Some("pjx");
        if touched.iter().all(|(path, bytes)| bytes.is_some() && self.files.contains_key(path) && is_known(path)) {
            touched.iter().for_each(|(path, _)| self.read_text(path));
            return;
        }
        let touched: Vec<String> = touched.iter().map(|(path, _)| path_key(path.as_str())).collect();
        let system = Memory::new(self.files.clone());
        let is_stale = |key: &str| touched.iter().any(|path| path == key);
        let errors = self.workspace.refresh(&system, &[Utf8PathBuf::from("/")], &is_stale);
        assert!(errors.is_empty(), "{errors:?}");
    }

    fn read_text(&mut self, path: &Utf8PathBuf) {
        let decoded = self.files.get(path).cloned().map(val3_syntax::encoding::decode);
        let (Some(decoded), Some(file)) = (decoded, self.known(path)) else { return };
        file.set_text(&mut self.workspace.db).to(Arc::from(decoded.text));
    }

    /// Returns the file at a path, if the analysis has read it.
    pub(crate) fn known(&self, path: &Utf8PathBuf) -> Option<File> {
        Sources::get(self.db()).files(self.db()).get(&path_key(path.as_str())).copied()
    }
}

/// Returns a text after its edits.
fn edited(text: &str, edits: &[FileEdit]) -> Result<String, String> {
    let mut new = String::with_capacity(text.len());
    let mut done = 0;
    for edit in edits {
        let range = std::ops::Range::<usize>::from(edit.range);
        let kept = text.get(done..range.start).ok_or_else(|| format!("edits overlap, or are not sorted: {edits:?}"))?;
        new += kept;
        new += &edit.text;
        done = range.end;
    }
    let rest = text.get(done..).ok_or_else(|| format!("an edit is outside of its file: {edits:?}"))?;
    Ok(new + rest)
}

/// Counts equal texts.
pub(crate) fn counted(texts: impl Iterator<Item = String>) -> Counts {
    let mut counts = Counts::new();
    texts.for_each(|text| *counts.entry(text).or_default() += 1);
    counts
}

/// Returns the texts that occur in `one` more often than in `other`.
pub(crate) fn surplus(one: &Counts, other: &Counts) -> Vec<String> {
    let more = one.iter().filter(|(text, count)| other.get(*text).is_none_or(|known| known < count));
    more.map(|(text, _)| text.clone()).collect()
}
