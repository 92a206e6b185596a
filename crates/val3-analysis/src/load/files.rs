//! Reading files into the database.

use camino::{Utf8Path, Utf8PathBuf};
use smol_str::SmolStr;
use val3_files::FileClass;

use super::Loader;
use super::folder_names::FolderNames;
use crate::db::File;
use crate::paths::path_key;
use crate::system::{DecodedFile, PathKind};

impl Loader<'_> {
    /// Reads several files in one call. Files that do not exist under their exact name are left to `found_file`.
    pub(super) fn read_ahead<'p>(&mut self, paths: impl IntoIterator<Item = &'p Utf8PathBuf>) {
        let mut paths: Vec<Utf8PathBuf> = paths.into_iter().filter(|path| self.must_read(path)).cloned().collect();
        // Files above the limit are left to `found_file`, which reports them.
        paths.retain(|path| self.budget.reserve(path, self.system.size(path)));
        let contents = self.system.read_all(&paths);
        for (path, content) in paths.iter().zip(contents) {
            self.add(path, content);
        }
    }

    fn must_read(&self, path: &Utf8Path) -> bool {
        let key = path_key(path.as_str());
        !self.files.contains_key(&key) && !self.is_available(path, &key)
    }

    /// Returns the input for the file at `path` in any letter case; `None` if it does not exist.
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
            return Some(self.file_input(key, path, DecodedFile { text, status: None }));
        }
        match self.known.files.get(&key).filter(|_| !(self.is_stale)(&key)) {
            Some(file) => {
                let file = *file;
                let bytes = u64::try_from(file.text(&self.db).len()).unwrap_or(u64::MAX);
                self.budget.reserve(path, bytes);
                self.files.insert(key, file);
                Some(file)
            }
            None => {
                let content = self.content(path);
                self.add(path, content)
            }
        }
    }

    fn content(&mut self, path: &Utf8Path) -> Option<DecodedFile> {
        match self.budget.reserve(path, self.system.size(path)) {
            true => DecodedFile::of(self.system.read(path, FileClass::Program)),
            false => Some(DecodedFile::unreadable(self.budget.reason())),
        }
    }

    /// Whether the file need not be read, because its text is known or open in an editor.
    fn is_available(&self, path: &Utf8Path, key: &str) -> bool {
        let known = self.known.files.contains_key(key);
        known && !(self.is_stale)(key) || self.system.edited(path).is_some()
    }

    /// Creates an input from read content; `None` if the file does not exist.
    fn add(&mut self, path: &Utf8Path, content: Option<DecodedFile>) -> Option<File> {
        let key = path_key(path.as_str());
        match self.files.get(&key) {
            Some(file) => Some(*file),
            None => Some(self.file_input(key, path, content?)),
        }
    }

    /// Whether a file exists at `path` in any letter case.
    pub(super) fn is_file(&mut self, path: &Utf8Path) -> bool {
        self.actual(path).is_some_and(|path| self.system.kind(&path) == Some(PathKind::File))
    }

    /// Returns the path as spelt on the disk, because references may use any letter case.
    pub(super) fn actual(&mut self, path: &Utf8Path) -> Option<Utf8PathBuf> {
        if self.system.kind(path).is_some() {
            return Some(path.to_owned());
        }
        let parent = self.actual(path.parent()?)?;
        self.folder(&parent).spelling(path.file_name()?).map(|name| parent.join(name))
    }

    /// Returns `path` with the file name as spelt on the disk, because a case-insensitive disk opens a file under any
    /// spelling.
    pub(super) fn spelt(&mut self, path: &Utf8Path) -> Utf8PathBuf {
        let (Some(parent), Some(name)) = (path.parent(), path.file_name()) else { return path.to_owned() };
        self.folder(parent).spelling(name).map_or_else(|| path.to_owned(), |name| parent.join(name))
    }

    /// Whether a file at `path` is open in an editor, or its folder lists the name in any letter case.
    pub(super) fn is_listed(&mut self, path: &Utf8Path) -> bool {
        let (Some(parent), Some(name)) = (path.parent(), path.file_name()) else { return false };
        self.system.edited(path).is_some() || self.folder(parent).spelling(name).is_some()
    }

    /// Returns the sorted names in a folder, as spelt on the disk.
    pub(super) fn names_in(&mut self, folder: &Utf8Path) -> Vec<SmolStr> {
        let mut names: Vec<SmolStr> = self.folder(folder).spellings().map(SmolStr::from).collect();
        names.sort_unstable();
        names
    }

    fn folder(&mut self, path: &Utf8Path) -> &FolderNames {
        let names = || FolderNames::new(self.system.list(path).unwrap_or_default());
        self.folders.entry(path.to_owned()).or_insert_with(names)
    }
}
