//! Check of a single blend, without a queue and without speeds.

use val3_kinematics::{Arm, Joints};
use val3_moves::Millimetres;

use crate::fault::Cause;
use crate::model::Model;
use crate::path::PathEnd;
use crate::request::Move;

/// Returns the cause for which an arm at `start` cannot follow the blend between two moves; `None` if it can, or
/// without a blend.
///
/// `reach` is the reach of the blend before the first move, or 0 if the first move begins at rest.
///
/// # Errors
/// Returns the cause if the arm cannot follow one of the two moves.
pub fn blend_fault(arm: &Arm, start: Joints, moves: [&Move; 2], reach: Millimetres) -> Result<Option<Cause>, Cause> {
    PathEnd::starting_at(start.into()).blend_fault(&Model(arm), moves, reach)
}
