//! References to libraries and types when the target or the referencing project moves.

use camino::{Utf8Component, Utf8Path, Utf8PathBuf};
use val3_analysis::db::{Db, File, Project};
use val3_analysis::interfaces::{LoadedPath, uses};
use val3_analysis::items::manifest::{entries, spelling};
use val3_analysis::items::parse;
use val3_analysis::items::project::{find_project, folder, program_files};
use val3_analysis::paths::{self, ResolvedPath, Roots, path_key};

use val3_analysis::xml;
use val3_syntax::TextRange;

use super::projects;
use crate::document_links::without_quotes;
use crate::edit::FileEdit;
use crate::xml_list::escaped;

/// Edits when the folder `from` moves to `to`.
pub(super) fn of_folder(db: &dyn Db, from: &Utf8Path, to: &Utf8Path) -> Vec<FileEdit> {
    all(db, |path| paths::inside(path, from).map_or_else(|| path.to_owned(), |rest| to.join(rest)))
}

/// Edits when the project file `manifest` moves to the path `to`.
pub(super) fn of_manifest(db: &dyn Db, manifest: File, to: &Utf8Path) -> Vec<FileEdit> {
    let from = manifest.path(db);
    all(db, |path| if path == from { to.to_owned() } else { path.to_owned() })
}

fn all(db: &dyn Db, moved: impl Fn(&Utf8Path) -> Utf8PathBuf) -> Vec<FileEdit> {
    projects(db).into_iter().flat_map(|project| of_project(db, project, &moved)).collect()
}

/// Edits of the references in one project that must change.
fn of_project(db: &dyn Db, project: Project, moved: &impl Fn(&Utf8Path) -> Utf8PathBuf) -> Vec<FileEdit> {
    let new_folder = moved(project.manifest(db).path(db)).parent().map(Utf8Path::to_owned).unwrap_or_default();
    let mover = ReferenceMover { db, project, new_folder: &new_folder, moved };
    let whole = references(db, project).into_iter().filter_map(|(place, old)| Some((place, mover.new_path(&old)?)));
    let beginnings = beginnings(db, project).into_iter();
    let beginnings = beginnings.filter_map(|(place, old)| Some((place, mover.new_beginning(&old)?)));
    let edits = whole.chain(beginnings).map(|((file, range), new)| {
        let plain = file != project.manifest(db) && file.text(db).contains("<![CDATA[");
        FileEdit { file, range, text: if plain { new } else { escaped(&new) } }
    });
    edits.collect()
}

/// Adapts the references in a project to a move.
struct ReferenceMover<'a, F> {
    db: &'a dyn Db,
    project: Project,
    /// Folder of the project after the move.
    new_folder: &'a Utf8Path,
    /// Returns the path after the move.
    moved: &'a F,
}

impl<F: Fn(&Utf8Path) -> Utf8PathBuf> ReferenceMover<'_, F> {
    /// New path of a reference; `None` if the present path is still right.
    fn new_path(&self, reference: &str) -> Option<String> {
        let target = find_project(self.db, self.project, reference)?;
        let from = target.manifest(self.db).path(self.db);
        let to = (self.moved)(from);
        self.adapted(reference, &to, to != *from)
    }

    /// New literal prefix of a path (`"Disk://parts/p" + sName`) when its folder or the project itself moves. If only
    /// one of several projects in that folder moves, the reference is unchanged.
    fn new_beginning(&self, old: &str) -> Option<String> {
        let (start, name) = old.split_at(old.rfind(['/', '\\'])? + 1);
        let any = format!("{start}{ANY_PROJECT}");
        let folder = folder(self.db, self.project);
        let ResolvedPath::Path(probe) = paths::project(folder, self.project.roots(self.db), &any) else { return None };
        let from = as_stored(self.db, probe.parent()?);
        let to = (self.moved)(&from);
        let new = self.adapted(&any, &to.join(ANY_PROJECT), to != from)?;
        Some(format!("{}{name}", new.strip_suffix(ANY_PROJECT)?))
    }

    /// Reference to the project file `to`; `None` if neither end has moved, or if `old` leads to `to`.
    fn adapted(&self, old: &str, to: &Utf8Path, has_moved: bool) -> Option<String> {
        let roots = self.project.roots(self.db);
        if !has_moved && self.new_folder == folder(self.db, self.project) {
            return None;
        }
        match paths::project(self.new_folder, roots, old) {
            ResolvedPath::Path(path) if paths::is_same(&path, to) => None,
            _ => rewritten(self.new_folder, roots, old, to),
        }
    }
}

