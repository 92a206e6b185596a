//! Deferred moves: their start is unknown, because they follow an alterable path whose end depends on the deviation at
//! `alterEnd`.

use std::collections::VecDeque;

use crate::path::PathEnd;
use crate::request::Move;

/// Deferred request.
#[derive(Clone, Debug)]
pub(crate) enum DeferredRequest {
    /// Move with its serial number.
    Move(u64, Box<Move>),
    /// End of the last move at its destination, without a blend.
    Close,
}

/// Deferred requests.
#[derive(Clone, Debug)]
pub(crate) struct Deferred {
    pub(crate) requests: VecDeque<DeferredRequest>,
    /// Path without a deviation, on which the requested targets are checked.
    pub(crate) nominal: PathEnd,
}
