//! The data files (`.dtx`) of both dialects as plain values: what they hold, and how new values get into them.
//!
//! Values are texts, as files spell them. The editor and the controller's `libSave` write through the same code, so that
//! both keep the layout of a file.

mod declarations;
mod declared;
mod edits;
mod layout;
mod lists;
mod read;
mod reference;
mod rewrite;
mod saved_data;
mod tag;
mod values;

pub use declarations::{after, duplicate, in_style, remove, rename_key};
pub use edits::{apply, compose};
pub use read::{read, type_name};
pub use reference::is_old_reference;
pub use rewrite::{edits, rewrite};
pub use saved_data::{Content, SavedData, SavedField, SavedValue, Shape, default_of, is_same, number_text, same_text};
