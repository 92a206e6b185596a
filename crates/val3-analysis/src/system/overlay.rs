//! Overlay: additional, replaced and removed files on top of a file system.

use std::collections::BTreeSet;
use std::io;
use std::sync::Arc;

use camino::{Utf8Path, Utf8PathBuf};
use rustc_hash::{FxHashMap, FxHashSet};

use val3_files::{FileClass, Unreadable};

use super::{DecodedFile, PathKind, System};
use crate::paths::path_key;

/// An overlay on the file system `below`. Paths are compared in any letter case.
#[derive(Debug, Clone, Default)]
pub struct OverlayFs<S> {
    below: S,
    /// Stored bytes by path key.
    stored: FxHashMap<String, Vec<u8>>,
    /// Path keys of removed files. A stored file takes precedence.
    removed: FxHashSet<String>,
    /// Names in the folders above stored files.
    folders: FxHashMap<Utf8PathBuf, BTreeSet<String>>,
    /// Texts that are open in an editor, by path key.
    edited: FxHashMap<String, Arc<str>>,
}

impl<S: System> OverlayFs<S> {
    /// Creates an empty overlay on `below`.
    pub fn new(below: S) -> Self {
        Self {
            below,
            stored: FxHashMap::default(),
            removed: FxHashSet::default(),
            folders: FxHashMap::default(),
            edited: FxHashMap::default(),
        }
    }

    /// Adds or replaces a file, which then appears in the listings of the parent folders.
    pub fn store(&mut self, path: Utf8PathBuf, bytes: Vec<u8>) {
        let mut child = path.as_path();
        while let (Some(parent), Some(name)) = (child.parent(), child.file_name()) {
            if !self.folders.entry(parent.to_owned()).or_default().insert(name.to_owned()) {
                break;
            }
            child = parent;
        }
        self.stored.insert(path_key(path.as_str()), bytes);
    }

    /// Hides a file of the underlying file system: it cannot be read, and its folder does not list it.
    pub fn remove(&mut self, path: &Utf8Path) {
        self.removed.insert(path_key(path.as_str()));
    }

    /// Adds or replaces the text of a file that is open in an editor.
    pub fn edit(&mut self, path: &Utf8Path, text: Arc<str>) {
        self.edited.insert(path_key(path.as_str()), text);
    }

    /// Whether the overlay contains `path`.
    pub fn covers(&self, path: &Utf8Path) -> bool {
        let key = path_key(path.as_str());
        self.stored.contains_key(&key) || self.edited.contains_key(&key)
    }

    /// Whether the file below was removed, and no other file has replaced it.
    fn has_removed(&self, path: &Utf8Path) -> bool {
        self.removed.contains(&path_key(path.as_str())) && !self.covers(path)
    }

    fn bytes(&self, path: &Utf8Path) -> Option<&Vec<u8>> {
        self.stored.get(&path_key(path.as_str()))
    }

    /// Returns the names in the folder `path` that are stored files or contain some.
    fn names_below(&self, path: &Utf8Path) -> impl Iterator<Item = &str> {
        self.folders.get(path).into_iter().flatten().map(String::as_str)
    }
}

impl<S: System> System for OverlayFs<S> {
    fn read(&self, path: &Utf8Path, class: FileClass) -> Result<Vec<u8>, Unreadable> {
        match self.edited(path) {
            Some(text) => Ok(text.as_bytes().to_vec()),
            None => self.stored(path, class),
        }
    }

    fn read_all(&self, paths: &[Utf8PathBuf]) -> Vec<Option<DecodedFile>> {
        let mut contents = self.below.read_all(paths);
        for (path, content) in paths.iter().zip(&mut contents) {
            if let Some(bytes) = self.bytes(path) {
                *content = DecodedFile::of(Ok(bytes.clone()));
            } else if self.has_removed(path) {
                *content = None;
            }
        }
        contents
    }

    fn edited(&self, path: &Utf8Path) -> Option<Arc<str>> {
        let edited = self.edited.get(&path_key(path.as_str())).cloned();
        edited.or_else(|| if self.has_removed(path) { None } else { self.below.edited(path) })
    }

    fn stored(&self, path: &Utf8Path, class: FileClass) -> Result<Vec<u8>, Unreadable> {
        match self.bytes(path) {
            Some(bytes) => Ok(bytes.clone()),
            None if self.has_removed(path) => Err(Unreadable::Missing),
            None => self.below.stored(path, class),
        }
    }

