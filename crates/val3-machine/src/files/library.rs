//! Libraries on their media: where a path leads, what belongs to a library, and the storage half of the instructions
//! of 6.7. This module handles files and does not know the meaning of a library.

mod archive;
mod store;

use camino::{Utf8Path, Utf8PathBuf};
use rustc_hash::FxHashSet;
use smol_str::SmolStr;
use val3_data::{SavedData, rewrite};
use val3_syntax::encoding::decode;
use val3_syntax::xml;

use super::reserved::is_reserved;
use super::{ControllerPath, EntryKind, FileFault, MountedPath, Roots};
pub use archive::unpack;
pub use store::{Steps, Uninterrupted};

/// Where a library is: the folder and the project file in it, or an encrypted archive (6.5, 6.6).
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct LibraryPath {
    /// The folder, or the archive.
    folder: ControllerPath,
    /// The project file; `None` for an archive.
    manifest: Option<SmolStr>,
}

/// The files of a library as they were read. The project file comes first.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LibraryFiles {
    /// Each file, by its path from the folder of the library.
    pub files: Vec<LibraryFile>,
    /// They come from an encrypted archive.
    pub encrypted: bool,
}

/// One file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LibraryFile {
    /// Its path from the folder of the library.
    pub path: Utf8PathBuf,
    /// Its bytes.
    pub bytes: Vec<u8>,
}

impl LibraryPath {
    /// Reads a path as `libLoad` gets it: that of the folder, of the project file in it, or of an archive.
    ///
    /// # Errors
    /// [`FileFault::BadName`] where it names no library, such as a root alone.
    pub fn new(path: &ControllerPath) -> Result<Self, FileFault> {
        let name = path.name().ok_or(FileFault::BadName)?;
        if path.has_extension("zip") {
            return Ok(Self { folder: path.clone(), manifest: None });
        }
        if path.has_extension("pjx") {
            return Ok(Self { folder: path.parent(), manifest: Some(name.into()) });
        }
        Ok(Self { folder: path.clone(), manifest: Some(format!("{name}.pjx").into()) })
    }

    /// The path as `libPath` returns it, which identifies a library: the folder, or the archive; the project
    /// file where it is not named as its folder.
    #[must_use]
    pub fn path(&self) -> ControllerPath {
        let usual = self.folder.name().map(|name| format!("{name}.pjx"));
        match (&self.manifest, usual) {
            (Some(manifest), Some(usual)) if manifest.eq_ignore_ascii_case(&usual) => self.folder.clone(),
            (Some(manifest), _) => self.folder.child(manifest),
            (None, _) => self.folder.clone(),
        }
    }

    /// The folder, or the archive.
    #[must_use]
    pub fn folder(&self) -> &ControllerPath {
        &self.folder
    }

    /// The place of the project file, or of the archive; steps that a crash interrupted are finished first.
    fn place<'r>(&self, roots: &'r Roots) -> Result<MountedPath<'r>, FileFault> {
        let folder = roots.place(&self.folder)?;
        match &self.manifest {
            Some(manifest) => {
                store::recover(&folder, &mut Uninterrupted)?;
                folder.child(manifest)
            }
            None => Ok(folder),
        }
    }

    /// There is a library.
    ///
    /// # Errors
    /// If the path cannot be followed.
    pub fn exists(&self, roots: &Roots) -> Result<bool, FileFault> {
        Ok(self.place(roots)?.kind()? == EntryKind::File)
    }

    /// Reads all files of the library; of an archive with its password, which is the ZIP password here.
    ///
    /// A missing file that the project names is left out; loading reports it.
    ///
    /// # Errors
    /// [`FileFault::NotFound`] if there is none, [`FileFault::BadPath`] if not even the folder it would be in,
    /// [`FileFault::NotEncrypted`] and [`FileFault::CannotLoad`] for archives as 6.6 says.
    pub fn read(&self, roots: &Roots, password: &str) -> Result<LibraryFiles, FileFault> {
        let place = self.place(roots)?;
        if place.kind()? != EntryKind::File {
            let around = roots.place(&self.folder.parent())?.kind()?;
            return Err(if around == EntryKind::Folder { FileFault::NotFound } else { FileFault::BadPath });
        }
        if self.manifest.is_none() {
            let files = unpack(&place.read()?, password)?;
            return Ok(LibraryFiles { files, encrypted: true });
        }
        Ok(LibraryFiles { files: files_of(&place)?, encrypted: false })
    }

    /// Deletes the library: its project file first, so that what a crash leaves is no library, and its folder if
    /// nothing else is in it.
    ///
    /// # Errors
    /// If the path cannot be followed or a file cannot be deleted. That there is no library is none.
    pub fn delete(&self, roots: &Roots) -> Result<(), FileFault> {
        let place = self.place(roots)?;
        if place.kind()? != EntryKind::File {
            return Ok(());
        }
        match self.manifest {
            Some(_) => store::delete(&place.parent(), &files_of(&place)?),
            None => Ok(place.volume.remove_file(&place.path)?),
        }
    }

    /// Saves a library where it was loaded from: the files of `new` that are not as in `old`, and those that are gone
    /// from the medium. A crash at any time leaves the library of before or that of afterwards.
    ///
    /// # Errors
    /// [`FileFault::ReadOnly`] for an archive, which is never written in clear; else what the medium says, and
    /// nothing has changed then.
    pub fn save(
        &self,
        roots: &Roots,
        old: &LibraryFiles,
        new: &LibraryFiles,
        steps: &mut dyn Steps,
    ) -> Result<(), FileFault> {
        if new.encrypted {
            return Err(FileFault::ReadOnly);
        }
        let folder = self.place(roots)?.parent();
        let mut changed = Vec::new();
        for file in &new.files {
            let missing = folder.child_path(&file.path)?.kind()? == EntryKind::Missing;
            if missing || !old.files.contains(file) {
                changed.push(file.clone());
            }
        }
        if changed.is_empty() { Ok(()) } else { store::store(&folder, &changed, steps) }
    }

    /// Saves a library under another path. The folder that is to hold its folder must be there.
    ///
    /// # Errors
    /// [`FileFault::LibraryThere`] if there is a library, [`FileFault::BadPath`] without the folder around,
    /// [`FileFault::BadName`] for an archive, [`FileFault::ReadOnly`] if the library is an encrypted one, which is
    /// never written in clear; else what the medium says.
    pub fn save_as(&self, roots: &Roots, new: &LibraryFiles, steps: &mut dyn Steps) -> Result<(), FileFault> {
        let manifest = self.manifest.as_ref().ok_or(FileFault::BadName)?;
        if self.exists(roots)? {
            return Err(FileFault::LibraryThere);
        }
        if new.encrypted {
            return Err(FileFault::ReadOnly);
        }
        if roots.place(&self.folder.parent())?.kind()? != EntryKind::Folder {
            return Err(FileFault::BadPath);
        }
        let mut files = new.files.clone();
        if let Some(first) = files.first_mut() {
            first.path = manifest.as_str().into();
        }
        store::store(&roots.place(&self.folder)?, &files, steps)
    }
}

