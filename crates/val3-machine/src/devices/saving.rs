//! `libSave` (6.7).
//!
//! The files of an application or library stay in memory as they were loaded, so that it can be saved where its files
//! were deleted or changed. Unchanged values leave the bytes of their file unchanged.

mod links;
mod values;

use val3_vm::{InstanceId, Space};

use super::Devices;
use super::media::controller_path;
use crate::files::{FileFault, LibraryFiles, LibraryPath, Uninterrupted};
use links::Links;
use values::Saver;

/// Bytes of the global data of an application or library.
fn data_bytes(space: &Space, saved: InstanceId) -> u64 {
    let data = space.instance(saved).map(|instance| instance.data.iter());
    data.into_iter().flatten().map(|store| space.memory.bytes(*store)).sum()
}

impl Devices {
    /// Keeps the files of what was loaded, as the place to write its data to.
    pub fn keep_files(&mut self, instance: InstanceId, path: &str) {
        let library = controller_path("", path).and_then(|path| LibraryPath::new(&path));
        if let Ok(files) = library.and_then(|library| self.outside.ask(|media| library.read(&media.roots, ""))) {
            self.state.loaded.keep_files(instance.0, files);
        }
    }

    /// Saves `saved` where the program of `from` wants it, or where it was loaded from.
    pub(super) fn save_library(
        &mut self,
        space: &Space,
        (from, saved): (InstanceId, InstanceId),
        to: Option<&str>,
    ) -> Result<(), FileFault> {
        self.access(0);
        let path = |id| space.instance(id).map_or("", |instance| instance.path.as_str());
        let origin = LibraryPath::new(&controller_path("", path(saved))?)?;
        let loaded = self.state.loaded.files(saved.0).ok_or(FileFault::NotFound)?;
        if data_bytes(space, saved) > self.limits.saved {
            return Err(FileFault::DiskFull);
        }
        let new = loaded.with_data(&self.saver(space, saved).ok_or(FileFault::NoLibrary)?.all());
        self.access(new.size());
        match to {
            Some(to) => {
                let target = LibraryPath::new(&controller_path(path(from), to)?)?;
                self.outside.ask(|media| target.save_as(&media.roots, &new, &mut Uninterrupted))
            }
            None => self.outside.ask(|media| {
                // Files that are no longer on the medium are written again.
                let nothing = LibraryFiles { files: Vec::new(), encrypted: new.encrypted };
                let old = if new.encrypted { nothing } else { origin.read(&media.roots, "").unwrap_or(nothing) };
                origin.save(&media.roots, &old, &new, &mut Uninterrupted)
            }),
        }
    }

    fn saver<'s>(&'s self, space: &'s Space, saved: InstanceId) -> Option<Saver<'s>> {
        let instance = space.instance(saved)?;
        Some(Saver { memory: &space.memory, instance, links: Links::new(space, (saved, instance), self) })
    }
}
