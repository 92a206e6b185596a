//! Reading files into the database.

use std::io;
use std::sync::Arc;

use camino::{Utf8Path, Utf8PathBuf};
use rustc_hash::FxHashMap;
use smol_str::SmolStr;
use val3_syntax::encoding::{decode, is_utf16};

use super::Loader;
use crate::db::{File, FileStatus, path_key};

/// The largest file that is read, in bytes: offsets have 32 bits.
const SIZE_LIMIT: usize = u32::MAX as usize / 2;

/// What a file holds.
pub(super) struct Content {
    /// The text; empty where it cannot be read.
    pub(super) text: Arc<str>,
    /// How it was read; `None` where an editor has the text, which does not tell how it will be stored.
    pub(super) status: Option<FileStatus>,
}

impl Content {
    /// `None` where there is no file.
    fn of(content: io::Result<Vec<u8>>) -> Option<Self> {
        Some(match content {
            Ok(bytes) if bytes.len() > SIZE_LIMIT => Self::unreadable("it is larger than 2 GiB"),
            Ok(bytes) if is_utf16(&bytes) => Self::unreadable("its text is UTF-16; save it as UTF-8"),
            Ok(bytes) => {
                let decoded = decode(bytes);
                let status = FileStatus::Read { encoding: decoded.encoding, undeclared: decoded.undeclared };
                Self { text: decoded.text.into(), status: Some(status) }
            }
            Err(error) if error.kind() == io::ErrorKind::NotFound => return None,
            Err(error) => Self::unreadable(&error.to_string()),
        })
    }

    fn unreadable(reason: &str) -> Self {
        Self { text: "".into(), status: Some(FileStatus::Unreadable(reason.to_owned())) }
    }
}

impl Loader<'_> {
    /// Reads several files at once. What is not there under its exact name is left for `found_file`.
    pub(super) fn read_ahead(&mut self, mut paths: Vec<Utf8PathBuf>) {
        paths.retain(|path| !self.files.contains_key(&path_key(path.as_str())) && !self.is_at_hand(path));
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
            None => self.add(path, self.system.read(path)),
        }
    }

    /// The file need not be read: its text is known, or an editor has it.
    fn is_at_hand(&self, path: &Utf8Path) -> bool {
        let known = self.known.files.contains_key(&path_key(path.as_str()));
        known && !(self.is_stale)(path) || self.system.edited(path).is_some()
    }

    /// Makes an input of what was read; `None` where there is no file.
    fn add(&mut self, path: &Utf8Path, content: io::Result<Vec<u8>>) -> Option<File> {
        let key = path_key(path.as_str());
        match self.files.get(&key) {
            Some(file) => Some(*file),
            None => Some(self.file_input(key, path, Content::of(content)?)),
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
