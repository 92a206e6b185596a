//! Which projects use which as a library or user type.

use std::collections::{BTreeMap, BTreeSet};

use camino::Utf8Path;
use val3_analysis::paths::{Roots, Target, path_key, project};

use crate::applications::Application;

/// The users of projects: for the path of a project, in lower case, the names of those that load it or use it as a type.
pub(super) type Users = BTreeMap<String, BTreeSet<String>>;

/// The users in both trees.
pub(super) fn users(old: &[Application<'_>], new: &[Application<'_>]) -> Users {
    let mut users = Users::new();
    for application in old.iter().chain(new) {
        let Some(read) = &application.project else { continue };
        for reference in read.manifest.projects() {
            if let Some(target) = target(application.folder(), reference) {
                users.entry(target).or_default().insert(application.name.clone());
            }
        }
    }
    users
}

/// `Disk://` is the folder of applications, which is the root of the tree.
fn target(folder: &Utf8Path, reference: &str) -> Option<String> {
    let roots = Roots { disk: Some("/".into()), others: Vec::new() };
    match project(&Utf8Path::new("/").join(folder), &roots, reference) {
        Target::Path(path) => Some(path_key(path.as_str().trim_start_matches('/'))),
        Target::Elsewhere => None,
    }
}

/// The users of an application.
pub(super) fn of(users: &Users, application: &Application<'_>) -> Vec<String> {
    let found = users.get(&path_key(application.path.as_str()));
    found.into_iter().flatten().filter(|name| **name != application.name).cloned().collect()
}
