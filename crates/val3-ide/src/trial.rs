//! Trial database, in which changes are tried before they are offered.

use std::collections::BTreeSet;
use std::sync::Arc;

use camino::{Utf8Path, Utf8PathBuf};
use rustc_hash::FxHashSet;
use salsa::Setter as _;
use val3_analysis::db::{Db, File, Project, Sources};
use val3_analysis::load::Workspace;
use val3_analysis::paths::path_key;
use val3_analysis::system::{OverlayFs, System};
use val3_check::diagnostic::{Diagnostic, Fix};
use val3_check::fix::TrialWorkspace;
use val3_check::settings::{RuleSelection, WorkspaceSettings};
use val3_check::{CheckUnit, Checked, check_unit, finish, units};

use crate::owner::projects_of;
use crate::references::projects_using;

/// Some projects in a separate database.
pub(crate) struct TrialProjects<'s> {
    workspace: Workspace,
    files: OverlayFs<&'s dyn System>,
    /// Paths of the project files.
    paths: Vec<Utf8PathBuf>,
    /// Called between units. It may unwind if the result is no longer needed.
    check_cancelled: &'s dyn Fn(),
}

impl<'s> TrialProjects<'s> {
    /// Creates a trial with the projects that fixes can affect: the projects whose files `fixes` edit, and all projects
    /// that use them.
    pub(crate) fn of_fixes<'f>(
        db: &dyn Db,
        system: &'s dyn System,
        fixes: impl Iterator<Item = &'f Fix>,
        check_cancelled: &'s dyn Fn(),
    ) -> Self {
        let edited = fixes.flat_map(|fix| &fix.edits).flat_map(|edit| projects_of(db, edit.file));
        let edited: FxHashSet<Project> = edited.copied().collect();
        let affected = edited.into_iter().flat_map(|project| projects_using(db, project));
        Self::of(db, system, affected, check_cancelled)
    }

    /// Creates a trial with `projects` and all projects that they reference.
    pub(crate) fn of(
        db: &dyn Db,
        system: &'s dyn System,
        projects: impl Iterator<Item = Project>,
        check_cancelled: &'s dyn Fn(),
    ) -> Self {
        let paths: BTreeSet<Utf8PathBuf> = projects.map(|project| project.manifest(db).path(db).clone()).collect();
        let files = OverlayFs::new(system);
        let mut trial =
            Self { workspace: Workspace::empty(), files, paths: paths.into_iter().collect(), check_cancelled };
        trial.read(true);
        trial
    }

    /// A data file and its findings.
    pub(crate) fn data_findings(&self, path: &Utf8Path) -> Option<(File, Vec<Diagnostic>)> {
        let db = &self.workspace.db;
        let file = *Sources::get(db).files(db).get(&path_key(path.as_str()))?;
        let settings = self.settings();
        let units = units(db, &self.workspace.projects).into_iter();
        let units = units.filter(|unit| matches!(unit, CheckUnit::Data(_, data) if *data == file));
        Some((file, units.map(|unit| self.checked(unit, &settings)).sum::<Checked>().findings))
    }

    fn settings(&self) -> WorkspaceSettings {
        let Workspace { db, projects, .. } = &self.workspace;
        WorkspaceSettings::new(db, projects, &RuleSelection::default()).unwrap_or_default()
    }

    fn checked(&self, unit: CheckUnit, settings: &WorkspaceSettings) -> Checked {
        (self.check_cancelled)();
        check_unit(&self.workspace.db, unit, settings)
    }

    fn read(&mut self, is_stale: bool) {
        // A faulty configuration has the same effect before and after a fix.
        let _ = self.workspace.refresh(&self.files, &self.paths, &|_| is_stale);
    }
}

impl TrialWorkspace for TrialProjects<'_> {
    fn db(&self) -> &dyn Db {
        &self.workspace.db
    }

    fn all_findings(&mut self) -> Vec<Diagnostic> {
        let Workspace { db, projects, .. } = &self.workspace;
        let units = units(db, projects);
        let settings = self.settings();
        let checked: Checked = units.iter().map(|unit| self.checked(*unit, &settings)).sum();
        finish(db, &units, &settings, checked).findings
    }

    fn set_texts<'t>(&mut self, texts: impl Iterator<Item = (&'t Utf8Path, &'t Arc<str>)>) {
        for (path, text) in texts {
            self.files.edit(path, Arc::clone(text));
            let db = &mut self.workspace.db;
            let file = Sources::get(db).files(db).get(&path_key(path.as_str())).copied();
            if let Some(file) = file {
                file.set_text(db).to(Arc::clone(text));
            }
        }
        self.read(false);
    }
}
