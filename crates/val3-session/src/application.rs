//! An opened application: its compiler errors, its image, its controller.

use std::collections::BTreeMap;
use std::sync::Arc;

use camino::{Utf8Path, Utf8PathBuf};
use salsa::Setter as _;
use val3_analysis::db::{Database, Project, Sources};
use val3_analysis::items::project::{folder, items};
use val3_analysis::load::{self, LoadError, Workspace, loads_alike};
use val3_analysis::paths::{is_same, normalise, path_key};
use val3_analysis::system::System;
use val3_analysis::test_applications::has_tests;
use val3_bytecode::Image;
use val3_check::diagnostic::Diagnostic;
use val3_compile::{CodeForm, CompileError};
use val3_machine::controller::Controller;

use crate::cell_profiles::{self, CellProfile};
use crate::connection::Tape;
use crate::error::SessionError;
use crate::settings::ControllerSettings;
use crate::stand_ins::{self, StandIn, StandInFault};
use crate::{arm, controller, grants, io_library, readable};

/// An application and its referenced libraries and files.
pub struct Application {
    workspace: Workspace,
    project: Project,
    /// Libraries that are loaded in place of other libraries.
    stand_ins: Vec<StandIn>,
}

impl Application {
    /// Reads the application at the absolute `path`: a `.pjx`, its folder, anything below that folder, or a folder that
    /// contains one application. If there are several applications, `program` selects the only one with this program
    /// that is no test application. All others are discarded.
    ///
    /// # Errors
    /// If `path` does not contain exactly one such application, or if a `val3.toml` is invalid.
    pub fn open(system: &dyn System, path: &Utf8Path, program: Option<&str>) -> Result<Self, SessionError> {
        let workspace = load::load(system, &[path.to_owned()])?;
        let project = only_application(&workspace, path, program)?;
        if workspace.projects.len() > 1 {
            let manifest = project.manifest(&workspace.db).path(&workspace.db).clone();
            return Self::open(system, &manifest, None);
        }
        Ok(Self::of(workspace, project))
    }

    /// Reads the application with this project file, and the stand-ins in its `val3.toml`, which its controller loads
    /// in place of libraries. `others` are further stand-ins with absolute paths, by identifier, and take precedence.
    ///
    /// # Errors
    /// If the application does not exist, if the path of a stand-in contains no library, or if a `val3.toml` is
    /// invalid.
    pub fn open_with_stand_ins(
        system: &dyn System,
        manifest: &Utf8Path,
        others: &BTreeMap<String, String>,
    ) -> Result<Self, SessionError> {
        let folder = manifest.parent().unwrap_or(manifest);
        let file =
            load::nearest_configuration(system, folder).map_err(|error| LoadError::Configuration(vec![error]))?;
        let mut file = file.unwrap_or_default();
        let paths = others.iter().map(|(identifier, path)| (identifier.clone(), Utf8PathBuf::from(path)));
        file.config.test.replace.extend(paths);
        let mut paths = vec![manifest.to_owned()];
        paths.extend(stand_ins::manifests(system, &file)?);
        let workspace = load::load(system, &paths)?;
        let stand_ins = stand_ins::stand_ins(&workspace.db, &file);
        let db = &workspace.db;
        let requested = workspace.projects.iter().find(|project| is_same(project.manifest(db).path(db), manifest));
        let project = requested.copied().map_or_else(|| only_application(&workspace, manifest, None), Ok)?;
        Ok(Self { workspace, project, stand_ins })
    }

    /// The application of a project that was read before.
    pub fn of(workspace: Workspace, project: Project) -> Self {
        Self { workspace, project, stand_ins: Vec::new() }
    }

    /// Reasons why stand-ins cannot replace their libraries; empty if they can.
    pub fn stand_in_faults(&self) -> Vec<StandInFault> {
        stand_ins::faults(self.db(), self.project, &self.stand_ins)
    }

    /// Database with its files.
    pub fn db(&self) -> &Database {
        &self.workspace.db
    }

    /// Database, mutable.
    pub(crate) fn db_mut(&mut self) -> &mut Database {
        &mut self.workspace.db
    }

    /// Project of the application.
    pub fn project(&self) -> Project {
        self.project
    }

    /// Converts the application to its workspace.
    pub fn into_workspace(self) -> Workspace {
        self.workspace
    }

    /// Sets the arm, with precedence over the application's configuration.
    ///
    /// # Errors
    /// If no arm is called `name`.
    pub fn set_arm(&mut self, name: &str) -> Result<(), SessionError> {
        arm::set_arm(&mut self.workspace.db, self.project, name)
    }

    /// Errors with which the controller's compiler rejects the application; empty if it accepts the application.
    pub fn refusals(&self) -> Vec<Diagnostic> {
        val3_check::refusals(self.db(), self.project)
    }

