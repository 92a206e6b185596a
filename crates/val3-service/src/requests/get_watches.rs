//! `getWatches`: values of global data. The form is inferred.

use val3_machine::devices::DataSelection;
use val3_soap::v2::{GetWatches, GetWatchesAnswer, MimeData, WatchedData};
use val3_soap::{ExceptionCode, SoapFault};

use crate::context::{Context, refused};

/// Answers the request.
pub(super) fn answer(request: &GetWatches, context: &mut Context<'_, '_>) -> Result<GetWatchesAnswer, SoapFault> {
    let selections = request.watches.iter().map(|watched| selection(watched, context));
    let selections = selections.collect::<Result<Vec<_>, _>>()?;
    let controller = context.controller();
    let document = controller.devices.data_document(&controller.vm.space, &selections);
    let text = document.map_err(|fault| refused(ExceptionCode::InvalidParameters, &fault.to_string()))?;
    Ok(GetWatchesAnswer { data: MimeData::xml(text) })
}

fn selection(watched: &WatchedData, context: &Context<'_, '_>) -> Result<DataSelection, SoapFault> {
    let instance = context.target.instance(watched.project.as_deref().unwrap_or_default())?;
    let name = watched.name.clone().unwrap_or_default();
    Ok(DataSelection { instance, name, index: watched.index.clone().filter(|index| !index.is_empty()) })
}
