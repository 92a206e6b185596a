//! The state of a controller as a JSON document.

use serde_json::{Value, json};
use val3_soap::v2::TaskStatus;

use super::{LiveArm, LiveState, state_word};

/// Version of the document.
const VERSION: u32 = 1;

/// Converts the state to a document. Joints and angles are in degrees, lengths in mm.
pub(in crate::status) fn document(state: &LiveState) -> Value {
    let arms = state
        .arms
        .iter()
        .map(|LiveArm { name, joints, flange }| json!({ "name": name, "joints": joints, "flange": flange }));
    let applications = state.applications.iter().map(|one| json!({ "name": one.name, "loaded": one.loaded }));
    json!({
        "version": VERSION,
        "address": state.place,
        "interface": state.interface,
        "arms": arms.collect::<Vec<_>>(),
        "applications": applications.collect::<Vec<_>>(),
        "tasks": state.tasks.iter().map(task).collect::<Vec<_>>(),
    })
}

fn task(task: &TaskStatus) -> Value {
    let error = (task.error != 0).then(|| json!({ "code": task.error, "text": task.error_description }));
    json!({
        "name": task.name,
        "state": state_word(task.state),
        "priority": task.priority,
        "application": task.created_by,
        "error": error,
        "program": task.line.program,
        "line": task.line.number,
        "code": task.line.content,
    })
}
