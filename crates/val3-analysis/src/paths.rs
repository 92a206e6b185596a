//! Paths in projects and programs: `Disk://a/a.pjx`, `./b`, `../c/c.pjx`, `io`, `USB0://d`.

use camino::{Utf8Component, Utf8Path, Utf8PathBuf};
use smol_str::SmolStr;
use val3_lang::suggest::nearest;

/// Root of paths without an explicit root: the controller's flash memory.
const DISK: &str = "Disk";

/// Roots that every controller has (6.7).
const MEDIA: [&str; 4] = [DISK, "Floppy", "USB0", "USB1"];

/// Returns the nearest folder `usrapp` above a project, which is the folder of `Disk://` on a controller.
pub(crate) fn usrapp(manifest: &Utf8Path) -> Option<&Utf8Path> {
    let mut folders = manifest.ancestors().skip(1);
    folders.find(|folder| folder.file_name().is_some_and(|name| name.eq_ignore_ascii_case("usrapp")))
}

/// Returns the ends of two different paths, starting with the last common folder.
pub fn distinct_ends<'p>(one: &'p Utf8Path, other: &'p Utf8Path) -> [&'p Utf8Path; 2] {
    let common = one.ancestors().find(|folder| other.starts_with(folder) && *folder != one);
    let around = common.and_then(Utf8Path::parent).unwrap_or(Utf8Path::new(""));
    [one, other].map(|path| path.strip_prefix(around).unwrap_or(path))
}

/// Returns the lookup key of a path, which is independent of letter case.
pub fn path_key(path: &str) -> String {
    path.to_lowercase()
}

/// Folders of the path roots.
#[derive(Debug, Clone, PartialEq, Eq, Hash, Default)]
pub struct Roots {
    /// Folder of `Disk://`; `None` if unknown.
    pub disk: Option<Utf8PathBuf>,
    /// Other roots by name, for example `USB0`.
    pub others: Vec<(String, Utf8PathBuf)>,
}

impl Roots {
    /// Returns the folder of a root.
    fn folder(&self, root: &str) -> Option<&Utf8Path> {
        if root.eq_ignore_ascii_case(DISK) {
            return self.disk.as_deref();
        }
        let named = self.others.iter().find(|(name, _)| root.eq_ignore_ascii_case(name));
        named.map(|(_, folder)| folder.as_path())
    }
}

/// Target of a reference.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub enum ResolvedPath {
    /// A path on the local disk.
    Path(Utf8PathBuf),
    /// A root without a known folder (`USB0://`, an FTP connection), which cannot be checked.
    Elsewhere,
}

/// Resolves a reference to a program or data file of the project in `folder`, which is normalised.
pub fn file_in(folder: &Utf8Path, reference: &str) -> Utf8PathBuf {
    let reference = reference.trim();
    if is_plain_name(reference) {
        return folder.join(reference);
    }
    normalise(&folder.join(reference.replace('\\', "/")))
}

/// Whether the reference is a bare file name, as almost always.
fn is_plain_name(reference: &str) -> bool {
    !reference.contains(['/', '\\']) && !matches!(reference, "" | "." | "..")
}

/// Resolves a reference to another project in `<Library path>`, `<Type path>` or `libLoad` (6.6). The default root is
/// `Disk`; the path is the project's folder or its `.pjx`.
pub fn project(folder: &Utf8Path, roots: &Roots, reference: &str) -> ResolvedPath {
    let reference = reference.trim().replace('\\', "/");
    let path = match reference.split_once("://") {
        Some((root, rest)) => roots.folder(root).map(|root| root.join(rest.trim_start_matches('/'))),
        None if reference.starts_with("./") || reference.starts_with("../") => Some(folder.join(&reference)),
        None => roots.disk.as_ref().map(|disk| disk.join(reference.trim_start_matches('/'))),
    };
    path.map_or(ResolvedPath::Elsewhere, |path| ResolvedPath::Path(with_manifest(normalise(&path))))
}

/// Returns the root name of a reference.
pub fn root(reference: &str) -> &str {
    let named = reference.trim().split_once("://").map(|(root, _)| root).filter(|root| !root.is_empty());
    named.unwrap_or(DISK)
}

/// Returns the known root most similar to an unknown one; `None` for a medium of the controller.
pub fn near_root(root: &str, roots: &Roots) -> Option<SmolStr> {
    let is_medium = MEDIA.iter().any(|medium| root.eq_ignore_ascii_case(medium));
    let named = roots.others.iter().map(|(name, _)| name.as_str());
    if is_medium { None } else { nearest(root, MEDIA.into_iter().chain(named)).map(SmolStr::from) }
}

/// Resolves a prefix of a reference, as in `"Disk://parts/part" + sName`: the folder that contains the projects, and
/// the prefix of the project folders in lower case.
pub fn projects_from(folder: &Utf8Path, roots: &Roots, prefix: &str) -> Option<(Utf8PathBuf, String)> {
    let (start, partial) = prefix.rsplit_once('/').unwrap_or(("", prefix));
    match project(folder, roots, &format!("{start}/x.pjx")) {
        ResolvedPath::Path(probe) => Some((probe.parent()?.to_owned(), partial.to_lowercase())),
        ResolvedPath::Elsewhere => None,
    }
}

