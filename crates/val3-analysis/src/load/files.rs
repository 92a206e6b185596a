//! Reading files into the database.

use camino::{Utf8Path, Utf8PathBuf};
use rustc_hash::FxHashMap;
use smol_str::SmolStr;

use super::Loader;
use crate::db::{File, path_key};
use crate::system::Content;

impl Loader<'_> {
    /// Reads several files at once. What is not there under its exact name is left for `found_file`.
    pub(super) fn read_ahead<'p>(&mut self, paths: impl IntoIterator<Item = &'p Utf8PathBuf>) {
        let is_new = |path: &&Utf8PathBuf| {
            let key = path_key(path.as_str());
            !self.files.contains_key(&key) && !self.is_at_hand(path, &key)
        };
        let paths: Vec<Utf8PathBuf> = paths.into_iter().filter(is_new).cloned().collect();
        let contents = self.system.read_all(&paths);
        for (path, content) in paths.iter().zip(contents) {
            self.add(path, content);
        }
    }

    /// The input for the file at `path`, whatever the letter case of its name; `None` where there is none.
    pub(super) fn found_file(&mut self, path: &Utf8Path) -> Option<File> {
        self.file(path).or_else(|| {
            let path = self.actual(path)?;
            self.file(&path)
        })
    }

    fn file(&mut self, path: &Utf8Path) -> Option<File> {
        let key = path_key(path.as_str());
        if let Some(file) = self.files.get(&key) {
            return Some(*file);
        }
        if let Some(text) = self.system.edited(path) {
            return Some(self.file_input(key, path, Content { text, status: None }));
        }
        match self.known.files.get(&key).filter(|_| !(self.is_stale)(path)) {
            Some(file) => {
                self.files.insert(key, *file);
                Some(*file)
            }
            None => self.add(path, Content::of(self.system.read(path))),
        }
    }

    /// The file need not be read: its text is known, or an editor has it.
    fn is_at_hand(&self, path: &Utf8Path, key: &str) -> bool {
        let known = self.known.files.contains_key(key);
        known && !(self.is_stale)(path) || self.system.edited(path).is_some()
    }

    /// Makes an input of what was read; `None` where there is no file.
    fn add(&mut self, path: &Utf8Path, content: Option<Content>) -> Option<File> {
        let key = path_key(path.as_str());
        match self.files.get(&key) {
            Some(file) => Some(*file),
            None => Some(self.file_input(key, path, content?)),
        }
    }

    /// The path as the disk spells it: references are written without regard to letter case.
    fn actual(&mut self, path: &Utf8Path) -> Option<Utf8PathBuf> {
        if self.system.kind(path).is_some() {
            return Some(path.to_owned());
        }
        let parent = self.actual(path.parent()?)?;
        let wanted = path.file_name()?.to_lowercase();
        self.folder(&parent).get(&wanted).map(|name| parent.join(name))
    }

    /// The names in a folder, sorted, as the disk spells them.
    pub(super) fn names_in(&mut self, folder: &Utf8Path) -> Vec<SmolStr> {
        let mut names: Vec<SmolStr> = self.folder(folder).values().map(SmolStr::from).collect();
        names.sort_unstable();
        names
    }

    /// The names in a folder, by their spelling in lower case.
    fn folder(&mut self, path: &Utf8Path) -> &FxHashMap<String, String> {
        self.folders.entry(path.to_owned()).or_insert_with(|| {
            let names = self.system.list(path).unwrap_or_default();
            names.into_iter().map(|name| (name.to_lowercase(), name)).collect()
        })
    }
}
