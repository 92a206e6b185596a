//! `startApplication`: starts the application with its present values, as soon as it has stopped.

use val3_machine::controller::{ApplicationState, OperatorAction};
use val3_soap::v2::StartApplication;
use val3_soap::{Empty, ExceptionCode, SoapFault};

use crate::context::{Context, refused};
use crate::projects::check_application;

/// Answers the request.
pub(super) fn answer(request: &StartApplication, context: &mut Context<'_, '_>) -> Result<Empty, SoapFault> {
    let controller = context.controller();
    check_application(controller, request.path.as_deref().unwrap_or_default())?;
    match controller.application_state() {
        ApplicationState::Unloaded => {
            Err(refused(ExceptionCode::ApplicationNotFound, "load the application first (loadProjectAsync)"))
        }
        ApplicationState::Started => {
            Err(refused(ExceptionCode::Unknown, "the application runs: stop it first (stopApplication)"))
        }
        ApplicationState::Stopped => {
            context.operate(&[OperatorAction::Start]);
            Ok(Empty)
        }
    }
}
