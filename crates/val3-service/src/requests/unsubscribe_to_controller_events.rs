//! `unsubscribeToControllerEvents`: has no effect, because no event is sent.

use val3_soap::v2::UnsubscribeToControllerEvents;
use val3_soap::{Empty, SoapFault};

use crate::context::Context;

/// Answers the request.
pub(super) fn answer(_: &UnsubscribeToControllerEvents, _: &mut Context<'_, '_>) -> Result<Empty, SoapFault> {
    Ok(Empty)
}
