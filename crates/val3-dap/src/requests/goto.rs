//! `goto`: continues a task at another line.

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::protocol::GotoArguments;
use crate::protocol::{StoppedEvent, StoppedEventReason};
use crate::request::DebugRequest;
use crate::session::DebugSession;
use crate::stop_event;

/// The request `goto`.
pub(crate) enum Goto {}

impl DebugRequest for Goto {
    const COMMAND: &'static str = "goto";
    type Arguments = GotoArguments;
    type Body = ();

    fn answer(
        session: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        arguments: GotoArguments,
    ) -> Result<(), RequestFailure> {
        let task = DebugSession::task(arguments.thread_id, run)?;
        let known = session.goto_targets.get(&arguments.target_id).cloned();
        let (file, row) = known.ok_or(RequestFailure::Stale)?;
        let is_one = session.check_task_stopped(task, run)?;
        let line = run.debugger.goto_target(task, &file, row).map_err(RequestFailure::rejected)?;
        session.report_new_future(run);
        run.debugger.goto(task, line).map_err(RequestFailure::rejected)?;
        let event = stop_event::event(StoppedEventReason::Goto, Some(task));
        session.stopped_elsewhere(StoppedEvent { all_threads_stopped: Some(!is_one), ..event });
        Ok(())
    }
}
