//! `getProject`: the files of a project as an archive, as in memory if it is loaded. The form is inferred.

use val3_soap::v2::{GetProject, GetProjectAnswer};
use val3_soap::{Binary, SoapFault};

use crate::context::Context;
use crate::projects::{NamedProject, find, unreadable_project};

/// Answers the request.
pub(super) fn answer(request: &GetProject, context: &mut Context<'_, '_>) -> Result<GetProjectAnswer, SoapFault> {
    let controller = context.controller();
    let files = match find(controller, request.name.as_deref().unwrap_or_default())? {
        NamedProject::Loaded(instance) => controller.devices.current_files(&controller.vm.space, instance),
        NamedProject::Stored(path) => controller.devices.stored_files(&path),
    };
    let data = files.and_then(|files| files.zipped()).map_err(|fault| unreadable_project("files", fault))?;
    Ok(GetProjectAnswer { data: Binary(data) })
}
