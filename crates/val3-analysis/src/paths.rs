//! The paths that projects and programs write: `Disk://a/a.pjx`, `./b`, `../c/c.pjx`, `io`, `USB0://d`.

use camino::{Utf8Component, Utf8Path, Utf8PathBuf};
use smol_str::SmolStr;
use val3_lang::suggest::nearest;

/// The root of paths without one: the flash memory of the controller.
const DISK: &str = "Disk";

/// The roots that every controller has (6.7).
const MEDIA: [&str; 4] = [DISK, "Floppy", "USB0", "USB1"];

/// The nearest folder `usrapp` above a project. It is the folder of `Disk://` on a controller.
pub(crate) fn usrapp(manifest: &Utf8Path) -> Option<&Utf8Path> {
    let is_usrapp = |path: &&Utf8Path| path.file_name().is_some_and(|name| name.eq_ignore_ascii_case("usrapp"));
    manifest.ancestors().skip(1).find(is_usrapp)
}

/// The ends of two different paths, from the last folder that contains both.
pub fn distinct_ends<'p>(one: &'p Utf8Path, other: &'p Utf8Path) -> [&'p Utf8Path; 2] {
    let common = one.ancestors().find(|folder| other.starts_with(folder) && *folder != one);
    let around = common.and_then(Utf8Path::parent).unwrap_or(Utf8Path::new(""));
    [one, other].map(|path| path.strip_prefix(around).unwrap_or(path))
}

/// The key under which a path is found: files are looked up without regard to letter case.
pub fn path_key(path: &str) -> String {
    path.to_lowercase()
}

/// The folders of the roots of paths.
#[derive(Debug, Clone, PartialEq, Eq, Hash, Default)]
pub struct Roots {
    /// `Disk://`; `None` where it is unknown.
    pub disk: Option<Utf8PathBuf>,
    /// Other roots by name: `USB0`.
    pub others: Vec<(String, Utf8PathBuf)>,
}

impl Roots {
    /// The folder of a root.
    fn folder(&self, root: &str) -> Option<&Utf8Path> {
        if root.eq_ignore_ascii_case(DISK) {
            return self.disk.as_deref();
        }
        let named = self.others.iter().find(|(name, _)| root.eq_ignore_ascii_case(name));
        named.map(|(_, folder)| folder.as_path())
    }
}

/// Where a reference points.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub enum Target {
    /// A path of the local disk.
    Path(Utf8PathBuf),
    /// A root without a known folder (`USB0://`, an FTP connection): nothing to check against.
    Elsewhere,
}

/// Reads the reference to a file of the project in `folder`, which is normal: a program or data file.
pub fn file_in(folder: &Utf8Path, reference: &str) -> Utf8PathBuf {
    let reference = reference.trim();
    if is_plain_name(reference) {
        return folder.join(reference);
    }
    normalise(&folder.join(reference.replace('\\', "/")))
}

/// The name of a file in the same folder, as nearly every reference is.
fn is_plain_name(reference: &str) -> bool {
    !reference.contains(['/', '\\']) && !matches!(reference, "" | "." | "..")
}

/// Reads the reference to another project, as `<Library path>`, `<Type path>` and `libLoad` write it (6.6):
/// the root is `Disk` unless given, the path may be the folder or the `.pjx` in it.
pub fn project(folder: &Utf8Path, roots: &Roots, reference: &str) -> Target {
    let reference = reference.trim().replace('\\', "/");
    let path = match reference.split_once("://") {
        Some((root, rest)) => roots.folder(root).map(|root| root.join(rest.trim_start_matches('/'))),
        None if reference.starts_with("./") || reference.starts_with("../") => Some(folder.join(&reference)),
        None => roots.disk.as_ref().map(|disk| disk.join(reference.trim_start_matches('/'))),
    };
    path.map_or(Target::Elsewhere, |path| Target::Path(with_manifest(normalise(&path))))
}

/// The root of such a reference.
pub fn root(reference: &str) -> &str {
    let named = reference.trim().split_once("://").map(|(root, _)| root).filter(|root| !root.is_empty());
    named.unwrap_or(DISK)
}

/// The root that was probably meant by an unknown one; `None` for a medium of the controller.
pub fn near_root(root: &str, roots: &Roots) -> Option<SmolStr> {
    let is_medium = MEDIA.iter().any(|medium| root.eq_ignore_ascii_case(medium));
    let named = roots.others.iter().map(|(name, _)| name.as_str());
    if is_medium { None } else { nearest(root, MEDIA.into_iter().chain(named)).map(SmolStr::from) }
}

/// Reads the start of such a reference (`"Disk://parts/part" + sName`): the folder that holds the projects, and how
/// the names of their own folders begin, in lower case.
pub fn projects_from(folder: &Utf8Path, roots: &Roots, prefix: &str) -> Option<(Utf8PathBuf, String)> {
    let (start, partial) = prefix.rsplit_once('/').unwrap_or(("", prefix));
    match project(folder, roots, &format!("{start}/x.pjx")) {
        Target::Path(probe) => Some((probe.parent()?.to_owned(), partial.to_lowercase())),
        Target::Elsewhere => None,
    }
}

/// `a/b` names the project `a/b/b.pjx`.
pub fn with_manifest(path: Utf8PathBuf) -> Utf8PathBuf {
    if path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("pjx")) {
        return path;
    }
    match path.file_name() {
        Some(name) => path.join(format!("{name}.pjx")),
        None => path,
    }
}

/// Whether two paths name the same file, without regard to letter case.
pub fn is_same(path: &Utf8Path, other: &Utf8Path) -> bool {
    path_key(path.as_str()) == path_key(other.as_str())
}

/// The rest of `path` inside `folder`, empty for the folder itself; `None` if it lies elsewhere. Letter case makes no
/// difference.
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

/// Without `.`, `..` and doubled separators, computed from the path alone.
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
            Target::Path(path) => path.into_string(),
            Target::Elsewhere => "elsewhere".to_owned(),
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
