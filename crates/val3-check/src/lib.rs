//! Diagnostics: the rules with their pages, and the check that applies the rules.

pub mod baseline;
mod built_in;
mod cascades;
mod check;
mod conversion;
pub mod diagnostic;
mod english;
pub mod fingerprint;
pub mod fix;
mod habits;
mod keywords;
mod lint;
pub mod loose;
mod phrase;
mod related;
pub mod rule;
pub mod rules;
pub mod settings;
mod shared_causes;
mod statistics;
pub mod suppression;
#[doc(hidden)]
#[allow(clippy::panic, reason = "a tool for tests")]
pub mod testing;
pub mod topics;

pub use check::{
    CheckUnit, Checked, UnitFaults, check_faults, check_in_application, check_local, check_unit, finish, finish_each,
    is_once_per_application, merge_findings, refusals, stand_in_faults, unit_refusals, units,
};
pub use shared_causes::{has_shared_cause, join_causes};
pub use statistics::{CheckStatistics, statistics};
