//! The changes of a push as a JSON document.

use serde_json::{Value, json};
use val3_controller::{PlannedChange, PushPlan};

/// Version of the document.
const VERSION: u32 = 1;

/// Converts the changes to a document, in their order.
pub(super) fn document(plan: &PushPlan) -> Value {
    json!({ "version": VERSION, "changes": plan.changes.iter().map(change).collect::<Vec<_>>() })
}

fn change(change: &PlannedChange) -> Value {
    let action = match (&change.old, &change.new) {
        (None, Some(_)) => "create",
        (Some(_), Some(_)) => "replace",
        (_, None) => "remove",
    };
    json!({
        "path": change.path.as_str(),
        "action": action,
        "size": change.new.as_ref().map(|digest| digest.size),
    })
}
