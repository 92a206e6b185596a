//! `resetMotion`: discards all moves of clients.

use val3_machine::arm::ClientCommand;
use val3_soap::SoapFault;
use val3_soap::v3::{MotionAnswer, ResetMotion};

use crate::context::Context;

/// Answers the request.
pub(super) fn answer(_: &ResetMotion, context: &mut Context<'_, '_>) -> Result<MotionAnswer, SoapFault> {
    Ok(context.command_moves(ClientCommand::Reset, "resetMotion"))
}
