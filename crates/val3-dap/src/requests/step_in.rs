//! `stepIn`: executes a line up to its first call.

use val3_debug::StepKind;

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::protocol::StepInArguments;
use crate::request::DebugRequest;
use crate::session::DebugSession;

/// The request `stepIn`.
pub(crate) enum StepIn {}

impl DebugRequest for StepIn {
    const COMMAND: &'static str = "stepIn";
    type Arguments = StepInArguments;
    type Body = ();

    fn answer(
        session: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        arguments: StepInArguments,
    ) -> Result<(), RequestFailure> {
        let task = DebugSession::task(arguments.thread_id, run)?;
        let chosen = arguments.target_id.and_then(|_| run.debugger.step_in_target(task));
        let kind = chosen.map_or(StepKind::In, |chosen| chosen.kind);
        session.step(arguments.thread_id, arguments.single_thread, kind, run)
    }
}
