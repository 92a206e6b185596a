//! `loadProjectAsync`: reads and compiles a project on `Disk`, and loads it with its initial values as soon as the present
//! application has left the memory. It has no effect on an application in memory.

use val3_machine::controller::{ApplicationState, OperatorAction};
use val3_machine::files::FileFault;
use val3_session::LoadRequest;
use val3_soap::v2::LoadProjectAsync;
use val3_soap::{Empty, ExceptionCode, SoapFault};

use crate::applications;
use crate::context::{Context, refused};
use crate::inferred::NOT_LOADED;
use crate::projects::{find_stored, unreadable_project};

/// Answers the request.
pub(super) fn answer(request: &LoadProjectAsync, context: &mut Context<'_, '_>) -> Result<Empty, SoapFault> {
    let name = request.path.as_deref().unwrap_or_default();
    let controller = context.controller();
    let (present, _) = applications::next_application(controller);
    let is_in_memory = controller.application_state() != ApplicationState::Unloaded;
    let is_present = present.eq_ignore_ascii_case(name);
    if is_in_memory && is_present {
        return Ok(Empty);
    }
    let stored = if is_present { present.clone() } else { find_stored(controller, name)? };
    if is_in_memory {
        let explanation = format!("{present} is in memory: unload it first (stopAndUnloadAll)");
        return Err(refused(NOT_LOADED, &explanation));
    }
    let files = controller.devices.stored_files(&stored).map_err(|fault| unreadable_project("files", fault))?;
    if files.encrypted {
        return Err(unreadable_project("files", FileFault::ReadOnly));
    }
    let (_, image) = applications::next_application(&context.target.debugger.controller);
    let image = image.ok_or_else(|| refused(ExceptionCode::ApplicationNotFound, "no application was in memory"))?;
    let project = LoadRequest { path: &stored, files, present: image, is_present };
    let project = context
        .target
        .evaluator
        .load_project(project)
        .map_err(|reason| refused(NOT_LOADED, &format!("the project cannot be loaded: {reason}")))?;
    let number = context.controller().prepare_project(project);
    context.operate(&[OperatorAction::Load(number)]);
    Ok(Empty)
}
