//! Libraries on their media: path resolution, library files, and the storage part of the library instructions (6.7).
//! This module handles files, not their content.

mod archive;
mod store;
mod zipped;

use camino::{Utf8Path, Utf8PathBuf};
use rustc_hash::FxHashSet;
use smol_str::SmolStr;
use val3_data::{SavedData, UnwritableValue, is_list_file, rewrite};
use val3_syntax::encoding::decode;
use val3_syntax::xml;

use super::reserved::is_reserved;
use super::{ControllerPath, EntryKind, FileFault, MountedPath, Roots};
pub use archive::unpack;
pub use store::{Steps, Uninterrupted};

/// Location of a library: the folder and the project file in it, or an encrypted archive (6.5, 6.6).
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct LibraryPath {
    /// The folder, or the archive.
    folder: ControllerPath,
    /// The project file; `None` for an archive.
    manifest: Option<SmolStr>,
}

/// Files of a library as read from the medium, the project file first.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LibraryFiles {
    /// Files with paths relative to the library's folder.
    pub files: Vec<LibraryFile>,
    /// Whether the files come from an encrypted archive.
    pub encrypted: bool,
}

/// File of a library.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LibraryFile {
    /// Path relative to the library's folder.
    pub path: Utf8PathBuf,
    /// Content.
    pub bytes: Vec<u8>,
}

impl LibraryPath {
    /// Parses a path in the forms that `libLoad` accepts: the folder, the project file in it, or an archive.
    ///
    /// # Errors
    /// [`FileFault::BadName`] if the path names no library, for example only a root.
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

    /// Path as `libPath` returns it, which identifies a library: the folder, the archive, or the project file if its
    /// name differs from the folder's name.
    #[must_use]
    pub fn path(&self) -> ControllerPath {
        let usual = self.folder.name().map(|name| format!("{name}.pjx"));
        match (&self.manifest, usual) {
            (Some(manifest), Some(usual)) if manifest.eq_ignore_ascii_case(&usual) => self.folder.clone(),
            (Some(manifest), _) => self.folder.child(manifest),
            (None, _) => self.folder.clone(),
        }
    }

    /// Path of the project file, or of the archive: `Disk://name/name.pjx`.
    #[must_use]
    pub fn project(&self) -> ControllerPath {
        self.manifest.as_ref().map_or_else(|| self.folder.clone(), |manifest| self.folder.child(manifest))
    }

    /// The folder, or the archive.
    #[must_use]
    pub fn folder(&self) -> &ControllerPath {
        &self.folder
    }

    /// Resolves the project file or the archive. Steps that a crash has interrupted are completed first.
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

    /// Whether the library exists.
    ///
    /// # Errors
    /// If the path cannot be resolved.
    pub fn exists(&self, roots: &Roots) -> Result<bool, FileFault> {
        Ok(self.place(roots)?.kind()? == EntryKind::File)
    }

    /// Reads all files of the library. `password` is the ZIP password of the archive.
    ///
    /// Missing files that the project names are omitted; loading reports them.
    ///
    /// # Errors
    /// [`FileFault::NotFound`] if the library does not exist, [`FileFault::BadPath`] if its parent folder does not
    /// exist either, [`FileFault::NotEncrypted`] and [`FileFault::CannotLoad`] for archives according to 6.6.
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

    /// Deletes the library, and its folder if it contains nothing else. The project file is deleted first, so that no
    /// partial library exists after a crash.
    ///
    /// # Errors
    /// If the path cannot be resolved or a file cannot be deleted. A missing library is no error.
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

    /// Saves a library to the path from which it was loaded: the files of `new` that differ from `old`, and files that
    /// are missing on the medium. After a crash at any time, either the complete old or the complete new library
    /// exists.
    ///
    /// # Errors
    /// [`FileFault::ReadOnly`] for an archive, which is never written unencrypted, or the error of the medium. Nothing
    /// has changed then.
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

    /// Saves a library under another path. The parent of the library's folder must exist.
    ///
    /// # Errors
    /// [`FileFault::LibraryThere`] if the library exists, [`FileFault::BadPath`] if the parent folder does not exist,
    /// [`FileFault::BadName`] for an archive, [`FileFault::ReadOnly`] for an encrypted library, which is never written
    /// unencrypted, or the error of the medium.
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
    /// Total size of all files, in bytes.
    #[must_use]
    pub fn size(&self) -> usize {
        self.files.iter().map(|file| file.bytes.len()).sum()
    }

    /// File with this path relative to the library's folder.
    #[must_use]
    pub fn file(&self, path: &Utf8Path) -> Option<&LibraryFile> {
        self.files.iter().find(|file| file.path == path)
    }

    /// Whether its data files have the format of s5 and s6, which contains no links of inputs, outputs and lines.
    #[must_use]
    pub fn omits_links(&self) -> bool {
        let mut files = self.files.iter().filter(|file| has_extension(&file.path, "dtx"));
        files.any(|file| is_list_file(&decode(file.bytes.clone()).text))
    }

    /// Returns a copy of the library with these data values.
    ///
    /// # Errors
    /// A value that a data file cannot contain.
    pub fn with_data(&self, data: &[SavedData]) -> Result<Self, UnwritableValue> {
        let mut new = self.clone();
        for file in new.files.iter_mut().filter(|file| has_extension(&file.path, "dtx")) {
            let decoded = decode(file.bytes.clone());
            let text = rewrite(&decoded.text, data)?;
            if text != decoded.text {
                file.bytes = decoded.encoding.encode(&text);
            }
        }
        Ok(new)
    }
}

/// Lists the names in a folder, sorted without regard to letter case (`libList`).
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
    let entries = root.into_iter().flat_map(xml::XmlElement::elements).flat_map(xml::XmlElement::elements);
    let of_files =
        entries.filter(|entry| ["program", "data"].iter().any(|name| entry.name().eq_ignore_ascii_case(name)));
    of_files.filter_map(|entry| entry.value("file").map(|file| file.trim().to_owned())).collect()
}

#[cfg(test)]
mod tests;
