//! `setProjectAsModified`: marks a project in memory as changed. The event log warns when the project is unloaded.

use val3_soap::v2::SetProjectAsModified;
use val3_soap::{Empty, SoapFault};

use crate::context::Context;

/// Answers the request.
pub(super) fn answer(request: &SetProjectAsModified, context: &mut Context<'_, '_>) -> Result<Empty, SoapFault> {
    let instance = context.target.named_instance(request.project.as_deref().unwrap_or_default())?;
    context.mark_as_modified(instance);
    Ok(Empty)
}
