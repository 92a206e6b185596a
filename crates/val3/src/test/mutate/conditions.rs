//! What all executions of tests share.

use std::sync::atomic::AtomicBool;

use crate::args::TestArgs;
use crate::test::workers::Surroundings;

/// The seed of the choice of mistakes unless the arguments set another one.
pub(super) const SEED: u64 = 1;

/// What all executions of tests share.
#[derive(Clone, Copy)]
pub(super) struct Conditions<'c> {
    pub(super) args: &'c TestArgs,
    pub(super) surroundings: &'c Surroundings<'c>,
    /// Set by a signal.
    pub(super) is_interrupted: &'c AtomicBool,
}
