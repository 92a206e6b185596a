//! Users of projects that are libraries or user types.

use std::collections::{BTreeMap, BTreeSet};

use camino::Utf8PathBuf;
use val3_analysis::paths::path_key;

use crate::applications::{Application, target};

/// Names of the projects that use a project as a library or type, by the used project's path in lower case.
pub(super) type Users = BTreeMap<String, BTreeSet<String>>;

/// Returns the users in both trees.
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

/// Returns the users of `application`. In a tree without `usrapp`, the folder of `Disk://` is unknown, so the end of
/// the path is compared.
pub(super) fn of(users: &Users, application: &Application<'_>) -> Vec<String> {
    let path = Utf8PathBuf::from(path_key(application.path.as_str()));
    let found = users.iter().filter(|(target, _)| path.ends_with(target)).flat_map(|(_, names)| names);
    let names: BTreeSet<&String> = found.filter(|name| **name != application.name).collect();
    names.into_iter().cloned().collect()
}
