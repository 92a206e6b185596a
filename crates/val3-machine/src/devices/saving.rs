//! `libSave` (6.7), and values in the form of data files.
//!
//! The loaded files of applications and libraries stay in memory, so that saving is possible after the files were
//! deleted or changed. Bytes of unchanged values do not change.

mod documents;
mod links;
mod operator_edits;
mod values;

use val3_data::{UnwritableValue, number_text};
use val3_vm::{InstanceId, Space};

use super::lines::ChannelTable;
use super::loaded::LoadedProjects;
use super::media_cost::MediaCost;
use super::outside::{Outside, controller_path};
use crate::files::{FileFault, LibraryFiles, LibraryPath, Uninterrupted};
use crate::io::IoTable;
pub use documents::{DataSelection, DocumentFault};
pub(super) use documents::{data_document, frame_document};
use links::LoadedLinks;
pub use operator_edits::SavedValues;
pub(super) use operator_edits::{SaveRequest, save, save_copies};
use values::Saver;

/// Returns the size of an application's or library's global data, in bytes.
fn data_bytes(space: &Space, saved: InstanceId) -> u64 {
    let data = space.instance(saved).map(|instance| instance.data.iter());
    data.into_iter().flatten().map(|store| space.memory.bytes(*store)).sum()
}

/// Reason why a save failed.
pub(super) enum SaveFault {
    /// Fault of the medium or the path.
    File(FileFault),
    /// A value that a data file cannot contain.
    Value(UnwritableValue),
}

impl From<FileFault> for SaveFault {
    fn from(fault: FileFault) -> Self {
        Self::File(fault)
    }
}

impl From<UnwritableValue> for SaveFault {
    fn from(value: UnwritableValue) -> Self {
        Self::Value(value)
    }
}

impl From<SaveFault> for FileFault {
    fn from(fault: SaveFault) -> Self {
        match fault {
            SaveFault::File(fault) => fault,
            SaveFault::Value(value) => value.into(),
        }
    }
}

/// Save request of a program.
pub(super) struct Saving<'s> {
    pub(super) space: &'s Space,
    /// The instance whose program saves.
    pub(super) from: InstanceId,
    pub(super) saved: InstanceId,
    pub(super) io: &'s IoTable,
    pub(super) lines: &'s ChannelTable,
    /// Maximum size of the global data, in bytes.
    pub(super) limit: u64,
}

impl<'s> Saving<'s> {
    /// Saves to the path that the program names, or to the path from which the instance was loaded.
    pub(super) fn save(
        &self,
        to: Option<&str>,
        loaded: &LoadedProjects,
        time: &mut MediaCost,
        outside: &mut Outside,
    ) -> Result<(), SaveFault> {
        time.access(0);
        let origin = LibraryPath::new(&controller_path("", self.path(self.saved))?)?;
        let new = self.current(loaded)?;
        time.access(new.size());
        match to {
            Some(to) => {
                let target = LibraryPath::new(&controller_path(self.path(self.from), to)?)?;
                outside.ask(|media| target.save_as(&media.roots, &new, &mut Uninterrupted))?;
            }
            None => outside.ask(|media| {
                // Files that are no longer on the medium are written again.
                let nothing = LibraryFiles { files: Vec::new(), encrypted: new.encrypted };
                let old = if new.encrypted { nothing } else { origin.read(&media.roots, "").unwrap_or(nothing) };
                origin.save(&media.roots, &old, &new, &mut Uninterrupted)
            })?,
        }
        Ok(())
    }

    /// Returns a message about new links that the saved files do not contain; `None` if they contain all links.
    pub(super) fn lost_links(&self, loaded: &LoadedProjects) -> Option<String> {
        loaded.files(self.saved.0).filter(|files| files.omits_links())?;
        let saver = self.saver()?;
        let values = saver.links.new_ports(saver.instance);
        let (first, others) = values.split_first()?;
        let (subject, verb) = match others.len() {
            0 => (format!("`{first}`"), "is"),
            1 => (format!("`{first}` and 1 other value"), "are"),
            count => (format!("`{first}` and {count} other values"), "are"),
        };
        Some(format!(
            "{subject} {verb} saved without the link, because files of s5 and s6 contain no links of inputs, outputs and \
             lines: set the link again after loading"
        ))
    }

    /// Returns the files as loaded, with the current values.
    pub(super) fn current(&self, loaded: &LoadedProjects) -> Result<LibraryFiles, SaveFault> {
        let loaded = loaded.files(self.saved.0).ok_or(FileFault::NotFound)?;
        if data_bytes(self.space, self.saved) > self.limit {
            return Err(FileFault::DiskFull.into());
        }
        Ok(loaded.with_data(&self.saver().ok_or(FileFault::NoLibrary)?.all())?)
    }

    fn path(&self, id: InstanceId) -> &'s str {
        self.space.instance(id).map_or("", |instance| instance.path.as_str())
    }

    fn saver(&self) -> Option<Saver<'s>> {
        let instance = self.space.instance(self.saved)?;
        Some(Saver { memory: &self.space.memory, instance, links: LoadedLinks::new(self, instance), number_text })
    }
}
