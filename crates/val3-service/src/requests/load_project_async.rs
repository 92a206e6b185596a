//! `loadProjectAsync`: loads the application of the run with its initial values, as soon as it has stopped. It has no effect
//! on an application in memory.

use val3_machine::controller::{ApplicationState, OperatorAction};
use val3_soap::v2::LoadProjectAsync;
use val3_soap::{Empty, SoapFault};

use crate::context::Context;
use crate::projects::check_application;

/// Answers the request.
pub(super) fn answer(request: &LoadProjectAsync, context: &mut Context<'_, '_>) -> Result<Empty, SoapFault> {
    let controller = context.controller();
    check_application(controller, request.path.as_deref().unwrap_or_default())?;
    if controller.application_state() == ApplicationState::Unloaded {
        context.operate(&[OperatorAction::Load]);
    }
    Ok(Empty)
}
