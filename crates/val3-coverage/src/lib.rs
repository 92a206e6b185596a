//! The coverage of programs by tests: the number of executions of each line and of each side of a branch.
//!
//! [`Coverage`] adds up the counts of any number of controllers, in any order. The formats write it for people and services:
//! a table, LCOV, Cobertura, JSON, and pages of HTML.

mod cobertura;
mod coverage;
mod html;
mod json;
mod lcov;
mod program;
mod share;
mod table;

pub use cobertura::write as cobertura;
pub use coverage::{Coverage, ProjectCoverage};
pub use html::{Page, pages};
pub use json::write as json;
pub use lcov::write as lcov;
pub use program::{Branch, LineState, ProgramCoverage, Side};
pub use share::Share;
pub use table::write as table;

#[cfg(test)]
mod example;
