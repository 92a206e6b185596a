//! Saves values that an operator has changed to the files from which they were loaded.

use val3_data::rounded_number_text;
use val3_lang::memory::Place;
use val3_vm::{InstanceId, Space};

use super::Saving;
use super::values::Saver;
use crate::devices::lines::ChannelTable;
use crate::devices::loaded::LoadedProjects;
use crate::devices::outside::{Outside, controller_path};
use crate::files::{FileFault, LibraryFiles, LibraryPath, Uninterrupted};
use crate::io::IoTable;

/// The result of a save.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum SavedValues {
    /// The files that were written.
    Written(Vec<String>),
    /// Files that were changed or deleted on the medium since they were loaded. Nothing was written.
    Conflict(Vec<String>),
}

/// An application's or library's files, on the medium and with the new values.
struct Change {
    instance: InstanceId,
    path: LibraryPath,
    old: LibraryFiles,
    new: LibraryFiles,
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
    let (mut changes, mut conflicts, mut written) = (Vec::new(), Vec::new(), Vec::new());
    let SaveRequest { space, io, lines, .. } = *request;
    for (saved, instance) in space.loaded() {
        let saving = Saving { space, from: saved, saved, io, lines, limit: u64::MAX };
        let saver = saving.saver().map(|saver| Saver { number_text: rounded_number_text, ..saver });
        let data = saver.map(|saver| saver.at(request.places)).unwrap_or_default();
        if data.is_empty() {
            continue;
        }
        let path = LibraryPath::new(&controller_path("", &instance.path)?)?;
        let known = loaded.files(saved.0).ok_or(FileFault::NotFound)?;
        if known.encrypted {
            return Err(FileFault::ReadOnly);
        }
        let old = match outside.ask(|media| path.read(&media.roots, "")) {
            Err(FileFault::NotFound | FileFault::BadPath) => LibraryFiles { files: Vec::new(), encrypted: false },
            found => found?,
        };
        let mut base = old.clone();
        base.files.extend(known.files.iter().filter(|file| old.file(&file.path).is_none()).cloned());
        let new = base.with_data(&data);
        let name = |file: &str| format!("{}/{file}", path.folder());
        // The loaded files with the new values: a file that differs from its loaded version contains one of these
        // values.
        let meant = known.with_data(&data);
        for file in &new.files {
            let is_written = old.file(&file.path) != Some(file);
            let was_meant = is_written || meant.file(&file.path) != known.file(&file.path);
            if was_meant && old.file(&file.path) != known.file(&file.path) {
                conflicts.push(name(file.path.as_str()));
            }
            if is_written {
                written.push(name(file.path.as_str()));
            }
        }
        changes.push(Change { instance: saved, path, old, new });
    }
    if !conflicts.is_empty() && !request.overwrite {
        return Ok(SavedValues::Conflict(conflicts));
    }
    for Change { instance, path, old, new } in changes {
        outside.ask(|media| path.save(&media.roots, &old, &new, &mut Uninterrupted))?;
        loaded.keep_files(instance.0, new);
    }
    Ok(SavedValues::Written(written))
}
