//! `logout`: also removes the breakpoints of the session. Held tasks stay held.

use val3_soap::v0::Logout;
use val3_soap::{Empty, SoapFault};

use crate::context::Context;

/// Answers the request.
pub(super) fn answer(_: &Logout, context: &mut Context<'_, '_>) -> Result<Empty, SoapFault> {
    if let Some((session, _)) = context.session {
        context.state.sessions.close(session);
        if context.state.debugging.owner.take_if(|owner| *owner == session).is_some() {
            context.state.debugging.clear_all(context.target.debugger);
        }
    }
    Ok(Empty)
}
