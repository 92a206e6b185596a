//! `login`: a rejected login has no fault, but the session 0.

use val3_soap::SoapFault;
use val3_soap::v0::{Login, LoginAnswer};

use crate::inferred::NO_SESSION;
use crate::service::Context;

/// Answers the request.
pub(super) fn answer(request: &Login, context: &mut Context<'_, '_>) -> Result<LoginAnswer, SoapFault> {
    let [user, password] = [&request.user, &request.password].map(|text| text.as_deref().unwrap_or_default());
    let now = context.now;
    let service = &mut *context.service;
    let session = service.accounts.rights(user, password).and_then(|rights| service.sessions.open(rights, now));
    Ok(LoginAnswer { session: session.unwrap_or(NO_SESSION) })
}
