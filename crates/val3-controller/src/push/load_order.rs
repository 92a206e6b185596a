//! Order of applications: libraries and types before the applications that use them.

use std::collections::{BTreeMap, BTreeSet};

use crate::path::ControllerPath;

/// Name of the root of the applications, which paths without a root have too.
const DISK: &str = "disk";

/// Attributes with the path of another project: of libraries and user types, and of libraries in projects of s5.
const PATH_ATTRIBUTES: [&str; 2] = ["path", "interface"];

/// Project files by path, with their texts.
pub(super) type ProjectTexts = BTreeMap<ControllerPath, String>;

/// Returns the ranks of application folders. Libraries and types have lower ranks than their users, except in circles.
pub(super) fn ranks(projects: &ProjectTexts) -> BTreeMap<ControllerPath, usize> {
    let folders: BTreeSet<ControllerPath> = projects.keys().filter_map(ControllerPath::parent).collect();
    let by_key: BTreeMap<ControllerPath, &ControllerPath> =
        folders.iter().map(|folder| (folder.in_lower_case(), folder)).collect();
    let uses = projects.iter().filter_map(|(path, text)| {
        let folder = path.parent()?;
        let used = used_folders(text, &folder);
        let used = used.iter().filter_map(|used| by_key.get(used).copied()).filter(|used| **used != folder).collect();
        Some((folder, used))
    });
    let uses: BTreeMap<ControllerPath, BTreeSet<&ControllerPath>> = uses.collect();
    let mut ranks = BTreeMap::new();
    let mut open: Vec<&ControllerPath> = folders.iter().collect();
    while !open.is_empty() {
        let is_ready = |folder: &ControllerPath, ranks: &BTreeMap<ControllerPath, usize>| {
            uses.get(folder).is_none_or(|used| used.iter().all(|used| ranks.contains_key(*used)))
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
    changed: impl Iterator<Item = &'c ControllerPath>,
) -> BTreeSet<ControllerPath> {
    let changed: Vec<ControllerPath> = changed.map(ControllerPath::in_lower_case).collect();
    let mut affected = BTreeSet::new();
    let mut folders = BTreeSet::new();
    loop {
        let is_affected = |path: &ControllerPath, text: &str| {
            let has_changed = |folder: &ControllerPath| changed.iter().any(|change| change.is_in(folder));
            path.parent().is_some_and(|folder| {
                has_changed(&folder.in_lower_case())
                    || used_folders(text, &folder).iter().any(|used| folders.contains(used) || has_changed(used))
            })
        };
        let found: Vec<&ControllerPath> = projects
            .iter()
            .filter(|(path, text)| !affected.contains(*path) && is_affected(path, text))
            .map(|(path, _)| path)
            .collect();
        if found.is_empty() {
            return affected;
        }
        folders.extend(found.iter().filter_map(|path| path.parent()).map(|folder| folder.in_lower_case()));
        affected.extend(found.into_iter().cloned());
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
        let ranks = ranks(&projects.into_iter().collect());
        let rank = |name: &str| ranks[&ControllerPath::parse(&format!("usr/usrapp/{name}")).unwrap()];
        assert!(rank("types/Slot") < rank("lib") && rank("lib") < rank("a"));
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
        let ranks = ranks(&projects);
        assert!(ranks[&path("lib/parts")] < ranks[&path("lib")] && ranks[&path("lib")] < ranks[&path("a")]);
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
        assert_eq!(ranks(&projects.into_iter().collect()).len(), 2);
    }
}
