//! Files without a project: programs and data files, which are checked separately, and archives, which are only read if
//! an argument names them.

mod archives;
mod stand_in;

use camino::{Utf8Path, Utf8PathBuf};
use rustc_hash::FxHashMap;
use val3_analysis::db::{Database, File, FileStatus, Project, Sources};
use val3_analysis::items::unlisted::{is_data, is_program};
use val3_analysis::load::{Workspace, loose_files, nearest_configuration};
use val3_analysis::paths::{normalise, path_key};
use val3_analysis::system::{OverlayFs, PathKind, System};
use val3_check::diagnostic::Diagnostic;
use val3_check::loose::{archive_not_read, without_project};
use val3_check::settings::WorkspaceSettings;
use val3_files::is_archive_name;
use val3_syntax::encoding::Encoding;

use crate::paths::{Paths, has_extension};
pub(crate) use archives::UnreadArchive;

/// Requested files without a project.
#[derive(Debug, Default)]
pub(crate) struct LooseFiles {
    /// Programs and data files, by the stand-in project file's path key.
    alone: FxHashMap<String, Utf8PathBuf>,
    /// Archives with VAL 3 files, and archives with unknown contents.
    archives: Vec<UnreadArchive>,
    /// Paths that cannot be searched, with the reason.
    unreadable: Vec<(Utf8PathBuf, String)>,
}

impl LooseFiles {
    /// Finds the files without a project in the requested paths, and overlays a stand-in project file for each program
    /// and data file.
    pub(crate) fn lay_over<S: System>(system: &mut OverlayFs<S>, asked: &[Utf8PathBuf]) -> Self {
        let mut loose = Self::default();
        let mut found: Vec<Utf8PathBuf> =
            asked.iter().flat_map(|path| found_under(system, &normalise(path), &mut loose.unreadable)).collect();
        found.sort_unstable();
        found.dedup();
        for path in found {
            if is_archive_name(&path) {
                loose.archives.extend(UnreadArchive::of(path));
                continue;
            }
            let stand_in = stand_in::path(&path);
            let project = stand_in::project(system, &path);
            system.store(stand_in.clone(), project.into_bytes());
            loose.alone.insert(path_key(stand_in.as_str()), path);
        }
        loose
    }

    /// Adds the paths that cannot be searched to the unreadable paths of the workspace.
    pub(crate) fn report_unreadable(&mut self, workspace: &mut Workspace) {
        workspace.unreadable.append(&mut self.unreadable);
        workspace.unreadable.sort_unstable();
        workspace.unreadable.dedup();
    }

    /// Program or data file of a stand-in project file; `None` for other project files.
    pub(crate) fn file_of(&self, manifest: &Utf8Path) -> Option<&Utf8Path> {
        if self.alone.is_empty() {
            return None;
        }
        self.alone.get(&path_key(manifest.as_str())).map(Utf8PathBuf::as_path)
    }

    /// Whether the project is a stand-in for a file without a project.
    pub(crate) fn stands_in(&self, db: &Database, project: Project) -> bool {
        self.file_of(project.manifest(db).path(db)).is_some()
    }

    /// Findings about the files themselves.
    pub(crate) fn findings(
        &self,
        workspace: &Workspace,
        settings: &WorkspaceSettings,
        paths: &Paths,
    ) -> Vec<Diagnostic> {
        let db = &workspace.db;
        let alone = workspace.projects.iter().filter_map(|project| {
            let path = self.file_of(project.manifest(db).path(db))?;
            let file = Sources::get(db).files(db).get(&path_key(path.as_str()))?;
            without_project(db, *project, *file, settings)
        });
        let archives = self.archives.iter().filter_map(|archive| {
            let status = FileStatus::Read { encoding: Encoding::Utf8, mismatch: None };
            let file = File::new(db, archive.path.clone(), "".into(), status);
            archive_not_read(db, file, &paths.shown(&archive.path), &archive.content, settings.at(db, &archive.path))
        });
        alone.chain(archives).collect()
    }
}

/// Archives with VAL 3 files in a folder and its subfolders.
pub(crate) fn archives_under(system: &dyn System, folder: &Utf8Path) -> Vec<UnreadArchive> {
    let found = found_under(system, folder, &mut Vec::new());
    found.into_iter().filter(|path| is_archive_name(path)).filter_map(UnreadArchive::of).collect()
}

/// Finds the files without a project in a requested path that no `val3.toml` excludes.
fn found_under(system: &dyn System, asked: &Utf8Path, unreadable: &mut Vec<(Utf8PathBuf, String)>) -> Vec<Utf8PathBuf> {
    match system.kind(asked) {
        Some(PathKind::Folder) => {
            let mut found = loose_files(system, asked, unreadable);
            found.retain(|path| !is_excluded(system, asked, path));
            found
        }
        Some(PathKind::File) if is_part(asked) && !has_project(system, asked) => vec![asked.to_owned()],
        _ => Vec::new(),
    }
}

/// Whether a `val3.toml` excludes a file from a search in `asked`. The exclusion does not apply if it covers the entire
/// folder `asked`, because the user has named this folder explicitly.
fn is_excluded(system: &dyn System, asked: &Utf8Path, path: &Utf8Path) -> bool {
    let folder = path.parent().unwrap_or(Utf8Path::new(""));
    // An invalid configuration is reported when the projects are loaded.
    let configuration = nearest_configuration(system, folder).ok().flatten();
    configuration.is_some_and(|file| {
        let is_named = file.excludes(asked) || file.excludes(&asked.join(ANY_FILE));
        file.excludes(path) && !is_named
    })
}

/// File name that only a pattern for all files of a folder matches.
const ANY_FILE: &str = "_";

fn is_part(path: &Utf8Path) -> bool {
    is_program(path.as_str()) || is_data(path.as_str())
}

/// Whether the file's folder contains a project file.
fn has_project(system: &dyn System, path: &Utf8Path) -> bool {
    let names = path.parent().and_then(|folder| system.list(folder).ok());
    names.is_some_and(|names| names.iter().any(|name| has_extension(name.as_ref(), "pjx")))
}
