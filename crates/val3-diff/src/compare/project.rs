//! Comparison of project files.

use std::collections::BTreeSet;

use smol_str::SmolStr;

use crate::model::{Change, ProjectChange, ReferenceChange};
use crate::read::project::ProjectVersion;

/// Returns the parameters that differ, and the list of data files if it differs, because the first of several
/// declarations is used.
pub(super) fn parameters(old: &ProjectVersion, new: &ProjectVersion) -> Vec<ProjectChange> {
    let names: BTreeSet<&str> = old.parameters.iter().chain(&new.parameters).map(|(name, _)| name.as_str()).collect();
    let value = |project: &ProjectVersion, name: &str| project.parameter(name).map(str::to_owned);
    let change = |name: &str| ProjectChange { name: name.to_owned(), old: value(old, name), new: value(new, name) };
    let files = |project: &ProjectVersion| Some(project.data_files()).filter(|files| !files.is_empty());
    let files = ProjectChange { name: "data files".to_owned(), old: files(old), new: files(new) };
    names.into_iter().map(change).chain([files]).filter(|change| change.old != change.new).collect()
}

/// Returns library identifiers or user types that differ.
pub(super) fn references(old: &[(SmolStr, String)], new: &[(SmolStr, String)]) -> Vec<ReferenceChange> {
    let names: BTreeSet<&SmolStr> = old.iter().chain(new).map(|(name, _)| name).collect();
    let mut changes = Vec::new();
    for name in names {
        let [old, new] = [old, new].map(|list| path_of(name, list));
        if old != new {
            let change = Change::of(old.is_some(), new.is_some());
            changes.push(ReferenceChange { name: name.to_string(), change, old, new });
        }
    }
    changes
}

fn path_of(name: &SmolStr, list: &[(SmolStr, String)]) -> Option<String> {
    list.iter().find(|(other, _)| other == name).map(|(_, path)| path.clone())
}
