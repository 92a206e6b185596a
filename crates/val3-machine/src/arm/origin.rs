//! Instruction of a recorded move.

use val3_lang::ports::CodePlace;
use val3_lang::values::MdescValue;

/// Instruction that has recorded a move.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MoveOrigin {
    /// Name: `movel`.
    pub instruction: &'static str,
    /// Location in the code.
    pub at: CodePlace,
    /// Motion descriptor, with lengths in mm.
    pub descriptor: MdescValue,
    /// Line that has cancelled the blend at the destination.
    pub cancelled_by: Option<CodePlace>,
}
