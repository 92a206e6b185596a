//! `gotoTargets`: line at which a task can continue.

use crate::breakpoints::file_of;
use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::protocol::GotoTarget;
use crate::protocol::{GotoTargetsArguments, GotoTargetsResponse};
use crate::request::DebugRequest;
use crate::session::DebugSession;

/// The request `gotoTargets`.
pub(crate) enum GotoTargets {}

impl DebugRequest for GotoTargets {
    const COMMAND: &'static str = "gotoTargets";
    type Arguments = GotoTargetsArguments;
    type Body = GotoTargetsResponse;

    fn answer(
        session: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        arguments: GotoTargetsArguments,
    ) -> Result<GotoTargetsResponse, RequestFailure> {
        let controller = &run.debugger.controller;
        let file = file_of(&arguments.source, controller).ok_or(RequestFailure::NotLoaded)?;
        let row = session.conventions.row(arguments.line);
        let tasks = controller.vm.tasks().iter().map(|task| task.id);
        let line = tasks.filter_map(|task| run.debugger.goto_target(task, &file, row).ok()).next();
        let target = line.map(|line| {
            let id = i32::try_from(session.goto_targets.len() + 1).unwrap_or(i32::MAX);
            session.goto_targets.insert(id, (file.clone(), row));
            let label = if line.is_end { "the end of the program".to_owned() } else { format!("line {}", line.row) };
            GotoTarget { id, label, line: session.conventions.line(line.row), ..GotoTarget::default() }
        });
        Ok(GotoTargetsResponse { targets: target.into_iter().collect() })
    }
}
