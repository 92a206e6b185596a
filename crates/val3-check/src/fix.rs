//! Fixes: what rules need to word them, and how they are applied.
//!
//! A fix says which ranges of which files to replace, in the characters of the file. It is *safe* when the program
//! does the same afterwards or what was plainly meant; otherwise it is a guess that a person looks at.

mod apply;
mod errors;
mod guard;
mod rounds;
mod site;
mod table;
#[cfg(test)]
mod tests;

pub use apply::FixedFile;
pub use errors::TrialWorkspace;
pub use guard::{AddedError, FixGuard};
pub use rounds::{AppliedFixes, FixTarget, add_suppressions, apply_fixes};
pub(crate) use site::{Site, rename};
pub(crate) use table::{of_problem, of_syntax};
