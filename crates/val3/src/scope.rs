//! Scope of reported findings: all findings in the request, or findings in single files.

use camino::{Utf8Path, Utf8PathBuf};
use rustc_hash::FxHashSet;
use val3_analysis::db::{Database, File, Project, Sources};
use val3_analysis::items::project::folder;
use val3_analysis::items::unlisted::{is_data, is_program};
use val3_analysis::paths::{normalise, path_key};

use val3_check::CheckUnit;

/// Scope of the report.
#[derive(Debug, Clone, Default)]
pub(crate) struct ReportFilter {
    /// Path keys of the requested programs and data files. Their applications are loaded without reporting their
    /// findings.
    files: FxHashSet<String>,
    /// Requested folders and project files, in which all findings are reported.
    whole: Vec<Utf8PathBuf>,
}

impl ReportFilter {
    /// Creates the scope for the requested absolute paths.
    pub(crate) fn new(asked: &[Utf8PathBuf]) -> Self {
        let paths = asked.iter().map(|path| normalise(path));
        let (files, whole): (Vec<_>, _) = paths.partition(|path| is_part(path) && !path.is_dir());
        Self { files: files.iter().map(|path| path_key(path.as_str())).collect(), whole }
    }

    /// Whether a finding in `file` from the check of `project` is reported.
    pub(crate) fn covers(&self, db: &Database, project: Project, file: File) -> bool {
        self.files.is_empty() || self.names(db, file) || self.is_whole(project.manifest(db).path(db))
    }

    fn names(&self, db: &Database, file: File) -> bool {
        self.files.contains(&path_key(file.path(db).as_str()))
    }

    fn is_whole(&self, manifest: &Utf8Path) -> bool {
        self.whole.iter().any(|asked| manifest.starts_with(asked))
    }

    /// Requested files that no project lists. They are checked as parts of the project in their folder.
    pub(crate) fn unlisted(&self, db: &Database, projects: &[Project]) -> Vec<CheckUnit> {
        let mut units = Vec::new();
        for file in Sources::get(db).unlisted(db).values().filter(|file| self.names(db, **file)) {
            let path = file.path(db);
            let Some(project) = projects.iter().find(|project| path.parent() == Some(folder(db, **project))) else {
                continue;
            };
            let unit = if is_program(path.as_str()) { CheckUnit::Program } else { CheckUnit::Data };
            units.push(unit(*project, *file));
        }
        units
    }
}

/// Whether the path has the extension of a program or data file.
fn is_part(path: &Utf8Path) -> bool {
    is_program(path.as_str()) || is_data(path.as_str())
}
