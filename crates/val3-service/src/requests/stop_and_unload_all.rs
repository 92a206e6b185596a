//! `stopAndUnloadAll`: stops the application, and then removes it and its libraries from memory.

use val3_machine::controller::{ApplicationState, OperatorAction};
use val3_soap::v2::StopAndUnloadAll;
use val3_soap::{Empty, SoapFault};

use crate::context::Context;

/// Answers the request.
pub(super) fn answer(_: &StopAndUnloadAll, context: &mut Context<'_, '_>) -> Result<Empty, SoapFault> {
    context.discard_changes();
    match context.controller().application_state() {
        ApplicationState::Unloaded => {}
        ApplicationState::Stopped => context.operate(&[OperatorAction::Unload]),
        ApplicationState::Started => context.operate(&[OperatorAction::Stop, OperatorAction::Unload]),
    }
    Ok(Empty)
}
