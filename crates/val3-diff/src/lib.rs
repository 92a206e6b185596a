//! What differs between two backups of a controller: two sets of files in, a plain list of changes out, and renderers of
//! that list. Nothing here reads files, starts processes or knows the time.

mod applications;
mod compare;
mod exclusions;
pub mod format;
mod listing;
pub mod model;
mod read;
pub mod report;
mod selection;
mod tree;

pub use compare::{compare, compare_with};
pub use exclusions::{Exclusions, Layout, NamePattern, Tolerance};
pub use listing::listing;
pub use model::{Class, Comparison};
pub use tree::Tree;
