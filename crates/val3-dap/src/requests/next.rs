//! `next`: executes a line, with its calls.

use val3_debug::StepKind;

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::protocol::NextArguments;
use crate::request::DebugRequest;
use crate::session::DebugSession;

/// The request `next`.
pub(crate) enum Next {}

impl DebugRequest for Next {
    const COMMAND: &'static str = "next";
    type Arguments = NextArguments;
    type Body = ();

    fn answer(
        session: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        arguments: NextArguments,
    ) -> Result<(), RequestFailure> {
        session.step(arguments.thread_id, arguments.single_thread, StepKind::Over, run)
    }
}
