//! `stepOut`: executes the rest of a program.

use val3_debug::StepKind;

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::protocol::StepOutArguments;
use crate::request::DebugRequest;
use crate::session::DebugSession;

/// The request `stepOut`.
pub(crate) enum StepOut {}

impl DebugRequest for StepOut {
    const COMMAND: &'static str = "stepOut";
    type Arguments = StepOutArguments;
    type Body = ();

    fn answer(
        session: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        arguments: StepOutArguments,
    ) -> Result<(), RequestFailure> {
        session.step(arguments.thread_id, arguments.single_thread, StepKind::Out, run)
    }
}
