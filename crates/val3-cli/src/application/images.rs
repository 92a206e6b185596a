//! The libraries that an application loads: read, checked and compiled as it is.

use std::sync::Arc;

use camino::Utf8PathBuf;
use val3_bytecode::Image;
use val3_machine::devices::Libraries;
use val3_machine::files::{ControllerPath, LibraryFiles};

use super::{compile, first_refusal, load_laid};

/// Compiled libraries that are kept. A program that saves a library under ever new names fills no memory.
const MOST_KNOWN: usize = 64;

/// Compiles libraries.
pub(crate) struct Images {
    /// The folder of `Disk`.
    disk: Utf8PathBuf,
    /// What was compiled, with the files it was compiled from.
    known: Vec<(String, LibraryFiles, Arc<Image>)>,
}

impl Images {
    pub(crate) fn new(disk: Utf8PathBuf) -> Self {
        Self { disk, known: Vec::new() }
    }
}

impl Libraries for Images {
    fn image(&mut self, path: &ControllerPath, files: LibraryFiles) -> Result<Arc<Image>, String> {
        let shown = path.to_string();
        let known = self.known.iter().find(|(known, held, _)| *known == shown && *held == files);
        if let Some((_, _, image)) = known {
            return Ok(Arc::clone(image));
        }
        let image = self.compile(path, &files)?;
        self.known.retain(|(known, ..)| *known != shown);
        if self.known.len() == MOST_KNOWN {
            self.known.remove(0);
        }
        self.known.push((shown, files, Arc::clone(&image)));
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
