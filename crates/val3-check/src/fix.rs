//! Fixes: their creation by rules, and their application.
//!
//! A fix lists ranges of files to replace, with their new text encoded like the file. It is *safe* if the program keeps
//! its behaviour or the change is certainly intended. Otherwise it is a guess that needs confirmation.

mod apply;
mod errors;
mod guard;
mod offers;
mod rounds;
mod site;
mod table;
#[cfg(test)]
mod tests;

pub use apply::FixedFile;
pub use errors::TrialWorkspace;
pub use guard::{AddedError, FixGuard};
pub use offers::{FixSafety, Offer, fix_offer};
pub use rounds::{AppliedFixes, FixTarget, add_suppressions, apply_fixes};
pub(crate) use site::{Site, rename};
pub(crate) use table::{of_problem, of_syntax};
