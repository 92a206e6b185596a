//! The disk, with files laid over it that are nowhere else: those of an encrypted library, the program of a text.

use std::collections::BTreeMap;
use std::io;

use camino::{Utf8Path, Utf8PathBuf};
use val3_analysis::system::{Disk, Kind, System};

/// Files by their paths.
pub(crate) type Files = BTreeMap<Utf8PathBuf, Vec<u8>>;

/// The disk, with files laid over it.
#[derive(Debug)]
pub(crate) struct Laid {
    pub(crate) files: Files,
}

impl System for Laid {
    fn read(&self, path: &Utf8Path) -> io::Result<Vec<u8>> {
        self.files.get(path).map_or_else(|| Disk.read(path), |bytes| Ok(bytes.clone()))
    }

    fn list(&self, path: &Utf8Path) -> io::Result<Vec<String>> {
        let inside = self.files.keys().filter_map(|file| file.strip_prefix(path).ok()?.components().next());
        let mut names: Vec<String> = inside.map(|part| part.as_str().to_owned()).collect();
        match Disk.list(path) {
            Ok(found) => names.extend(found),
            Err(error) if names.is_empty() => return Err(error),
            Err(_) => {}
        }
        names.sort_unstable();
        names.dedup();
        Ok(names)
    }

    fn kind(&self, path: &Utf8Path) -> Option<Kind> {
        if self.files.contains_key(path) {
            return Some(Kind::File);
        }
        let is_folder = self.files.keys().any(|file| file.starts_with(path));
        if is_folder { Some(Kind::Folder) } else { Disk.kind(path) }
    }

    fn identity(&self, path: &Utf8Path) -> Utf8PathBuf {
        if self.files.contains_key(path) { path.to_owned() } else { Disk.identity(path) }
    }
}
