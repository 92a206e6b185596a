//! A single blend, without a queue of moves and without times.

use val3_kinematics::{Arm, Joints};
use val3_moves::Millimetres;

use crate::fault::Cause;
use crate::model::Model;
use crate::path::PathEnd;
use crate::request::Move;

/// Why an arm at `start` cannot follow the blend between two moves; `None` if it can, or if there is no blend.
///
/// `reach` is that of the blend before the first move, 0 if the arm begins it from rest.
///
/// # Errors
/// The arm cannot follow one of the moves themselves.
pub fn blend_fault(arm: &Arm, start: Joints, moves: [&Move; 2], reach: Millimetres) -> Result<Option<Cause>, Cause> {
    PathEnd::starting_at(start.into()).blend_fault(&Model(arm), moves, reach)
}
