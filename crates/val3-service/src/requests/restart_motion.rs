//! `restartMotion`: continues the moves of clients after a stop.

use val3_machine::arm::ClientCommand;
use val3_soap::SoapFault;
use val3_soap::v3::{MotionAnswer, RestartMotion};

use crate::context::Context;

/// Answers the request.
pub(super) fn answer(_: &RestartMotion, context: &mut Context<'_, '_>) -> Result<MotionAnswer, SoapFault> {
    Ok(context.command_moves(ClientCommand::Restart, "restartMotion"))
}
