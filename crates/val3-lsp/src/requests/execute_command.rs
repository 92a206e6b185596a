//! `workspace/executeCommand`: edits that the client applies on the server's request, and the tests of the workspace.

use serde_json::Value;
use tower_lsp::lsp_types::request::ApplyWorkspaceEdit;
use tower_lsp::lsp_types::{ApplyWorkspaceEditParams, Command, ExecuteCommandParams, WorkspaceEdit};

use super::test_list::{TESTS, tests};
use crate::snapshot::{Refusal, Snapshot};

/// All commands.
pub(super) const COMMANDS: [&str; 2] = [APPLY_EDIT, TESTS];

/// Command that applies the edit in its argument.
pub(super) const APPLY_EDIT: &str = "val3.applyEdit";

/// Command that applies an edit; `None` if the client does not support `workspace/applyEdit`.
pub(super) fn apply(snapshot: &Snapshot, title: String, edit: WorkspaceEdit) -> Option<Command> {
    let can_apply = snapshot.session.client.applies_edits;
    let argument = serde_json::to_value(edit).ok().filter(|_| can_apply)?;
    Some(Command { title, command: APPLY_EDIT.to_owned(), arguments: Some(vec![argument]) })
}

pub(crate) fn execute_command(snapshot: &Snapshot, params: &ExecuteCommandParams) -> Result<Option<Value>, Refusal> {
    if params.command == TESTS {
        return tests(snapshot, &params.arguments).map(Some);
    }
    let edit = match (params.command.as_str(), params.arguments.as_slice()) {
        (APPLY_EDIT, [edit]) => serde_json::from_value(edit.clone()).ok(),
        _ => None,
    };
    let edit: WorkspaceEdit = edit
        .ok_or_else(|| Refusal::Because(format!("the command `{}` does not accept these arguments", params.command)))?;
    // A client that rejects the edit shows the reason itself.
    snapshot.outbox.request::<ApplyWorkspaceEdit>(ApplyWorkspaceEditParams { label: None, edit });
    Ok(None)
}
