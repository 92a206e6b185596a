//! The instruction of a recorded move.

use val3_lang::ports::CodePlace;

/// The instruction that has recorded a move.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct MoveOrigin {
    /// Its name: `movel`.
    pub instruction: &'static str,
    /// Its line.
    pub at: CodePlace,
}
