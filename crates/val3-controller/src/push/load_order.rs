//! Order of applications: libraries and types before the applications that use them.

use std::collections::{BTreeMap, BTreeSet};

use crate::error::ControllerError;
use crate::path::ControllerPath;

/// Start of a path in a project file that is relative to the applications.
const DISK: &str = "disk://";

/// Project files by path, with their texts.
pub(super) type ProjectTexts = BTreeMap<ControllerPath, String>;

/// Reads the texts of the project files among `paths`.
pub(super) fn project_texts<'p>(
    paths: impl Iterator<Item = &'p ControllerPath>,
    read: impl Fn(&ControllerPath) -> Result<Vec<u8>, ControllerError>,
) -> Result<ProjectTexts, ControllerError> {
    let mut texts = ProjectTexts::new();
    for path in paths.filter(|path| path.is_project()) {
        texts.insert(path.clone(), String::from_utf8_lossy(&read(path)?).into_owned());
    }
    Ok(texts)
}

/// Rank of a file in no application folder, after all applications.
const LAST: usize = usize::MAX;

/// Order of application folders: libraries and types precede their users, except in circles.
pub(super) struct LoadOrder {
    ranks: BTreeMap<ControllerPath, usize>,
}

impl LoadOrder {
    /// Orders the folders of the project files.
    pub(super) fn new(projects: &ProjectTexts) -> Self {
        let uses = used_projects(projects);
        let mut ranks = BTreeMap::new();
        let mut open: Vec<(&ControllerPath, &BTreeSet<ControllerPath>)> = uses.iter().collect();
        while !open.is_empty() {
            let next = open.iter().position(|(_, used)| used.iter().all(|used| ranks.contains_key(used)));
            let (folder, _) = open.remove(next.unwrap_or(0));
            ranks.insert(folder.clone(), ranks.len());
        }
        Self { ranks }
    }

    /// Returns the rank of the innermost application folder that contains the file.
    pub(super) fn rank(&self, file: &ControllerPath) -> usize {
        let mut folders = std::iter::successors(file.parent(), ControllerPath::parent);
        folders.find_map(|folder| self.ranks.get(&folder).copied()).unwrap_or(LAST)
    }
}

/// Returns the other application folders that each application folder uses.
fn used_projects(projects: &ProjectTexts) -> BTreeMap<ControllerPath, BTreeSet<ControllerPath>> {
    let folders: BTreeSet<ControllerPath> = projects.keys().filter_map(ControllerPath::parent).collect();
    let uses = projects.iter().filter_map(|(path, text)| {
        let folder = path.parent()?;
        let used = used_folders(text).into_iter().filter(|used| *used != folder && folders.contains(used)).collect();
        Some((folder, used))
    });
    uses.collect()
}

/// Returns the project files that a change affects: project files in the same folders as changed files, and their direct
/// and indirect users. A changed file may belong to a library that is removed, and therefore not among the projects.
pub(super) fn affected<'c>(
    projects: &ProjectTexts,
    changed: impl Iterator<Item = &'c ControllerPath>,
) -> BTreeSet<ControllerPath> {
    let mut affected = BTreeSet::new();
    let mut folders = AffectedFolders { changed: changed.collect(), users: BTreeSet::new() };
    loop {
        let found: Vec<&ControllerPath> = projects
            .iter()
            .filter(|(path, text)| !affected.contains(*path) && folders.affect(path, text))
            .map(|(path, _)| path)
            .collect();
        if found.is_empty() {
            return affected;
        }
        folders.users.extend(found.iter().filter_map(|path| path.parent()));
        affected.extend(found.into_iter().cloned());
    }
}

/// Folders that a change affects.
struct AffectedFolders<'c> {
    /// Changed files.
    changed: Vec<&'c ControllerPath>,
    /// Folders of the affected projects that were found so far.
    users: BTreeSet<ControllerPath>,
}

impl AffectedFolders<'_> {
    /// Whether the project is in a folder with changes, or uses a folder that is affected.
    fn affect(&self, project: &ControllerPath, text: &str) -> bool {
        project.parent().is_some_and(|folder| self.has_changes(&folder))
            || used_folders(text).iter().any(|used| self.users.contains(used) || self.has_changes(used))
    }

    /// Whether a file in the folder has changed.
    fn has_changes(&self, folder: &ControllerPath) -> bool {
        self.changed.iter().any(|change| change.is_in(folder))
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
        let order = LoadOrder::new(&projects.into_iter().collect());
        let rank = |file: &str| order.rank(&ControllerPath::parse(&format!("usr/usrapp/{file}")).unwrap());
        assert!(rank("types/Slot/x.pjx") < rank("lib/x.pjx") && rank("lib/x.pjx") < rank("a/x.pjx"));
    }

    #[test]
    fn a_file_has_the_rank_of_its_application() {
        let path = |text: &str| ControllerPath::parse(text).unwrap();
        let projects = ProjectTexts::from([(path("usr/usrapp/a/x.pjx"), String::new())]);
        let order = LoadOrder::new(&projects);
        assert_eq!(order.rank(&path("usr/usrapp/a/sub/x.txt")), order.rank(&path("usr/usrapp/a/x.pjx")));
        assert_eq!(order.rank(&path("usr/configs/arm.cfx")), LAST);
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
        assert_eq!(LoadOrder::new(&projects.into_iter().collect()).ranks.len(), 2);
    }
}
