//! `threads`: tasks of the controller.

use serde::de::IgnoredAny;

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::inspection;
use crate::protocol::ThreadsResponse;
use crate::request::DebugRequest;
use crate::session::DebugSession;

/// The request `threads`.
pub(crate) enum Threads {}

impl DebugRequest for Threads {
    const COMMAND: &'static str = "threads";
    type Arguments = IgnoredAny;
    type Body = ThreadsResponse;

    fn answer(
        _: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        _: IgnoredAny,
    ) -> Result<ThreadsResponse, RequestFailure> {
        Ok(ThreadsResponse { threads: inspection::threads(&run.debugger.controller) })
    }
}
