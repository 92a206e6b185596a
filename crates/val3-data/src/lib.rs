//! Data files (`.dtx`) of both dialects as plain values: reading them, and writing new values.
//!
//! Values are texts as spelled in files. The editor and the controller's `libSave` use the same code, so both keep the
//! format of a file.

mod declarations;
mod document;
mod edits;
mod layout;
mod lists;
mod read;
mod reference;
mod rewrite;
mod saved_data;
mod tag;
mod unwritable;
mod values;
mod written;

pub use declarations::{after, duplicate, in_style, remove, rename_key};
pub use document::{DeclaredData, document};
pub use edits::compose;
pub use lists::is_list_file;
pub use read::{read, type_name};
pub use reference::is_old_reference;
pub use rewrite::{edits, rewrite};
pub use saved_data::{
    SavedContainer, SavedContent, SavedData, SavedField, SavedValue, default_of, is_same, number_text,
    rounded_number_text, same_text,
};
pub use unwritable::{UnwritableReason, UnwritableValue};
pub use written::{WrittenAttribute, WrittenVariable, written};
