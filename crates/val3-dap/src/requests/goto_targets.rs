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

#[cfg(test)]
mod tests {
    use serde_json::json;

    use crate::test_client::{CALLER, COUNTER, FIRST_LINE, TestClient, source};

    #[test]
    fn a_line_without_an_instruction_has_the_next_line_as_its_target() {
        let mut client = TestClient::stopped(COUNTER);
        let head = json!({ "source": source("start"), "line": 1 });
        let expected = json!([{ "id": 1, "label": "line 5", "line": FIRST_LINE }]);
        assert_eq!(client.body("gotoTargets", head)["targets"], expected);
    }

    #[test]
    fn the_lines_after_the_last_instruction_are_the_end_of_the_program() {
        let mut client = TestClient::stopped(COUNTER);
        let end = json!({ "source": source("start"), "line": 99 });
        let expected = json!([{ "id": 1, "label": "the end of the program", "line": 99 }]);
        assert_eq!(client.body("gotoTargets", end)["targets"], expected);
    }

    #[test]
    fn each_target_has_an_id_of_its_own() {
        let mut client = TestClient::stopped(COUNTER);
        let line = json!({ "source": source("start"), "line": FIRST_LINE });
        let mut id = || client.body("gotoTargets", line.clone())["targets"][0]["id"].clone();
        assert_eq!([id(), id()], [1, 2]);
    }

    #[test]
    fn a_program_that_no_task_executes_has_no_target() {
        let mut client = TestClient::stopped(CALLER);
        let line = json!({ "source": source("work"), "line": FIRST_LINE });
        assert_eq!(client.body("gotoTargets", line), json!({ "targets": [] }));
    }

    #[test]
    fn a_file_that_is_not_loaded_is_rejected() {
        let mut client = TestClient::stopped(COUNTER);
        let reason = client.failure("gotoTargets", json!({ "source": source("other"), "line": 1 }));
        assert_eq!(reason, "the application has loaded no program of this file");
    }
}
