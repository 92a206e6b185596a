//! Search for files below a folder.

use camino::{Utf8Path, Utf8PathBuf};
use rustc_hash::FxHashSet;
use val3_files::{FileClass, Unreadable, is_archive_name};

use super::outside::refused_link;
use crate::items::unlisted::{is_data, is_program};
use crate::system::{PathKind, System};

/// Maximum nesting of searched folders.
const DEPTH: usize = 32;

/// Returns the files with an extension in `folder` and below, except hidden ones. Unreadable folders and entries are
/// added to `unreadable` with the reason.
pub fn files(
    system: &dyn System,
    folder: &Utf8Path,
    extension: &'static str,
    unreadable: &mut Vec<(Utf8PathBuf, String)>,
) -> Vec<Utf8PathBuf> {
    search(system, folder, &|entry, _| has_extension(entry, extension), unreadable)
}

/// Returns programs and data files without a project file in their folder, and ZIP archives, in `folder` and below.
/// Unreadable entries are handled as in [`files`].
pub fn loose_files(
    system: &dyn System,
    folder: &Utf8Path,
    unreadable: &mut Vec<(Utf8PathBuf, String)>,
) -> Vec<Utf8PathBuf> {
    search(system, folder, &is_loose, unreadable)
}

/// Whether the entry of a folder is an archive, or a program or data file without a project file in the folder, which
/// contains `names`.
fn is_loose(entry: &Utf8Path, names: &[String]) -> bool {
    let is_part = is_program(entry.as_str()) || is_data(entry.as_str());
    is_archive_name(entry) || is_part && !names.iter().any(|name| has_extension(Utf8Path::new(name), "pjx"))
}

/// Whether the path has the extension, in any letter case.
pub(super) fn has_extension(path: &Utf8Path, extension: &str) -> bool {
    path.extension().is_some_and(|found| found.eq_ignore_ascii_case(extension))
}

fn search(
    system: &dyn System,
    root: &Utf8Path,
    wanted: &dyn Fn(&Utf8Path, &[String]) -> bool,
    unreadable: &mut Vec<(Utf8PathBuf, String)>,
) -> Vec<Utf8PathBuf> {
    let mut search = ProjectWalk { system, root, wanted, found: Vec::new(), seen: FxHashSet::default(), unreadable };
    search.folder(root, 0);
    search.found
}

struct ProjectWalk<'s> {
    system: &'s dyn System,
    /// Root folder of the search.
    root: &'s Utf8Path,
    /// Whether an entry is a result, by its path and the names of all entries in its folder.
    wanted: &'s dyn Fn(&Utf8Path, &[String]) -> bool,
    found: Vec<Utf8PathBuf>,
    /// Folders already searched, so that circular links terminate.
    seen: FxHashSet<Utf8PathBuf>,
    unreadable: &'s mut Vec<(Utf8PathBuf, String)>,
}

impl ProjectWalk<'_> {
    fn folder(&mut self, path: &Utf8Path, depth: usize) {
        if !self.seen.insert(self.system.identity(path)) {
            return;
        }
        if depth > DEPTH {
            let reason = format!("it lies more than {DEPTH} folders deep; name it to search it");
            return self.unreadable.push((path.to_owned(), reason));
        }
        let names = match self.system.list(path) {
            Ok(names) => names,
            Err(error) => return self.unreadable.push((path.to_owned(), Unreadable::from(error).to_string())),
        };
        for name in names.iter().filter(|name| !name.starts_with('.')) {
            let entry = path.join(name);
            let is_wanted = (self.wanted)(&entry, &names);
            if !is_wanted && !may_be_folder(name) {
                continue;
            }
            match self.system.kind(&entry) {
                Some(PathKind::File) if is_wanted && self.follows(&entry) => self.found.push(entry),
                // A folder named like a searched file is reported; a folder named like an archive is searched below.
                Some(PathKind::Folder) if is_wanted && !is_archive_name(&entry) => {
                    self.unreadable.push((entry, Unreadable::Folder.to_string()))
                }
                Some(PathKind::Folder) if may_be_folder(name) && self.follows(&entry) => self.folder(&entry, depth + 1),
                None => self.hidden(entry),
                _ => {}
            }
        }
    }

    /// Handles an entry of which the system reports only the name. A dangling link is no fault.
    fn hidden(&mut self, entry: Utf8PathBuf) {
        match self.system.read(&entry, FileClass::Program) {
            Err(reason) if !reason.is_missing() => self.unreadable.push((entry, reason.to_string())),
            _ => {}
        }
    }

    /// Whether the search follows an entry. A link out of the cell is reported instead.
    fn follows(&mut self, entry: &Utf8Path) -> bool {
        let refusal = refused_link(self.system, self.root, entry);
        self.unreadable.extend(refusal.iter().map(|reason| (entry.to_owned(), reason.clone())));
        refusal.is_none()
    }
}

/// Whether a name may be a folder's; avoids disk accesses for files with well-known extensions.
fn may_be_folder(name: &str) -> bool {
    let extension = name.rsplit_once('.').map_or("", |(_, extension)| extension);
    !["pgx", "dtx", "ltx", "cfx", "html", "json", "png", "xml"]
        .iter()
        .any(|known| extension.eq_ignore_ascii_case(known))
        && name != "node_modules"
}