/// Appends the project file: `a/b` becomes `a/b/b.pjx`.
pub fn with_manifest(path: Utf8PathBuf) -> Utf8PathBuf {
    if path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("pjx")) {
        return path;
    }
    match path.file_name() {
        Some(name) => path.join(format!("{name}.pjx")),
        None => path,
    }
}

/// Whether two paths are equal in any letter case.
pub fn is_same(path: &Utf8Path, other: &Utf8Path) -> bool {
    path_key(path.as_str()) == path_key(other.as_str())
}

/// Returns the rest of `path` below `folder` in any letter case: empty for the folder itself, `None` if the path is
/// outside.
pub fn inside<'p>(path: &'p Utf8Path, folder: &Utf8Path) -> Option<&'p Utf8Path> {
    let mut rest = path.components();
    for part in folder.components() {
        let own = rest.next()?;
        if path_key(own.as_str()) != path_key(part.as_str()) {
            return None;
        }
    }
    Some(rest.as_path())
}

/// Removes `.`, `..` and doubled separators, without disk access.
pub fn normalise(path: &Utf8Path) -> Utf8PathBuf {
    let mut out = Utf8PathBuf::new();
    for component in path.components() {
        match component {
            Utf8Component::CurDir => {}
            Utf8Component::ParentDir if out.file_name().is_some_and(|name| name != "..") => {
                out.pop();
            }
            other => out.push(other),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    fn roots() -> Roots {
        Roots { disk: Some("/cell/usrapp".into()), others: vec![("USB1".to_owned(), "/media/usb".into())] }
    }

    fn resolve(reference: &str) -> String {
        match project(Utf8Path::new("/cell/usrapp/app"), &roots(), reference) {
            ResolvedPath::Path(path) => path.into_string(),
            ResolvedPath::Elsewhere => "elsewhere".to_owned(),
        }
    }

    #[test]
    fn ends_of_paths_begin_at_the_folder_around_both() {
        let ends = |one, other| distinct_ends(Utf8Path::new(one), Utf8Path::new(other)).map(Utf8Path::as_str);
        assert_eq!(ends("/c/libs/A/A.pjx", "/c/libs/libs/A/A.pjx"), ["libs/A/A.pjx", "libs/libs/A/A.pjx"]);
        assert_eq!(ends("/a/A.pjx", "/b/A.pjx"), ["/a/A.pjx", "/b/A.pjx"]);
    }

    #[test]
    fn every_form_of_real_projects_is_resolved() {
        assert_eq!(resolve("Disk://io/io.pjx"), "/cell/usrapp/io/io.pjx");
        assert_eq!(resolve("Disk://a/b/c.pjx"), "/cell/usrapp/a/b/c.pjx");
        assert_eq!(resolve("Disk://..//templates/x/x.pjx"), "/cell/templates/x/x.pjx");
        assert_eq!(resolve("Disk://a/2/../b/b.pjx"), "/cell/usrapp/a/b/b.pjx");
        assert_eq!(resolve("./tray/tray.pjx"), "/cell/usrapp/app/tray/tray.pjx");
        assert_eq!(resolve("../part"), "/cell/usrapp/part/part.pjx");
        assert_eq!(resolve("Disk://io"), "/cell/usrapp/io/io.pjx");
        assert_eq!(resolve("io"), "/cell/usrapp/io/io.pjx");
        assert_eq!(resolve("/Libraries/x"), "/cell/usrapp/Libraries/x/x.pjx");
        assert_eq!(resolve("USB0://articles/a1"), "elsewhere");
        assert_eq!(resolve("usb1://articles/a1"), "/media/usb/articles/a1/a1.pjx");
    }

    #[test]
    fn steps_up_end_at_the_root() {
        let normal = |path: &str| normalise(Utf8Path::new(path)).into_string();
        assert_eq!(normal("/a/./b//c/../d"), "/a/b/d");
        assert_eq!(normal("../a"), "../a");
        assert_eq!(normal("a/../../b"), "../b");
    }

    #[test]
    fn letter_case_makes_no_difference() {
        let rest = |path: &'static str, folder: &str| inside(Utf8Path::new(path), Utf8Path::new(folder));
        assert_eq!(rest("/Cell/UsrApp/main", "/cell/usrapp"), Some(Utf8Path::new("main")));
        assert_eq!(rest("/cell/usrapp", "/CELL/usrapp"), Some(Utf8Path::new("")));
        assert_eq!(rest("/cell/usrapp2", "/cell/usrapp"), None);
        assert_eq!(rest("/cell", "/cell/usrapp"), None);
        assert!(is_same(Utf8Path::new("/a/PROG.pgx"), Utf8Path::new("/A/prog.PGX")));
    }

    #[test]
    fn the_root_of_a_reference_is_found() {
        let start = |prefix: &str| projects_from(Utf8Path::new("/cell/usrapp/app"), &roots(), prefix);
        let found = |folder: &str, partial: &str| Some((folder.into(), partial.to_owned()));
        assert_eq!(start("Disk://parts/Part"), found("/cell/usrapp/parts", "part"));
        assert_eq!(start("Disk://"), found("/cell/usrapp", ""));
        assert_eq!(start("part"), found("/cell/usrapp", "part"));
        assert_eq!(start("./parts/"), found("/cell/usrapp/app/parts", ""));
        assert_eq!(start("USB0://parts/"), None);
    }
}
