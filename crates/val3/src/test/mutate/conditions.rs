//! Context shared by all test executions.

use std::sync::atomic::AtomicBool;

use crate::args::TestArgs;
use crate::test::workers::Surroundings;

/// Default seed for the choice of mistakes.
pub(super) const SEED: u64 = 1;

/// Context shared by all test executions.
#[derive(Clone, Copy)]
pub(super) struct Conditions<'c> {
    pub(super) args: &'c TestArgs,
    pub(super) surroundings: &'c Surroundings<'c>,
    /// Flag that a signal sets.
    pub(super) is_interrupted: &'c AtomicBool,
}
