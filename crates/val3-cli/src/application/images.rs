//! The libraries that an application loads: read, checked and compiled as it is.

use std::sync::Arc;

use camino::Utf8PathBuf;
use val3_bytecode::Image;
use val3_machine::devices::Libraries;
use val3_machine::files::{ControllerPath, LibraryFiles};

use super::{compile, first_refusal, load_laid};

/// The number of compiled libraries that are kept, so that a program that saves a library under ever new names fills no
/// memory.
const CAPACITY: usize = 64;

/// Compiles libraries.
pub(crate) struct Images {
    /// The folder of `Disk`.
    disk: Utf8PathBuf,
    compiled: Cache,
}

/// The libraries that were compiled last.
struct Cache {
    /// Images with the paths and the files that they were compiled from, the oldest first.
    images: Vec<(String, LibraryFiles, Arc<Image>)>,
    capacity: usize,
}

impl Cache {
    fn find(&self, path: &str, files: &LibraryFiles) -> Option<Arc<Image>> {
        let found = self.images.iter().find(|(known, held, _)| known == path && held == files);
        found.map(|(_, _, image)| Arc::clone(image))
    }

    fn keep(&mut self, path: String, files: LibraryFiles, image: &Arc<Image>) {
        self.images.retain(|(known, ..)| *known != path);
        if self.images.len() >= self.capacity {
            self.images.remove(0);
        }
        self.images.push((path, files, Arc::clone(image)));
    }
}

impl Images {
    pub(crate) fn new(disk: Utf8PathBuf) -> Self {
        Self { disk, compiled: Cache { images: Vec::new(), capacity: CAPACITY } }
    }
}

impl Libraries for Images {
    fn image(&mut self, path: &ControllerPath, files: LibraryFiles) -> Result<Arc<Image>, String> {
        let shown = path.to_string();
        if let Some(image) = self.compiled.find(&shown, &files) {
            return Ok(image);
        }
        let image = self.compile(path, &files)?;
        self.compiled.keep(shown, files, &image);
        Ok(image)
    }
}

impl Images {
    /// A library of another medium is read as if it lay on `Disk`, where the paths in it lead to.
    fn compile(&self, path: &ControllerPath, files: &LibraryFiles) -> Result<Arc<Image>, String> {
        let folder = path.parts().iter().fold(self.disk.clone(), |folder, part| folder.join(part.as_str()));
        let manifest = files.files.first().map(|file| folder.join(&file.path)).ok_or("the library has no files")?;
        let files = files.files.iter().map(|file| (folder.join(&file.path), file.bytes.clone())).collect();
        let (workspace, project) = load_laid(files, &manifest)?;
        match first_refusal(&workspace.db, project, |_| true) {
            Some(wrong) => Err(format!("`{path}`: {}", wrong.message)),
            None => compile(&workspace.db, project).map_err(|error| format!("`{path}`: {}", error.limit)),
        }
    }
}

#[cfg(test)]
mod tests {
    use val3_machine::files::LibraryFile;

    use super::*;

    fn files(text: &str) -> LibraryFiles {
        let file = LibraryFile { path: "lib.pjx".into(), bytes: text.into() };
        LibraryFiles { files: vec![file], encrypted: false }
    }

    #[test]
    fn the_libraries_that_were_compiled_last_are_kept() {
        let mut cache = Cache { images: Vec::new(), capacity: 2 };
        let image = Arc::new(Image::default());
        for path in ["a", "b", "b", "c"] {
            cache.keep(path.to_owned(), files(path), &image);
        }
        let is_kept = |path: &str, text: &str| cache.find(path, &files(text)).is_some();
        assert_eq!(["a", "b", "c"].map(|path| is_kept(path, path)), [false, true, true]);
        assert!(!is_kept("c", "changed"), "a changed library is compiled again");
    }
}
