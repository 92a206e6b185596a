//! `moveL`: records a move to a position on a line.

use val3_moves::MovePath;
use val3_soap::SoapFault;
use val3_soap::v3::{MoveAnswer, MoveL};

use crate::context::Context;

/// Answers the request.
pub(super) fn answer(request: &MoveL, context: &mut Context<'_, '_>) -> Result<MoveAnswer, SoapFault> {
    let MoveL { robot, frame, description } = request;
    context.record_move_to("moveL", *robot, description, ("frame", frame), |_, target| Ok(MovePath::Line(target)))
}
