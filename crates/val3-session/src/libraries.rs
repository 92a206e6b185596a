//! Libraries that an application loads at run time. They are read, checked and compiled like the application.

use std::sync::Arc;

use camino::Utf8PathBuf;
use val3_analysis::paths::path_key;
use val3_analysis::system::{Disk, OverlayFs};
use val3_bytecode::Image;
use val3_compile::CodeForm;
use val3_machine::devices::Libraries;
use val3_machine::files::{ControllerPath, LibraryFiles};

use crate::application::Application;
use crate::settings::PathRoot;

/// Maximum number of cached images, because a program may save a library under ever new names.
const CAPACITY: usize = 64;

/// Compiles libraries, and caches the latest images.
pub(crate) struct LibraryCompiler {
    /// Folder of `Disk`.
    disk: Utf8PathBuf,
    /// Form of the code.
    form: CodeForm,
    /// Keys of the project files of libraries that are never counted.
    uncounted: Vec<String>,
    /// Roots of libraries outside `Disk`, whose paths are relative to the surrounding folder.
    outside: Vec<PathRoot>,
    /// Program texts that replace files on the disk, by path.
    edited: Vec<(Utf8PathBuf, Arc<str>)>,
    compiled: Cache,
}

/// Cache of the latest images.
struct Cache {
    /// Images with the paths and files from which they were compiled, the oldest first.
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

impl LibraryCompiler {
    pub(crate) fn new(disk: Utf8PathBuf, outside: Vec<PathRoot>, form: CodeForm, uncounted: Vec<String>) -> Self {
        let compiled = Cache { images: Vec::new(), capacity: CAPACITY };
        Self { disk, outside, form, uncounted, edited: Vec::new(), compiled }
    }

    /// Sets program texts that replace files on the disk.
    pub(crate) fn with(self, edited: Vec<(Utf8PathBuf, Arc<str>)>) -> Self {
        Self { edited, ..self }
    }

    /// Compiles a library. A library on another medium is read as if it were on `Disk`, to which its paths refer.
    fn compile(&self, path: &ControllerPath, files: &LibraryFiles) -> Result<Arc<Image>, String> {
        let outside = self.outside.iter().find(|root| root.name == path.medium()).map(|root| &root.folder);
        let base = outside.unwrap_or(&self.disk).clone();
        let folder = path.parts().iter().fold(base, |folder, part| folder.join(part.as_str()));
        let (library, manifest) = open_stored(folder, files, &self.edited)?;
        if let Some(wrong) = library.refusals().first() {
            return Err(format!("`{path}`: {}", wrong.message));
        }
        let key = path_key(manifest.as_str());
        let is_plain = self.form == CodeForm::Counted && self.uncounted.contains(&key);
        library
            .compile_as(if is_plain { CodeForm::Plain } else { self.form })
            .map_err(|error| format!("`{path}`: {}", error.limit))
    }
}

/// Opens the project with these files in `folder`. `edited` are program texts that replace files on the disk. Returns the
/// project with the path of its project file.
///
/// # Errors
/// The project has no files, or cannot be opened.
pub(crate) fn open_stored(
    folder: Utf8PathBuf,
    files: &LibraryFiles,
    edited: &[(Utf8PathBuf, Arc<str>)],
) -> Result<(Application, Utf8PathBuf), String> {
    let manifest = files.files.first().map(|file| folder.join(&file.path)).ok_or("the library has no files")?;
    let mut system = OverlayFs::new(Disk);
    files.files.iter().for_each(|file| system.store(folder.join(&file.path), file.bytes.clone()));
    edited.iter().for_each(|(path, text)| system.edit(path, Arc::clone(text)));
    let project = Application::open(&system, &manifest, None).map_err(|error| error.to_string())?;
    Ok((project, manifest))
}

impl Libraries for LibraryCompiler {
    fn image(&mut self, path: &ControllerPath, files: LibraryFiles) -> Result<Arc<Image>, String> {
        let name = path.to_string();
        if let Some(image) = self.compiled.find(&name, &files) {
            return Ok(image);
        }
        let image = self.compile(path, &files)?;
        self.compiled.keep(name, files, &image);
        Ok(image)
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
    fn the_last_compiled_libraries_are_cached() {
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