    fn size(&self, path: &Utf8Path) -> u64 {
        match self.bytes(path) {
            Some(bytes) => bytes.len().try_into().unwrap_or(u64::MAX),
            None if self.has_removed(path) => 0,
            None => self.below.size(path),
        }
    }

    fn list(&self, path: &Utf8Path) -> io::Result<Vec<String>> {
        let mut names = match self.below.list(path) {
            Err(error) if self.names_below(path).next().is_none() => return Err(error),
            found => found.unwrap_or_default(),
        };
        names.retain(|name| !self.removed.contains(&path_key(path.join(name).as_str())));
        for new in self.names_below(path) {
            if !names.iter().any(|name| name.eq_ignore_ascii_case(new)) {
                names.push(new.to_owned());
            }
        }
        names.sort_unstable();
        Ok(names)
    }

    fn kind(&self, path: &Utf8Path) -> Option<PathKind> {
        if self.covers(path) {
            return Some(PathKind::File);
        }
        if self.has_removed(path) {
            return None;
        }
        let is_folder = self.names_below(path).next().is_some();
        if is_folder { Some(PathKind::Folder) } else { self.below.kind(path) }
    }

    fn identity(&self, path: &Utf8Path) -> Utf8PathBuf {
        if self.covers(path) { path.to_owned() } else { self.below.identity(path) }
    }

    fn target(&self, path: &Utf8Path) -> Utf8PathBuf {
        self.below.target(path)
    }

    fn is_link(&self, path: &Utf8Path) -> bool {
        !self.has_removed(path) && self.below.is_link(path)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::system::Memory;

    fn overlay() -> OverlayFs<Memory> {
        let mut system = OverlayFs::new(Memory::new([("/app/a.pgx", "a"), ("/app/b.pgx", "b")]));
        system.store("/app/B.pgx".into(), b"stored".to_vec());
        system.store("/lib/new/c.pgx".into(), b"c".to_vec());
        system.edit("/app/a.pgx".into(), "edited".into());
        system
    }

    #[test]
    fn overlay_files_take_precedence() {
        let system = overlay();
        let read = |path: &str| system.read(path.into(), FileClass::Program).ok();
        assert_eq!(read("/app/a.pgx").as_deref(), Some(&b"edited"[..]));
        assert_eq!(read("/app/b.pgx").as_deref(), Some(&b"stored"[..]), "letter case does not matter");
        assert_eq!(system.stored("/app/a.pgx".into(), FileClass::Program).unwrap(), b"a");
        assert_eq!(read("/app/c.pgx"), None);
        let contents = system.read_all(&["/app/a.pgx".into(), "/lib/new/c.pgx".into()]);
        let texts: Vec<_> = contents.into_iter().flatten().map(|content| content.text).collect();
        assert_eq!(texts, ["a".into(), "c".into()], "edited texts are asked for one by one");
    }

    #[test]
    fn folders_hold_the_stored_files() {
        let system = overlay();
        assert_eq!(system.list("/app".into()).unwrap(), ["a.pgx", "b.pgx"]);
        assert_eq!(system.list("/lib".into()).unwrap(), ["new"]);
        assert!(system.list("/other".into()).is_err());
        assert_eq!(system.kind("/lib/new".into()), Some(PathKind::Folder));
        assert_eq!(system.kind("/lib/new/C.pgx".into()), Some(PathKind::File));
        assert_eq!(system.kind("/other".into()), None);
    }

    #[test]
    fn removed_files_do_not_exist() {
        let mut system = overlay();
        for path in ["/app/A.pgx", "/app/b.pgx"] {
            system.remove(path.into());
        }
        system.edited.clear();
        let read = |path: &str| system.read(path.into(), FileClass::Program);
        assert_eq!(read("/app/a.pgx"), Err(Unreadable::Missing));
        assert_eq!(read("/app/b.pgx").as_deref(), Ok(&b"stored"[..]), "a stored file takes precedence");
        assert_eq!(system.read_all(&["/app/a.pgx".into()]).len(), 1);
        assert!(system.read_all(&["/app/a.pgx".into()]).into_iter().all(|content| content.is_none()));
        assert_eq!((system.kind("/app/a.pgx".into()), system.size("/app/a.pgx".into())), (None, 0));
        assert_eq!(system.list("/app".into()).unwrap(), ["B.pgx"]);
    }
}
