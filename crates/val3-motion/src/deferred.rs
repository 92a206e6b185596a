//! Moves whose start is not known: they follow an alterable path, which ends wherever `alterEnd` leaves the arm.

use std::collections::VecDeque;

use crate::path::PathEnd;
use crate::request::Move;

/// A request that waits.
#[derive(Clone, Debug)]
pub(crate) enum DeferredRequest {
    /// A move with its serial number.
    Move(u64, Box<Move>),
    /// The last move ends at its destination.
    Close,
}

/// The requests that wait.
#[derive(Clone, Debug)]
pub(crate) struct Deferred {
    pub(crate) requests: VecDeque<DeferredRequest>,
    /// The path without any deviation, on which their targets are checked.
    pub(crate) nominal: PathEnd,
}
