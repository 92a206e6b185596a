//! `startApplication`: starts the application with its present values, as soon as it has stopped.

use val3_machine::controller::{ApplicationState, OperatorAction};
use val3_soap::v2::StartApplication;
use val3_soap::{Empty, ExceptionCode, SoapFault};

use crate::applications;
use crate::context::{Context, refused};
use crate::inferred::NOT_LOADED;

/// Programs that every application has (2.1.2).
const PROGRAMS: [&str; 2] = ["start", "stop"];

/// Answers the request.
pub(super) fn answer(request: &StartApplication, context: &mut Context<'_, '_>) -> Result<Empty, SoapFault> {
    let name = request.path.as_deref().unwrap_or_default();
    let controller = context.controller();
    let (application, image) = applications::next_application(controller);
    let state = controller.application_state();
    if state == ApplicationState::Unloaded || !application.eq_ignore_ascii_case(name) {
        let reason = "the application is not in memory: load it first (loadProjectAsync)";
        return Err(refused(ExceptionCode::ApplicationNotFound, reason));
    }
    if state == ApplicationState::Started {
        return Err(refused(NOT_LOADED, "the application runs: stop it first (stopApplication)"));
    }
    let has = |program: &str| image.is_some_and(|image| image.program(program).is_some());
    if let Some(missing) = PROGRAMS.into_iter().find(|program| !has(program)) {
        let reason = format!("the project cannot be started, because it has no program `{missing}`");
        return Err(refused(NOT_LOADED, &reason));
    }
    context.operate(&[OperatorAction::Start]);
    Ok(Empty)
}