impl LibraryFiles {
    /// Bytes of all files.
    #[must_use]
    pub fn size(&self) -> usize {
        self.files.iter().map(|file| file.bytes.len()).sum()
    }

    /// The file with this path from the folder of the library.
    #[must_use]
    pub fn file(&self, path: &Utf8Path) -> Option<&LibraryFile> {
        self.files.iter().find(|file| file.path == path)
    }

    /// The same library with other values of its data.
    #[must_use]
    pub fn with_data(&self, data: &[SavedData]) -> Self {
        let mut new = self.clone();
        for file in new.files.iter_mut().filter(|file| has_extension(&file.path, "dtx")) {
            let decoded = decode(file.bytes.clone());
            let text = rewrite(&decoded.text, data);
            if text != decoded.text {
                file.bytes = decoded.encoding.encode(&text);
            }
        }
        new
    }
}

/// Lists what is in a folder, by name without regard to letter case (`libList`).
///
/// # Errors
/// [`FileFault::BadPath`] if there is no such folder.
pub fn list(roots: &Roots, path: &ControllerPath) -> Result<Vec<String>, FileFault> {
    let place = roots.place(path)?;
    if place.kind()? != EntryKind::Folder {
        return Err(FileFault::BadPath);
    }
    let mut names = place.names()?;
    names.retain(|name| !is_reserved(name));
    Ok(names)
}

fn has_extension(path: &Utf8Path, extension: &str) -> bool {
    path.extension().is_some_and(|found| found.eq_ignore_ascii_case(extension))
}

/// The project file and the files it names.
fn files_of(manifest: &MountedPath<'_>) -> Result<Vec<LibraryFile>, FileFault> {
    let folder = manifest.parent();
    let bytes = manifest.read()?;
    let named = named_files(&decode(bytes.clone()).text);
    let mut files = vec![LibraryFile { path: manifest.name().into(), bytes }];
    let mut known = FxHashSet::from_iter([manifest.path.clone()]);
    for name in named {
        let Ok(place) = folder.child_path(Utf8Path::new(&name.replace('\\', "/"))) else { continue };
        if place.kind()? == EntryKind::File && known.insert(place.path.clone()) {
            let path = place.path.strip_prefix(&folder.path).unwrap_or(&place.path).to_owned();
            files.push(LibraryFile { path, bytes: place.read()? });
        }
    }
    Ok(files)
}

/// The programs and data files that a project names, in either dialect.
fn named_files(text: &str) -> Vec<String> {
    let parse = val3_syntax::parse(text);
    let root = xml::root(parse.view());
    let entries = root.into_iter().flat_map(xml::Element::elements).flat_map(xml::Element::elements);
    let of_files =
        entries.filter(|entry| ["program", "data"].iter().any(|name| entry.name().eq_ignore_ascii_case(name)));
    of_files.filter_map(|entry| entry.value("file").map(|file| file.trim().to_owned())).collect()
}

#[cfg(test)]
mod tests;
