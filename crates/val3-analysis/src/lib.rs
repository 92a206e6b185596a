//! Names, types and library interfaces, computed incrementally.
//!
//! The chain of queries is short and coarse: `items::parse` → items (declarations of files) → `body` → `infer`. Items
//! are the firewall: the code of a program cannot change them, so an edit of code repeats inference only for that
//! program.

pub mod add_on_programs;
pub mod application;
pub mod arm;
pub mod body;
pub mod cell;
pub mod changes;
pub mod data_check;
pub mod db;
pub mod effects;
mod file_check;
pub mod flow;
pub mod guards;
pub mod header_check;
pub mod infer;
pub mod interfaces;
pub mod items;
pub mod load;
pub mod occurrences;
pub mod pages;
pub mod paths;
pub mod placement;
pub mod problem;
pub mod project_check;
pub mod reach;
pub mod resizing;
pub mod surroundings;
pub mod system;
pub mod targets;
pub mod test_applications;
pub mod ty;
pub use val3_syntax::xml;
