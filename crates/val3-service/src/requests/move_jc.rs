//! `moveJC`: records a move to a position in joint space.

use val3_moves::MovePath;
use val3_soap::SoapFault;
use val3_soap::v3::{MoveAnswer, MoveJc};

use crate::context::Context;
use crate::moves::PositionElement;

/// Answers the request.
pub(super) fn answer(request: &MoveJc, context: &mut Context<'_, '_>) -> Result<MoveAnswer, SoapFault> {
    let MoveJc { robot, frame, description } = request;
    context.record_move_to(
        "moveJC",
        *robot,
        description,
        PositionElement { name: "frame", matrix: frame },
        |_, target| Ok(MovePath::JointToPoint(target)),
    )
}
