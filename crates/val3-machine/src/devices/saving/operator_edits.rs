//! Saves values that an operator has changed to the files from which they were loaded.

use std::sync::Arc;

use val3_data::rounded_number_text;
use val3_lang::memory::Place;
use val3_vm::{Instance, InstanceId, Space};

use super::Saving;
use super::values::Saver;
use crate::devices::lines::ChannelTable;
use crate::devices::loaded::LoadedProjects;
use crate::devices::outside::{Outside, controller_path};
use crate::files::{FileFault, LibraryFile, LibraryFiles, LibraryPath, Uninterrupted};
use crate::io::IoTable;

/// The result of a save.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum SavedValues {
    /// The files that were written.
    Written(Vec<String>),
    /// Files that were changed or deleted on the medium since they were loaded. Nothing was written.
    Conflict(Vec<String>),
}

/// Extension of the copies that contain unsaved values.
const COPY: &str = "unsaved";

/// An application's or library's files: as loaded, on the medium, and with the new values.
struct Change {
    instance: InstanceId,
    path: LibraryPath,
    loaded: Arc<LibraryFiles>,
    old: LibraryFiles,
    new: LibraryFiles,
    /// The loaded files with the new values: a file that differs from its loaded version contains one of these values.
    meant: LibraryFiles,
}

/// Request to save values that an operator has changed.
pub(in crate::devices) struct SaveRequest<'s> {
    pub(in crate::devices) space: &'s Space,
    /// Places of the values.
    pub(in crate::devices) places: &'s [Place],
    pub(in crate::devices) io: &'s IoTable,
    pub(in crate::devices) lines: &'s ChannelTable,
    /// Whether to write files that have changed since they were loaded.
    pub(in crate::devices) overwrite: bool,
}

/// Writes only the requested values into the data files, with six decimals at most; all other values in the files are
/// kept.
///
/// # Errors
/// A file cannot be read or written, or belongs to an encrypted library.
pub(in crate::devices) fn save(
    request: &SaveRequest<'_>,
    loaded: &mut LoadedProjects,
    outside: &mut Outside,
) -> Result<SavedValues, FileFault> {
    let (mut conflicts, mut written) = (Vec::new(), Vec::new());
    let changes = changes(request, loaded, outside)?;
    for change in &changes {
        for file in &change.new.files {
            if change.is_written(file) {
                written.push(change.name(file));
            }
            if change.is_concerned(file) && change.old.file(&file.path) != change.loaded.file(&file.path) {
                conflicts.push(change.name(file));
            }
        }
    }
    if !conflicts.is_empty() && !request.overwrite {
        return Ok(SavedValues::Conflict(conflicts));
    }
    for Change { instance, path, old, new, .. } in changes {
        outside.ask(|media| path.save(&media.roots, &old, &new, &mut Uninterrupted))?;
        loaded.keep_files(instance.0, new);
    }
    Ok(SavedValues::Written(written))
}

/// Writes copies of the data files with the requested values next to these files: `main.dtx.unsaved`. Returns their
/// names.
///
/// # Errors
/// A file cannot be read or written, or belongs to an encrypted library.
pub(in crate::devices) fn save_copies(
    request: &SaveRequest<'_>,
    loaded: &LoadedProjects,
    outside: &mut Outside,
) -> Result<Vec<String>, FileFault> {
    let mut written = Vec::new();
    for change in changes(request, loaded, outside)? {
        let concerned = change.new.files.iter().filter(|file| change.is_concerned(file));
        let copies: Vec<LibraryFile> = concerned.map(copy).collect();
        written.extend(copies.iter().map(|file| change.name(file)));
        let nothing = LibraryFiles { files: Vec::new(), encrypted: false };
        let copies = LibraryFiles { files: copies, encrypted: false };
        outside.ask(|media| change.path.save(&media.roots, &nothing, &copies, &mut Uninterrupted))?;
    }
    Ok(written)
}

fn copy(file: &LibraryFile) -> LibraryFile {
    LibraryFile { path: format!("{}.{COPY}", file.path).into(), bytes: file.bytes.clone() }
}

/// Changes of all applications and libraries with requested values.
fn changes(
    request: &SaveRequest<'_>,
    loaded: &LoadedProjects,
    outside: &mut Outside,
) -> Result<Vec<Change>, FileFault> {
    let mut changes = Vec::new();
    for (saved, instance) in request.space.loaded() {
        changes.extend(Change::of(request, saved, instance, loaded, outside)?);
    }
    Ok(changes)
}

impl Change {
    /// Change of an application or library; `None` if it contains no requested value.
    fn of(
        request: &SaveRequest<'_>,
        saved: InstanceId,
        instance: &Instance,
        loaded: &LoadedProjects,
        outside: &mut Outside,
    ) -> Result<Option<Self>, FileFault> {
        let SaveRequest { space, io, lines, .. } = *request;
        let saving = Saving { space, from: saved, saved, io, lines, limit: u64::MAX };
        let saver = saving.saver().map(|saver| Saver { number_text: rounded_number_text, ..saver });
        let data = saver.map(|saver| saver.at(request.places)).unwrap_or_default();
        if data.is_empty() {
            return Ok(None);
        }
        let path = LibraryPath::new(&controller_path("", &instance.path)?)?;
        let loaded = loaded.files(saved.0).ok_or(FileFault::NotFound)?;
        if loaded.encrypted {
            return Err(FileFault::ReadOnly);
        }
        let old = match outside.ask(|media| path.read(&media.roots, "")) {
            Err(FileFault::NotFound | FileFault::BadPath) => LibraryFiles { files: Vec::new(), encrypted: false },
            found => found?,
        };
        let mut base = old.clone();
        base.files.extend(loaded.files.iter().filter(|file| old.file(&file.path).is_none()).cloned());
        let (new, meant) = (base.with_data(&data)?, loaded.with_data(&data)?);
        Ok(Some(Self { instance: saved, path, loaded, old, new, meant }))
    }

    /// Whether a file with new values differs from the file on the medium.
    fn is_written(&self, file: &LibraryFile) -> bool {
        self.old.file(&file.path) != Some(file)
    }

    /// Whether a file contains new values.
    fn is_concerned(&self, file: &LibraryFile) -> bool {
        self.is_written(file) || self.meant.file(&file.path) != self.loaded.file(&file.path)
    }

    /// File name on the controller.
    fn name(&self, file: &LibraryFile) -> String {
        format!("{}/{}", self.path.folder(), file.path)
    }
}
