//! `subscribeToControllerEvents`: accepts an event service on this machine. Its operations are unknown, so no event is
//! sent.

use val3_soap::v2::SubscribeToControllerEvents;
use val3_soap::{Empty, ExceptionCode, SoapFault};

use crate::context::{Context, refused};
use crate::inferred::is_local_service;

/// Answers the request.
pub(super) fn answer(request: &SubscribeToControllerEvents, _: &mut Context<'_, '_>) -> Result<Empty, SoapFault> {
    let url = request.service_url.as_deref().unwrap_or_default();
    if !is_local_service(url) {
        let explanation =
            "this controller accepts only event services on its own machine, such as http://127.0.0.1:5656/";
        return Err(refused(ExceptionCode::ClientCommunication, explanation));
    }
    if request.send_interval <= 0 {
        return Err(refused(ExceptionCode::InvalidParameters, "the interval has to be positive"));
    }
    Ok(Empty)
}
