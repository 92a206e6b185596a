//! `scopes`: scopes of a stack frame.

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::protocol::{ScopesArguments, ScopesResponse};
use crate::requests::DebugRequest;
use crate::session::DebugSession;

/// The request `scopes`.
pub(crate) enum Scopes {}

impl DebugRequest for Scopes {
    const COMMAND: &'static str = "scopes";
    type Arguments = ScopesArguments;
    type Body = ScopesResponse;

    fn answer(
        session: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        arguments: ScopesArguments,
    ) -> Result<ScopesResponse, RequestFailure> {
        let frame = session.handles.frame(arguments.frame_id).ok_or(RequestFailure::Stale)?;
        Ok(ScopesResponse { scopes: session.handles.scopes(frame, &mut run.debugger.controller) })
    }
}
