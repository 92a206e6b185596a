//! `findServer`: all servers exist, although some requests are not offered.

use val3_soap::v0::{FindServer, FindServerAnswer};
use val3_soap::{SoapFault, SoapServer};

use crate::context::Context;

/// Answers the request.
pub(super) fn answer(request: &FindServer, _: &mut Context<'_, '_>) -> Result<FindServerAnswer, SoapFault> {
    let server = request.server_name.as_deref().and_then(SoapServer::at_path);
    Ok(FindServerAnswer { found: server.is_some() })
}
