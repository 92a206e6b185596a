//! Test coverage of programs: execution counts of lines and branch sides.
//!
//! [`Coverage`] sums the counts of any number of controllers, in any order. Its formats are a table, LCOV, Cobertura,
//! JSON, and HTML pages.

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
pub use html::{HtmlReport, pages};
pub use json::write as json;
pub use lcov::write as lcov;
pub use program::{Branch, LineState, ProgramCoverage, Side};
pub use share::Share;
pub use table::write as table;

#[cfg(test)]
mod example;
