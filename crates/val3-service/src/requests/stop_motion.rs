//! `stopMotion`: stops the arm on the path of a client.

use val3_machine::arm::ClientCommand;
use val3_soap::SoapFault;
use val3_soap::v3::{MotionAnswer, StopMotion};

use crate::context::Context;

/// Answers the request.
pub(super) fn answer(_: &StopMotion, context: &mut Context<'_, '_>) -> Result<MotionAnswer, SoapFault> {
    Ok(context.command_moves(ClientCommand::Stop, "stopMotion"))
}
