//! Order of applications: libraries and types before the applications that use them.

use std::collections::{BTreeMap, BTreeSet};

use crate::error::ControllerError;
use crate::path::ControllerPath;

/// Name of the root of the applications, which paths without a root have too.
const DISK: &str = "disk";

/// Attributes with the path of another project: of libraries and user types, and of libraries in projects of s5.
const PATH_ATTRIBUTES: [&str; 2] = ["path", "interface"];

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
    let by_key: BTreeMap<ControllerPath, &ControllerPath> =
        folders.iter().map(|folder| (folder.in_lower_case(), folder)).collect();
    let uses = projects.iter().filter_map(|(path, text)| {
        let folder = path.parent()?;
        let used = used_folders(text, &folder);
        let used: BTreeSet<ControllerPath> = used
            .iter()
            .filter_map(|used| by_key.get(used))
            .map(|used| (*used).clone())
            .filter(|used| *used != folder)
            .collect();
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
    let changed = changed.map(ControllerPath::in_lower_case).collect();
    let mut affected = BTreeSet::new();
    let mut folders = AffectedFolders { changed, users: BTreeSet::new() };
    loop {
        let found: Vec<&ControllerPath> = projects
            .iter()
            .filter(|(path, text)| !affected.contains(*path) && folders.affect(path, text))
            .map(|(path, _)| path)
            .collect();
        if found.is_empty() {
            return affected;
        }
        let users = found.iter().filter_map(|path| path.parent());
        folders.users.extend(users.map(|folder| folder.in_lower_case()));
        affected.extend(found.into_iter().cloned());
    }
}

/// Folders that a change affects, in lower case.
struct AffectedFolders {
    /// Changed files, in lower case.
    changed: Vec<ControllerPath>,
    /// Folders of the affected projects that were found so far.
    users: BTreeSet<ControllerPath>,
}

impl AffectedFolders {
    /// Whether the project is in a folder with changes, or uses a folder that is affected.
    fn affect(&self, project: &ControllerPath, text: &str) -> bool {
        project.parent().is_some_and(|folder| {
            self.has_changes(&folder.in_lower_case())
                || used_folders(text, &folder).iter().any(|used| self.users.contains(used) || self.has_changes(used))
        })
    }

    /// Whether a file in the folder has changed.
    fn has_changes(&self, folder: &ControllerPath) -> bool {
        self.changed.iter().any(|change| change.is_in(folder))
    }
}

/// Folders of the projects that a project in `folder` uses, in lower case, because paths in projects have any letter
/// case.
fn used_folders(text: &str, folder: &ControllerPath) -> BTreeSet<ControllerPath> {
    references(text).filter_map(|reference| used_folder(reference, folder)).collect()
}

/// Values of the path attributes. A project file that is no XML has some as well, and its users are affected.
fn references(text: &str) -> impl Iterator<Item = &str> {
    let attributes = PATH_ATTRIBUTES.iter().flat_map(move |name| text.match_indices(name));
    attributes.filter_map(move |(at, name)| {
        let (before, rest) = text.split_at_checked(at)?;
        let is_name = before.ends_with(|before: char| before.is_ascii_whitespace());
        let value = rest.strip_prefix(name)?.trim_start().strip_prefix('=')?.trim_start();
        let quote = value.chars().next().filter(|quote| is_name && matches!(quote, '"' | '\''))?;
        value.strip_prefix(quote)?.split(quote).next()
    })
}

/// Folder of the project with this path: `Disk://a/a.pjx`, `Disk://a`, `a`, `./a` or `../a/a.pjx`. `None` for other
/// roots, and for paths outside of the controller's folders.
fn used_folder(reference: &str, folder: &ControllerPath) -> Option<ControllerPath> {
    let reference = reference.trim().replace('\\', "/").to_lowercase();
    let (start, path) = match reference.split_once("://") {
        Some((root, path)) if root == DISK => (ControllerPath::applications(), path),
        Some(_) => return None,
        None if reference.starts_with("./") || reference.starts_with("../") => (folder.in_lower_case(), &*reference),
        None => (ControllerPath::applications(), &*reference),
    };
    let mut used = start;
    for name in path.split('/') {
        used = match name {
            "" | "." => used,
            ".." => used.parent()?,
            _ => used.child(name).ok()?,
        };
    }
    let used = if used.is_project() { used.parent()? } else { used };
    // A project directly in the folder of the applications is in no folder of its own.
    (used != ControllerPath::applications()).then_some(used)
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
    fn all_spellings_of_a_path_are_followed() {
        let folder = ControllerPath::parse("usr/usrapp/cell/main").unwrap();
        let used = |attribute: &str| {
            let used = used_folders(&format!("<Library alias=\"lib\" {attribute}/>"), &folder);
            used.iter().map(ControllerPath::as_str).collect::<Vec<_>>().join(" ")
        };
        for path in [
            "Disk://lib/lib.pjx",
            "disk://Lib",
            "/lib/lib.pjx",
            "lib",
            "../../lib/lib.pjx",
            "Disk:///x/../lib\\lib.PJX",
        ] {
            assert_eq!(used(&format!("path=\"{path}\"")), "usr/usrapp/lib", "{path}");
        }
        assert_eq!(used("path = './part/part.pjx'"), "usr/usrapp/cell/main/part");
        assert_eq!(used("path=\"../part\""), "usr/usrapp/cell/part");
        assert_eq!(used("interface=\"lib\""), "usr/usrapp/lib");
        for path in ["USB0://lib/lib.pjx", "../../../../../lib", "", "Disk://", "lib.pjx"] {
            assert_eq!(used(&format!("path=\"{path}\"")), "", "{path}");
        }
        assert_eq!(used("xpath=\"lib\" name=\"lib\""), "");
    }

    #[test]
    fn libraries_with_relative_paths_come_first() {
        let path = |name: &str| ControllerPath::parse(&format!("usr/usrapp/{name}")).unwrap();
        let projects = [("a/a.pjx", "../Lib"), ("lib/lib.pjx", "./parts/parts.pjx"), ("lib/parts/parts.pjx", "")];
        let projects: ProjectTexts =
            projects.map(|(name, used)| (path(name), format!("<Library path=\"{used}\"/>"))).into_iter().collect();
        let order = LoadOrder::new(&projects);
        let rank = |name: &str| order.rank(&path(name));
        assert!(rank("lib/parts/parts.pjx") < rank("lib/lib.pjx") && rank("lib/lib.pjx") < rank("a/a.pjx"));
        let affected = affected(&projects, [path("lib/parts/x.dtx")].iter());
        assert_eq!(affected, projects.into_keys().collect());
    }

    #[test]
    fn a_change_concerns_all_users() {
        let path = |text: &str| ControllerPath::parse(&format!("usr/usrapp/{text}")).unwrap();
        let project = |name: &str, used: &str| {
            (path(&format!("{name}/x.pjx")), format!("<Library path=\"Disk://{used}/x.pjx\"/>"))
        };
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
