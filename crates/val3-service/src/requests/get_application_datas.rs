//! `getApplicationDatas`: the data file of a project, with the current values if it is in memory.

use val3_soap::v1::{GetApplicationDatas, GetApplicationDatasAnswer};
use val3_soap::{Binary, SoapFault};

use crate::context::Context;
use crate::projects::{NamedProject, find, unreadable_project};

/// Answers the request.
pub(super) fn answer(
    request: &GetApplicationDatas,
    context: &mut Context<'_, '_>,
) -> Result<GetApplicationDatasAnswer, SoapFault> {
    let controller = context.controller();
    let data = match find(controller, request.name.as_deref().unwrap_or_default())? {
        NamedProject::Loaded(instance) => controller.devices.current_data_file(&controller.vm.space, instance),
        NamedProject::Stored(path) => controller.devices.stored_data_file(&path),
    };
    let data = data.map_err(|fault| unreadable_project("data file", fault))?;
    Ok(GetApplicationDatasAnswer { data: Binary(data) })
}
