//! The disk, with the open documents laid over it.

use std::io;
use std::sync::Arc;

use camino::{Utf8Path, Utf8PathBuf};
use rustc_hash::FxHashMap;
use val3_analysis::db::path_key;
use val3_analysis::system::{Disk, Kind, System};

use crate::documents::Documents;
use crate::loose;

/// What the loader sees.
#[derive(Debug)]
pub(crate) struct Overlay {
    /// By path key.
    edited: FxHashMap<String, Arc<str>>,
}

impl Overlay {
    /// The open documents, and the project files that those without a project get.
    pub(crate) fn new(documents: &Documents, loose: &[Utf8PathBuf]) -> Self {
        let open = documents.effective().map(|document| (document.path.clone(), Arc::clone(&document.text)));
        let given = loose.iter().map(|path| (loose::manifest_path(path), loose::manifest(path).into()));
        Self { edited: open.chain(given).map(|(path, text)| (path_key(path.as_str()), text)).collect() }
    }

    fn text(&self, path: &Utf8Path) -> Option<&Arc<str>> {
        self.edited.get(&path_key(path.as_str()))
    }
}

impl System for Overlay {
    fn read(&self, path: &Utf8Path) -> io::Result<Vec<u8>> {
        match self.text(path) {
            Some(text) => Ok(text.as_bytes().to_vec()),
            None => Disk.read(path),
        }
    }

    fn stored(&self, path: &Utf8Path) -> io::Result<Vec<u8>> {
        Disk.read(path)
    }

    fn edited(&self, path: &Utf8Path) -> Option<Arc<str>> {
        self.text(path).cloned()
    }

    fn list(&self, path: &Utf8Path) -> io::Result<Vec<String>> {
        Disk.list(path)
    }

    fn kind(&self, path: &Utf8Path) -> Option<Kind> {
        if self.text(path).is_some() { Some(Kind::File) } else { Disk.kind(path) }
    }

    fn identity(&self, path: &Utf8Path) -> Utf8PathBuf {
        if self.text(path).is_some() { path.to_owned() } else { Disk.identity(path) }
    }
}
