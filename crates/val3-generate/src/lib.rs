//! Generates what the project derives from its code: the book, and the files in `editors/` that describe the language.

#![allow(clippy::disallowed_methods, reason = "a tool of the project, not a part of the product")]

pub mod book;
pub mod editors;
mod files;
