//! `moveC`: records a move to a position on a circle.

use val3_moves::MovePath;
use val3_soap::SoapFault;
use val3_soap::v3::{MoveAnswer, MoveC};

use crate::context::Context;
use crate::moves::PositionElement;

/// Answers the request.
pub(super) fn answer(request: &MoveC, context: &mut Context<'_, '_>) -> Result<MoveAnswer, SoapFault> {
    let MoveC { robot, intermediate, destination, description } = request;
    let intermediate = PositionElement { name: "frameB", matrix: intermediate };
    let destination = PositionElement { name: "frameC", matrix: destination };
    context.record_move_to("moveC", *robot, description, destination, |frames, target| {
        Ok(MovePath::Circle(frames.in_world(intermediate)?, target))
    })
}
