//! Order of applications: libraries and types before the applications that use them.

use std::collections::{BTreeMap, BTreeSet};

use crate::path::ControllerPath;

/// Start of a path in a project file that is relative to the applications.
const DISK: &str = "disk://";

/// Project files by path, with their texts.
pub(super) type ProjectTexts = BTreeMap<ControllerPath, String>;

/// Returns the ranks of application folders. Libraries and types have lower ranks than their users, except in circles.
pub(super) fn ranks(projects: &ProjectTexts) -> BTreeMap<ControllerPath, usize> {
    let folders: BTreeSet<ControllerPath> = projects.keys().filter_map(ControllerPath::parent).collect();
    let uses = projects.iter().filter_map(|(path, text)| {
        let folder = path.parent()?;
        let used = used_folders(text).into_iter().filter(|used| *used != folder && folders.contains(used)).collect();
        Some((folder, used))
    });
    let uses: BTreeMap<ControllerPath, BTreeSet<ControllerPath>> = uses.collect();
    let mut ranks = BTreeMap::new();
    let mut open: Vec<&ControllerPath> = folders.iter().collect();
    while !open.is_empty() {
        let is_ready = |folder: &ControllerPath, ranks: &BTreeMap<ControllerPath, usize>| {
            uses.get(folder).is_none_or(|used| used.iter().all(|used| ranks.contains_key(used)))
        };
        let next = open.iter().position(|folder| is_ready(folder, &ranks)).unwrap_or(0);
        let folder = open.remove(next);
        ranks.insert(folder.clone(), ranks.len());
    }
    ranks
}

/// Returns the project files that a change affects: project files in the same folders as changed files, and their direct
/// and indirect users. A changed file may belong to a library that is removed, and therefore not among the projects.
pub(super) fn affected<'c>(
    projects: &ProjectTexts,
    changed: impl Iterator<Item = &'c ControllerPath> + Clone,
) -> BTreeSet<ControllerPath> {
    let mut affected = BTreeSet::new();
    let mut folders = BTreeSet::new();
    loop {
        let is_affected = |path: &ControllerPath, text: &str| {
            let has_changed = |folder: &ControllerPath| changed.clone().any(|change| change.is_in(folder));
            path.parent().as_ref().is_some_and(has_changed)
                || used_folders(text).iter().any(|used| folders.contains(used) || has_changed(used))
        };
        let found: Vec<&ControllerPath> = projects
            .iter()
            .filter(|(path, text)| !affected.contains(*path) && is_affected(path, text))
            .map(|(path, _)| path)
            .collect();
        if found.is_empty() {
            return affected;
        }
        folders.extend(found.iter().filter_map(|path| path.parent()));
        affected.extend(found.into_iter().cloned());
    }
}

/// Folders of the project files that a project names by `Disk://`. Paths relative to the project stay in its folder.
fn used_folders(text: &str) -> BTreeSet<ControllerPath> {
    let lower = text.to_ascii_lowercase();
    let paths = lower.match_indices(DISK).filter_map(|(at, _)| {
        let rest = text.get(at + DISK.len()..)?;
        let path = rest.split(['"', '\'', '<', '\n']).next()?;
        let folder = path.trim_matches('/').rsplit_once('/')?.0;
        ControllerPath::parse(&format!("{}/{folder}", ControllerPath::applications())).ok()
    });
    paths.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn libraries_and_types_come_first() {
        let project = |name: &str, uses: &[&str]| {
            let text = uses.iter().map(|used| format!("<Library path=\"Disk://{used}/x.pjx\"/>")).collect();
            (ControllerPath::parse(&format!("usr/usrapp/{name}/x.pjx")).unwrap(), text)
        };
        let projects =
            [project("a", &["lib", "types/Slot"]), project("lib", &["types/Slot"]), project("types/Slot", &[])];
        let ranks = ranks(&projects.into_iter().collect());
        let rank = |name: &str| ranks[&ControllerPath::parse(&format!("usr/usrapp/{name}")).unwrap()];
        assert!(rank("types/Slot") < rank("lib") && rank("lib") < rank("a"));
    }

    #[test]
    fn a_change_concerns_all_users() {
        let path = |text: &str| ControllerPath::parse(&format!("usr/usrapp/{text}")).unwrap();
        let project = |name: &str, used: &str| (path(&format!("{name}/x.pjx")), format!("\"Disk://{used}/x.pjx\""));
        let projects = [project("a", "lib"), project("lib", "Slot"), project("Slot", "gone"), project("z", "a")];
        let affected = |changed: &str| {
            let found = affected(&projects.clone().into_iter().collect(), [path(changed)].iter());
            found.iter().filter_map(|path| path.application().map(str::to_owned)).collect::<Vec<_>>().join(" ")
        };
        assert_eq!(affected("Slot/x.dtx"), "Slot a lib z");
        assert_eq!(affected("a/sub/x.txt"), "a z");
        assert_eq!(affected("gone/x.pjx"), "Slot a lib z");
        assert_eq!(affected("other/x.dtx"), "");
    }

    #[test]
    fn a_circle_has_an_order() {
        let text = |used: &str| format!("<Library path='disk://{used}/x.pjx'/>");
        let projects = [("a", "b"), ("b", "a")]
            .map(|(name, used)| (ControllerPath::parse(&format!("usr/usrapp/{name}/x.pjx")).unwrap(), text(used)));
        assert_eq!(ranks(&projects.into_iter().collect()).len(), 2);
    }
}
