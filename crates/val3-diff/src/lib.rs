//! Differences between two backups of a controller: two sets of files in, a plain list of changes out, and renderers of
//! that list. This crate reads no files, starts no processes and has no clock.

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
pub use exclusions::{BlankComparison, Exclusions, NamePattern, Tolerance};
pub use listing::listing;
pub use model::{Comparison, ReportClass};
pub use tree::FileTree;
