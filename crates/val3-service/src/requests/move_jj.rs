//! `moveJJ`: records a move to joints. The configuration of the description is not used.

use val3_moves::MovePath;
use val3_soap::SoapFault;
use val3_soap::v3::{MoveAnswer, MoveJj};

use crate::context::Context;

/// Answers the request.
pub(super) fn answer(request: &MoveJj, context: &mut Context<'_, '_>) -> Result<MoveAnswer, SoapFault> {
    let MoveJj { robot, joints, description } = request;
    context.check_robot(*robot)?;
    let joints = context.joints(joints)?;
    context.record_move("moveJJ", *robot, description, |_, context| {
        Ok(MovePath::Joint(context.destination(&joints, description.kind)))
    })
}
