//! Views of a project and its data for lints.

use val3_analysis::application::{Application, application};
use val3_analysis::changes::is_changed;
use val3_analysis::db::{Db, File, Project, Sources};
use val3_analysis::items::manifest::manifest;
use val3_analysis::items::project::{Items, find_project, items};
use val3_config::Options;

/// A project: an application, a library or a user type.
pub(crate) struct ProjectView<'db> {
    pub(crate) db: &'db dyn Db,
    pub(crate) project: Project,
    pub(crate) items: &'db Items,
    /// Configured options of rules.
    pub(crate) options: &'db Options,
}

impl<'db> ProjectView<'db> {
    pub(crate) fn new(db: &'db dyn Db, project: Project, options: &'db Options) -> Self {
        Self { db, project, items: items(db, project), options }
    }

    /// Summary of all programs. Computing it reads every program of the project.
    pub(crate) fn application(&self) -> &'db Application {
        application(self.db, self.project)
    }

    /// Whether a program of the project may change the value at a data path such as `tSlots[1,2].pPlace[0]`.
    pub(crate) fn is_changed(&self, path: &str) -> bool {
        is_changed(self.db, self.project, path)
    }
}

/// Whether another project declares the project as a library or user type.
pub(crate) fn is_library(db: &dyn Db, project: Project) -> bool {
    Sources::get(db).projects(db).values().any(|user| declares(db, *user, project))
}

fn declares(db: &dyn Db, user: Project, library: Project) -> bool {
    let paths = manifest(db, user.manifest(db)).projects();
    paths.into_iter().any(|path| find_project(db, user, path) == Some(library))
}

/// A `.dtx` without syntax faults.
pub(crate) struct DataFile<'db> {
    pub(crate) file: File,
    /// Project of the file.
    pub(crate) view: ProjectView<'db>,
}

impl<'db> DataFile<'db> {
    pub(crate) fn new(db: &'db dyn Db, project: Project, file: File, options: &'db Options) -> Self {
        Self { file, view: ProjectView::new(db, project, options) }
    }
}
