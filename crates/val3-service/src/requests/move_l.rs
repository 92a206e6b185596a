//! `moveL`: records a move to a position on a line.

use val3_moves::MovePath;
use val3_soap::SoapFault;
use val3_soap::v3::{MoveAnswer, MoveL};

use crate::context::Context;
use crate::moves::PositionElement;

/// Answers the request.
pub(super) fn answer(request: &MoveL, context: &mut Context<'_, '_>) -> Result<MoveAnswer, SoapFault> {
    let MoveL { robot, frame, description } = request;
    context.record_move_to(
        "moveL",
        *robot,
        description,
        PositionElement { name: "frame", matrix: frame },
        |_, target| Ok(MovePath::Line(target)),
    )
}
