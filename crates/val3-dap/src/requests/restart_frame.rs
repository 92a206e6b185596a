//! `restartFrame`: restarts the program of a stack frame.

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::protocol::RestartFrameArguments;
use crate::request::DebugRequest;
use crate::session::DebugSession;
use crate::stop_event;

/// The request `restartFrame`.
pub(crate) enum RestartFrame {}

impl DebugRequest for RestartFrame {
    const COMMAND: &'static str = "restartFrame";
    type Arguments = RestartFrameArguments;
    type Body = ();

    fn answer(
        session: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        arguments: RestartFrameArguments,
    ) -> Result<(), RequestFailure> {
        let frame = session.handles.frame(arguments.frame_id).ok_or(RequestFailure::Stale)?;
        let stop = run.debugger.restart_frame(frame.task, frame.depth).map_err(RequestFailure::rejected)?;
        session.stopped_elsewhere(stop_event::stopped(&stop, &mut run.debugger.controller));
        Ok(())
    }
}
