//! The differences as a JSON document.

use std::collections::BTreeMap;

use serde_json::{Value, json};
use val3_controller::{ControllerPath, FileDifference, ProjectStatus};

use crate::controller::{ControllerSession, change_word};

/// Version of the document.
const VERSION: u32 = 1;

/// Converts the differences to a document. Applications without a difference are listed, too.
pub(super) fn document(session: &ControllerSession, status: &ProjectStatus) -> Value {
    let known = status.local.keys().chain(status.controller.keys()).chain(status.differences.keys());
    let mut applications: BTreeMap<&str, Vec<Value>> =
        known.filter_map(ControllerPath::application).map(|name| (name, Vec::new())).collect();
    let mut settings = Vec::new();
    for (path, difference) in &status.differences {
        let files = path.application().and_then(|name| applications.get_mut(name)).unwrap_or(&mut settings);
        files.push(file(path, *difference));
    }
    let applications = applications.into_iter().map(|(name, files)| json!({ "name": name, "files": files }));
    json!({
        "version": VERSION,
        "address": session.address,
        "project": session.project.folder(),
        "controller": { "serial": known_number(&session.identity.serial), "arm": known_number(&session.identity.arm) },
        "applications": applications.collect::<Vec<_>>(),
        "settings": settings,
    })
}

/// Serial number; `None` if it is unknown.
fn known_number(number: &str) -> Option<&str> {
    (!number.is_empty()).then_some(number)
}

fn file(path: &ControllerPath, difference: FileDifference) -> Value {
    let path = path.as_str();
    match difference {
        FileDifference::Local(change) => json!({ "path": path, "side": "local", "change": change_word(change) }),
        FileDifference::Controller(change) => {
            json!({ "path": path, "side": "controller", "change": change_word(change) })
        }
        FileDifference::Conflict { local, controller } => json!({
            "path": path,
            "side": "conflict",
            "change": change_word(local),
            "controller_change": change_word(controller),
        }),
        FileDifference::Alike(change) => json!({ "path": path, "side": "alike", "change": change_word(change) }),
    }
}
