//! Reads files with a limit for their class, and replaces files as a whole.
//!
//! Every file that the tools read or write passes through this crate. The exceptions are the media of running programs
//! (`val3-machine`), which are confined to their folders, and the tools of the project itself. `clippy.toml` forbids the
//! functions of the standard library.

#![allow(clippy::disallowed_methods, reason = "the other crates read and write files through this one")]

mod class;
mod copied_metadata;
mod existing;
mod in_place;
mod new_file;
mod output;
mod read;
mod temporary;
mod unreadable;
mod unwritable;

pub use class::{FileClass, raise_limits};
pub use existing::replace_unchanged;
pub use new_file::{NewFile, replace};
pub use output::{Log, Output};
pub use read::{read, read_stream, read_text};
pub use unreadable::Unreadable;
pub use unwritable::Unwritable;
