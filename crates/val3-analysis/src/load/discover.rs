//! Which projects lie under a path.

use camino::{Utf8Path, Utf8PathBuf};
use rustc_hash::FxHashSet;
use val3_files::{FileClass, Unreadable};

use super::error::LoadError;
use super::outside::refused_link;
use crate::system::{Kind, System};

/// Folders below the path asked for are searched this deep.
const DEPTH: usize = 32;

/// The `.pjx` files under `path`: a project file, an application folder, a cell, or any folder above some.
pub(super) fn manifests(
    system: &dyn System,
    path: &Utf8Path,
    unreadable: &mut Vec<(Utf8PathBuf, String)>,
) -> Result<Vec<Utf8PathBuf>, LoadError> {
    let before = unreadable.len();
    let found = match system.kind(path) {
        None => return Err(error(path, &missing(system, path))),
        Some(Kind::File) => of_file(system, path)?,
        Some(Kind::Folder) => files(system, path, "pjx", unreadable),
    };
    if found.is_empty() {
        if let Some((entry, reason)) = unreadable.get(before) {
            return Err(error(entry, &format!("it cannot be read: {reason}")));
        }
        let reason = "there is no VAL 3 application (`.pjx`) in this folder or below; name an application folder, \
                      a `.pjx`, or a controller folder";
        return Err(error(path, reason));
    }
    Ok(found)
}

/// The reason why there is nothing at a path: often a folder above it cannot be read.
fn missing(system: &dyn System, path: &Utf8Path) -> String {
    match system.read(path, FileClass::Program) {
        Err(reason) if !reason.is_missing() => format!("it cannot be read: {reason}"),
        _ => "there is no such file or folder".to_owned(),
    }
}

fn error(path: &Utf8Path, reason: &str) -> LoadError {
    LoadError::Path { path: path.to_owned(), reason: reason.to_owned() }
}

/// A `.pjx` itself; for a program or data file the project in its folder.
fn of_file(system: &dyn System, path: &Utf8Path) -> Result<Vec<Utf8PathBuf>, LoadError> {
    if is_manifest(path) {
        return Ok(vec![path.to_owned()]);
    }
    let is_ours = path
        .extension()
        .is_some_and(|extension| extension.eq_ignore_ascii_case("pgx") || extension.eq_ignore_ascii_case("dtx"));
    if !is_ours {
        return Err(error(path, "this is not a VAL 3 file; name a `.pjx`, or the folder of an application"));
    }
    let folder = path.parent().unwrap_or(Utf8Path::new("."));
    let names = system.list(folder).map_err(|reason| error(folder, &format!("the folder cannot be read: {reason}")))?;
    let beside: Vec<_> = names.iter().map(|name| folder.join(name)).filter(|path| is_manifest(path)).collect();
    if beside.is_empty() {
        return Err(error(path, "there is no `.pjx` next to this file, so its application is not known"));
    }
    Ok(beside)
}

fn is_manifest(path: &Utf8Path) -> bool {
    has_extension(path, "pjx")
}

fn has_extension(path: &Utf8Path, extension: &str) -> bool {
    path.extension().is_some_and(|found| found.eq_ignore_ascii_case(extension))
}

/// The files with an extension in `folder` and the folders below, hidden ones aside. Folders and entries that cannot be
/// read go into `unreadable`, with the reason.
pub fn files(
    system: &dyn System,
    folder: &Utf8Path,
    extension: &'static str,
    unreadable: &mut Vec<(Utf8PathBuf, String)>,
) -> Vec<Utf8PathBuf> {
    let (root, found, seen) = (folder, Vec::new(), FxHashSet::default());
    let mut search = Search { system, root, extension, found, seen, unreadable };
    search.folder(folder, 0);
    search.found
}

struct Search<'s> {
    system: &'s dyn System,
    /// The folder that is searched.
    root: &'s Utf8Path,
    extension: &'static str,
    found: Vec<Utf8PathBuf>,
    /// Folders already searched, so that links in a circle end.
    seen: FxHashSet<Utf8PathBuf>,
    unreadable: &'s mut Vec<(Utf8PathBuf, String)>,
}

impl Search<'_> {
    fn folder(&mut self, path: &Utf8Path, depth: usize) {
        if depth > DEPTH || !self.seen.insert(self.system.identity(path)) {
            return;
        }
        let names = match self.system.list(path) {
            Ok(names) => names,
            Err(error) => return self.unreadable.push((path.to_owned(), Unreadable::from(error).to_string())),
        };
        for name in names.iter().filter(|name| !name.starts_with('.')) {
            let entry = path.join(name);
            let is_wanted = has_extension(&entry, self.extension);
            if !is_wanted && !may_be_folder(name) {
                continue;
            }
            match self.system.kind(&entry) {
                Some(Kind::File) if is_wanted && self.follows(&entry) => self.found.push(entry),
                Some(Kind::Folder) if is_wanted => self.unreadable.push((entry, Unreadable::Folder.to_string())),
                Some(Kind::Folder) if may_be_folder(name) && self.follows(&entry) => self.folder(&entry, depth + 1),
                None => self.hidden(entry),
                _ => {}
            }
        }
    }

    /// An entry of which the system shows only the name. A link to nothing is no fault.
    fn hidden(&mut self, entry: Utf8PathBuf) {
        match self.system.read(&entry, FileClass::Program) {
            Err(reason) if !reason.is_missing() => self.unreadable.push((entry, reason.to_string())),
            _ => {}
        }
    }
}

impl Search<'_> {
    /// Whether the search continues at an entry. A link out of the cell is reported instead.
    fn follows(&mut self, entry: &Utf8Path) -> bool {
        let refusal = refused_link(self.system, self.root, entry);
        self.unreadable.extend(refusal.iter().map(|reason| (entry.to_owned(), reason.clone())));
        refusal.is_none()
    }
}

/// Saves a look at the disk for files whose extension gives their kind.
fn may_be_folder(name: &str) -> bool {
    let extension = name.rsplit_once('.').map_or("", |(_, extension)| extension);
    !["pgx", "dtx", "ltx", "cfx", "html", "json", "png", "xml"]
        .iter()
        .any(|known| extension.eq_ignore_ascii_case(known))
        && name != "node_modules"
}
