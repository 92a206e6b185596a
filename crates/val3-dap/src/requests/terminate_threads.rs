//! `terminateThreads`: kills tasks; none of them if one does not exist.

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::protocol::TerminateThreadsArguments;
use crate::request::DebugRequest;
use crate::session::DebugSession;

/// The request `terminateThreads`.
pub(crate) enum TerminateThreads {}

impl DebugRequest for TerminateThreads {
    const COMMAND: &'static str = "terminateThreads";
    type Arguments = TerminateThreadsArguments;
    type Body = ();

    fn answer(
        _: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        arguments: TerminateThreadsArguments,
    ) -> Result<(), RequestFailure> {
        let threads = arguments.thread_ids.unwrap_or_default();
        let tasks = threads.into_iter().map(|thread| DebugSession::task(thread, run));
        let tasks = tasks.collect::<Result<Vec<_>, RequestFailure>>()?;
        tasks.into_iter().for_each(|task| run.debugger.controller.kill(task));
        Ok(())
    }
}
