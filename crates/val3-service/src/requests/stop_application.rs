//! `stopApplication`: executes the program `stop` of the application. It has no effect on an application that does not run.

use val3_machine::controller::{ApplicationState, OperatorAction};
use val3_soap::v2::StopApplication;
use val3_soap::{Empty, SoapFault};

use crate::context::Context;

/// Answers the request.
pub(super) fn answer(_: &StopApplication, context: &mut Context<'_, '_>) -> Result<Empty, SoapFault> {
    if context.controller().application_state() == ApplicationState::Started {
        context.operate(&[OperatorAction::Stop]);
    }
    Ok(Empty)
}
