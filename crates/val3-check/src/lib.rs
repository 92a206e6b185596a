//! Diagnostics: the rules with their pages, and the check that applies them.

mod built_in;
mod check;
mod conversion;
pub mod diagnostic;
mod echoes;
mod english;
mod keywords;
mod lint;
mod options;
mod phrase;
mod related;
pub mod rule;
pub mod rules;
mod statistics;
#[doc(hidden)]
#[allow(clippy::panic, reason = "a tool for tests")]
pub mod testing;

pub use check::{Unit, check_unit, check_unit_with, finish, units};
pub use options::{Asked, Options};
pub use statistics::{Statistics, statistics};
