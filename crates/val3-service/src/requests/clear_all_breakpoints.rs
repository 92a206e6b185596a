//! `clearAllBreakpoints`.

use val3_soap::v2::ClearAllBreakpoints;
use val3_soap::{Empty, SoapFault};

use crate::context::Context;

/// Answers the request.
pub(super) fn answer(_: &ClearAllBreakpoints, context: &mut Context<'_, '_>) -> Result<Empty, SoapFault> {
    context.debug()?;
    context.state.debugging.clear_all(context.target.debugger);
    Ok(Empty)
}
