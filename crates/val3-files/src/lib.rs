//! Reads files with a size limit for each class, replaces files atomically, and lists and changes folders.
//!
//! All files that the tools read or write pass through this crate. The exceptions are the media of running programs
//! (`val3-machine`), which are confined to their folders, and the project's own development tools. A test checks this
//! (`xtask/tests/files_once.rs`).

mod archive;
mod class;
mod copied_metadata;
mod direct;
mod existing;
mod folders;
mod in_place;
mod new_file;
mod output_file;
mod process_lock;
mod read;
mod temporary;
#[cfg(test)]
mod testing;
mod unreadable;
mod unwritable;

pub use archive::{ArchiveFault, EntryDate, archive_dates, archive_entries, is_archive_name, unpack};
pub use class::{FileClass, ProcessLimits};
pub use direct::write_directly;
pub use existing::replace_unchanged;
pub use folders::{
    FolderEntry, FolderEntryKind, create_folder, create_folders, folder_with, list_folder, remove_file, remove_folder,
    remove_tree, rename_file,
};
pub use new_file::{NewFile, replace};
pub use output_file::{LogFile, OutputFile};
pub use process_lock::ProcessLock;
pub use read::{read, read_from, read_head, read_stream, read_text};
pub use unreadable::Unreadable;
pub use unwritable::Unwritable;
