//! `ping`.

use val3_soap::SoapFault;
use val3_soap::v0::{Ping, PingAnswer};

use crate::context::Context;

/// Answers the request.
pub(super) fn answer(request: &Ping, _: &mut Context<'_, '_>) -> Result<PingAnswer, SoapFault> {
    Ok(PingAnswer { message: request.message.clone() })
}
