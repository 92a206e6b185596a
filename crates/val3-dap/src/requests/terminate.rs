//! `terminate`: runs the program `stop`, as when an operator stops the application.

use val3_machine::controller::OperatorAction;

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::protocol::TerminateArguments;
use crate::request::DebugRequest;
use crate::session::DebugSession;

/// The request `terminate`.
pub(crate) enum Terminate {}

impl DebugRequest for Terminate {
    const COMMAND: &'static str = "terminate";
    type Arguments = TerminateArguments;
    type Body = ();

    fn answer(
        session: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        _: TerminateArguments,
    ) -> Result<(), RequestFailure> {
        run.debugger.controller.operate(OperatorAction::Stop);
        run.debugger.resume_tasks();
        session.run_on();
        Ok(())
    }
}