/// Placeholder for the project in a path that is concatenated at run time.
const ANY_PROJECT: &str = "any.pjx";

/// Folder in the spelling of the disk, if it contains projects.
fn as_stored(db: &dyn Db, path: &Utf8Path) -> Utf8PathBuf {
    let projects = projects(db);
    let mut folders = projects.iter().flat_map(|project| folder(db, *project).ancestors());
    folders.find(|folder| paths::is_same(folder, path)).unwrap_or(path).to_owned()
}

/// String literals in the code with which a library path begins.
fn beginnings(db: &dyn Db, project: Project) -> Vec<((File, TextRange), String)> {
    let mut found = Vec::new();
    for file in program_files(db, project) {
        for load in &uses(db, *file).loads {
            if let LoadedPath::Prefix { text, range } = &load.path {
                found.push(((*file, without_quotes(file.text(db), *range)), text.to_string()));
            }
        }
    }
    found
}

/// References of a project to other projects: their range and target.
fn references(db: &dyn Db, project: Project) -> Vec<((File, TextRange), String)> {
    let mut found = Vec::new();
    let manifest = project.manifest(db);
    let parse = parse(db, manifest);
    if let Some(root) = xml::root(parse.view()) {
        let spelling = spelling(root);
        let libraries = entries(root, spelling.libraries).filter_map(|entry| entry.attribute(spelling.library_path));
        let types = entries(root, spelling.types).filter_map(|entry| entry.attribute("path"));
        found.extend(libraries.chain(types).map(|path| ((manifest, path.range), path.text().into_owned())));
    }
    for file in program_files(db, project) {
        for load in &uses(db, *file).loads {
            if let LoadedPath::Whole(path) = &load.path {
                found.push(((*file, without_quotes(file.text(db), load.range)), path.to_string()));
            }
        }
    }
    found
}

/// Reference to the project file `to` in the form of `old`: with the same root, and with the name of the `.pjx` if
/// `old` contains it. `None` if this root does not contain `to`.
fn rewritten(folder: &Utf8Path, roots: &Roots, old: &str, to: &Utf8Path) -> Option<String> {
    let plain = old.trim().replace('\\', "/");
    let (root, rest) = match plain.split_once("://") {
        Some((root, rest)) => (format!("{root}://"), rest),
        None => (String::new(), plain.as_str()),
    };
    let path = if root.is_empty() && (rest.starts_with("./") || rest.starts_with("../")) {
        let path = relative(folder, to)?;
        if path.starts_with("../") { path } else { format!("./{path}") }
    } else {
        let ResolvedPath::Path(probe) = paths::project(folder, roots, &format!("{root}x.pjx")) else { return None };
        relative(probe.parent()?, to).filter(|path| !path.starts_with("../"))?
    };
    let has_manifest = rest.to_lowercase().ends_with(".pjx");
    let named_alike = to.parent().and_then(Utf8Path::file_name) == to.file_stem();
    let path = match path.rsplit_once('/') {
        Some((folder, _)) if !has_manifest && named_alike => folder.to_owned(),
        _ => path,
    };
    let path = if old.contains('\\') && !rest.is_empty() && !old.replace("://", "").contains('/') {
        path.replace('/', "\\")
    } else {
        path
    };
    Some(format!("{root}{path}"))
}

/// `to` relative to `folder`, with `/`; `None` without a common parent.
pub(crate) fn relative(folder: &Utf8Path, to: &Utf8Path) -> Option<String> {
    let (from, to): (Vec<Utf8Component<'_>>, Vec<_>) = (folder.components().collect(), to.components().collect());
    let common = from.iter().zip(&to).take_while(|(a, b)| is_alike(**a, **b)).count();
    let up = std::iter::repeat_n("..", from.len() - common);
    let down = to.iter().skip(common).map(|component| component.as_str());
    (common > 0).then(|| up.chain(down).collect::<Vec<_>>().join("/"))
}

fn is_alike(one: Utf8Component<'_>, other: Utf8Component<'_>) -> bool {
    path_key(one.as_str()) == path_key(other.as_str())
}
