//! `getApplicationDatas`: the data file of a project, with the current values if it is in memory.

use val3_machine::files::FileFault;
use val3_soap::v1::{GetApplicationDatas, GetApplicationDatasAnswer};
use val3_soap::{Binary, ExceptionCode, SoapFault};

use crate::applications;
use crate::context::{Context, refused};

/// Answers the request.
pub(super) fn answer(
    request: &GetApplicationDatas,
    context: &mut Context<'_, '_>,
) -> Result<GetApplicationDatasAnswer, SoapFault> {
    let name = request.name.as_deref().unwrap_or_default();
    let controller = context.controller();
    let loaded = applications::loaded(controller).find(|(_, known)| known.eq_ignore_ascii_case(name));
    let data = match loaded {
        Some((instance, _)) => controller.devices.current_data_file(&controller.vm.space, instance),
        None => match applications::stored(controller)
            .map_err(|fault| failed(&fault))?
            .into_iter()
            .find(|known| known.eq_ignore_ascii_case(name))
        {
            Some(stored) => controller.devices.stored_data_file(&stored),
            None => return Err(refused(ExceptionCode::ApplicationNotFound, "getApplications lists the applications")),
        },
    };
    data.map(|data| GetApplicationDatasAnswer { data: Binary(data) }).map_err(|fault| failed(&fault))
}

fn failed(fault: &FileFault) -> SoapFault {
    match fault {
        FileFault::ReadOnly => refused(ExceptionCode::ReadAccess, "the project is encrypted"),
        FileFault::NotFound => refused(ExceptionCode::FileNotFound, "the project has no data file"),
        other => {
            let explanation = format!("the data file cannot be read (error {} of libLoad)", other.code());
            refused(ExceptionCode::FileNotFound, &explanation)
        }
    }
}
