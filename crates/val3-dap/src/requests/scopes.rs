//! `scopes`: scopes of a stack frame.

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::protocol::{ScopesArguments, ScopesResponse};
use crate::request::DebugRequest;
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
        let filter = session.start.settings.variable_filter.as_ref();
        Ok(ScopesResponse { scopes: session.handles.scopes(frame, &mut run.debugger.controller, filter) })
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use crate::test_client::{EMPTY, TestClient};

    #[test]
    fn an_unknown_stack_frame_is_stale() {
        let mut client = TestClient::stopped(EMPTY);
        let (_, frame) = client.thread_and_frame();
        assert_eq!(client.body("scopes", json!({ "frameId": frame }))["scopes"][0]["name"], "Parameters");
        assert!(client.failure("scopes", json!({ "frameId": 99 })).contains("a stop that is over"));
    }
}
