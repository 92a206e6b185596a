//! The instruction of a recorded move.

use val3_lang::ports::CodePlace;
use val3_lang::values::MdescValue;

/// The instruction that has recorded a move.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MoveOrigin {
    /// Its name: `movel`.
    pub instruction: &'static str,
    /// Its line.
    pub at: CodePlace,
    /// Its motion descriptor, with lengths in mm.
    pub descriptor: MdescValue,
    /// Line that has cancelled the blend at its destination.
    pub cancelled_by: Option<CodePlace>,
}
