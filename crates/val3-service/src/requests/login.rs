//! `login`: a rejected login has no fault, but the session 0.

use val3_soap::SoapFault;
use val3_soap::v0::{Login, LoginAnswer};

use crate::context::Context;
use crate::inferred::NO_SESSION;

/// Answers the request.
pub(super) fn answer(request: &Login, context: &mut Context<'_, '_>) -> Result<LoginAnswer, SoapFault> {
    let [user, password] = [&request.user, &request.password].map(|text| text.as_deref().unwrap_or_default());
    let now = context.now;
    let state = &mut *context.state;
    let session = state.accounts.rights(user, password).and_then(|rights| state.sessions.open(rights, now));
    Ok(LoginAnswer { session: session.unwrap_or(NO_SESSION) })
}