    /// Checks that all files of the application, its loaded projects and its cell were read.
    ///
    /// # Errors
    /// If a file cannot be read.
    pub fn check_readable(&self) -> Result<(), SessionError> {
        readable::check(self.db(), self.project)
    }

    /// Compiles an application without [`refusals`](Self::refusals) to an image.
    ///
    /// # Errors
    /// If it exceeds a limit of the virtual controller.
    pub fn compile(&self) -> Result<Arc<Image>, CompileError> {
        val3_compile::compile(self.db(), self.project).map(Arc::new)
    }

    /// Like [`compile`](Self::compile), with a form of the code.
    ///
    /// # Errors
    /// If it exceeds a limit of the virtual controller.
    pub fn compile_as(&self, form: CodeForm) -> Result<Arc<Image>, CompileError> {
        val3_compile::compile_as(self.db(), self.project, form).map(Arc::new)
    }

    /// Sentences about the folders outside the cell, the lines and the network to which a controller with these
    /// settings has access.
    ///
    /// # Errors
    /// If a setting is invalid.
    pub fn grants(&self, settings: &ControllerSettings) -> Result<Vec<String>, SessionError> {
        grants::notes(self.db(), self.project, settings)
    }

    /// Message about the missing library `io`, and its help. `None` if the application does not use it.
    pub fn missing_io_library(&self) -> Option<(String, String)> {
        io_library::missing(self.db(), self.project)
    }

    /// Profiles in the files of the application's cell, with their rights.
    ///
    /// # Errors
    /// If a file exists but cannot be read.
    pub fn cell_profiles(&self, system: &dyn System) -> Result<Vec<CellProfile>, SessionError> {
        let application = folder(self.db(), self.project);
        let disk = self.project.disk(self.db()).or(application.parent()).unwrap_or(application);
        cell_profiles::read(system, disk)
    }

    /// Opens a controller with `image` in memory and the cell's inputs, outputs, lines and folders. No task runs yet.
    ///
    /// # Errors
    /// If a setting is invalid, if a folder or line cannot be opened, or if memory is insufficient.
    pub fn controller(
        &self,
        settings: &ControllerSettings,
        tape: Tape<'_>,
        image: Arc<Image>,
    ) -> Result<Controller, SessionError> {
        controller::open(self.db(), self.project, &self.stand_ins, settings, tape, image)
    }
}

impl Application {
    /// Replaces the text of a file in `system`, and reads the files that the application references newly. If the
    /// configuration is read again, `arm` is set again.
    pub(crate) fn set_text(&mut self, system: &dyn System, path: &Utf8Path, text: String, arm: Option<&str>) {
        let key = path_key(path.as_str());
        let db = &mut self.workspace.db;
        let file = Sources::get(db).files(db).get(&key).copied();
        if let Some(file) = file.filter(|file| loads_alike(file.text(db), &text)) {
            if **file.text(db) != *text {
                file.set_text(db).to(text.into());
            }
            return;
        }
        let manifest = self.project.manifest(&self.workspace.db).path(&self.workspace.db).clone();
        // Invalid configurations were reported when the application was opened.
        let _ = self.workspace.refresh(system, &[manifest], &|other| other == key);
        if let [project] = self.workspace.projects.as_slice() {
            self.project = *project;
        }
        if let Some(arm) = arm {
            // The arm was valid when the application was opened.
            let _ = self.set_arm(arm);
        }
    }
}

/// The only application of a workspace, or the only application with this program that is no test application.
fn only_application(workspace: &Workspace, path: &Utf8Path, program: Option<&str>) -> Result<Project, SessionError> {
    let (projects, db) = (&workspace.projects, &workspace.db);
    let asked = normalise(path);
    let mut direct = projects.iter().filter(|project| is_same(folder(db, **project), &asked));
    if let (Some(project), None) = (direct.next(), direct.next()) {
        return Ok(*project);
    }
    let has_program = |project: &&Project| program.is_some_and(|name| items(db, **project).programs.contains_key(name));
    let mut starting: Vec<Project> = projects.iter().filter(has_program).copied().collect();
    if starting.len() > 1 {
        // Test applications have the same start program, for use on a controller without `val3 test`.
        starting.retain(|project| !has_tests(db, *project));
    }
    match (projects.as_slice(), starting.as_slice()) {
        ([project], _) | (_, [project]) => Ok(*project),
        (_, several) => {
            let listed = if several.is_empty() { projects } else { several };
            let seen_from_path = |folder: &Utf8Path| folder.strip_prefix(path).unwrap_or(folder).to_string();
            let applications = listed.iter().map(|project| seen_from_path(folder(db, *project))).collect();
            Err(SessionError::Several { path: path.to_owned(), applications })
        }
    }
}
