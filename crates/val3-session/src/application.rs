//! An opened application: its refusals, its image, its controller.

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
use val3_compile::CompileError;
use val3_machine::controller::Controller;

use crate::connection::Tape;
use crate::error::SessionError;
use crate::settings::ControllerSettings;
use crate::stand_ins::{self, StandIn, StandInFault};
use crate::{arm, controller, grants, io_library, readable};

/// An application with everything that it refers to.
pub struct Application {
    workspace: Workspace,
    project: Project,
    /// The libraries that are loaded in place of others.
    stand_ins: Vec<StandIn>,
}

impl Application {
    /// Reads the application at `path`, which is absolute: its `.pjx`, its folder, whatever lies below it, or a folder
    /// that holds one application. Of several applications, the only one without tests that has the program `program` is
    /// meant. The others are not kept.
    ///
    /// # Errors
    /// `path` does not hold exactly one such application, or a `val3.toml` is at fault.
    pub fn open(system: &dyn System, path: &Utf8Path, program: Option<&str>) -> Result<Self, SessionError> {
        let workspace = load::load(system, &[path.to_owned()])?;
        let project = only_application(&workspace, path, program)?;
        if workspace.projects.len() > 1 {
            let manifest = project.manifest(&workspace.db).path(&workspace.db).clone();
            return Self::open(system, &manifest, None);
        }
        Ok(Self::of(workspace, project))
    }

    /// Reads the application with this project file, and the stand-ins of its `val3.toml`. They are loaded in place of
    /// libraries on its controller. `others` are further ones, by identifier with absolute paths, which take precedence.
    ///
    /// # Errors
    /// There is no such application, the path of a stand-in leads to no library, or a `val3.toml` is at fault.
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
        let is_asked = |project: &&Project| is_same(project.manifest(&workspace.db).path(&workspace.db), manifest);
        let project = workspace.projects.iter().find(is_asked).copied();
        let project = project.map_or_else(|| only_application(&workspace, manifest, None), Ok)?;
        Ok(Self { workspace, project, stand_ins })
    }

    /// The application of a project that has been read.
    pub fn of(workspace: Workspace, project: Project) -> Self {
        Self { workspace, project, stand_ins: Vec::new() }
    }

    /// The reasons why stand-ins cannot take the places of the libraries; empty if they can.
    pub fn stand_in_faults(&self) -> Vec<StandInFault> {
        stand_ins::faults(self.db(), self.project, &self.stand_ins)
    }

    /// The database with its files.
    pub fn db(&self) -> &Database {
        &self.workspace.db
    }

    /// The database, to be changed.
    pub(crate) fn db_mut(&mut self) -> &mut Database {
        &mut self.workspace.db
    }

    /// The project of the application.
    pub fn project(&self) -> Project {
        self.project
    }

    /// All that was read.
    pub fn into_workspace(self) -> Workspace {
        self.workspace
    }

    /// Chooses the arm, whatever the configuration of the application says.
    ///
    /// # Errors
    /// There is no arm called `name`.
    pub fn set_arm(&mut self, name: &str) -> Result<(), SessionError> {
        arm::set_arm(&mut self.workspace.db, self.project, name)
    }

    /// The reasons why the compiler of a controller refuses the application; empty if it does not.
    pub fn refusals(&self) -> Vec<Diagnostic> {
        val3_check::refusals(self.db(), self.project)
    }

    /// Checks that every file of the application, of the projects that it loads, and of its cell was read.
    ///
    /// # Errors
    /// A file cannot be read.
    pub fn check_readable(&self) -> Result<(), SessionError> {
        readable::check(self.db(), self.project)
    }

    /// The image of an application without [`refusals`](Self::refusals).
    ///
    /// # Errors
    /// It exceeds a limit of the virtual controller.
    pub fn compile(&self) -> Result<Arc<Image>, CompileError> {
        val3_compile::compile(self.db(), self.project).map(Arc::new)
    }

    /// As [`compile`](Self::compile). The image counts how often its lines and branches are executed.
    ///
    /// # Errors
    /// It exceeds a limit of the virtual controller.
    pub fn compile_counted(&self) -> Result<Arc<Image>, CompileError> {
        val3_compile::compile_counted(self.db(), self.project).map(Arc::new)
    }

    /// Sentences on the folders outside of the cell, the lines and the network that a controller with these settings is
    /// given.
    ///
    /// # Errors
    /// A setting is at fault.
    pub fn grants(&self, settings: &ControllerSettings) -> Result<Vec<String>, SessionError> {
        grants::notes(self.db(), self.project, settings)
    }

    /// A sentence on the missing library `io`, and the remedy. `None` if the application needs none.
    pub fn missing_io_library(&self) -> Option<(String, String)> {
        io_library::missing(self.db(), self.project)
    }

    /// A controller with `image` in memory and the inputs, outputs, lines and folders of its cell. No task runs yet.
    ///
    /// # Errors
    /// A setting is at fault, a folder or line cannot be opened, or memory does not suffice.
    pub fn controller(
        &self,
        settings: &ControllerSettings,
        tape: Tape<'_>,
        image: Arc<Image>,
    ) -> Result<Controller, SessionError> {
        controller::open(self.db(), (self.project, &self.stand_ins), settings, tape, image)
    }
}

impl Application {
    /// Replaces the text of a file in `system`, and reads what the application newly refers to. `arm` is chosen again
    /// where the configuration was read again.
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
        // Faulty configurations were reported when the application was opened.
        let _ = self.workspace.refresh(system, &[manifest], &|other| other == key);
        if let [project] = self.workspace.projects.as_slice() {
            self.project = *project;
        }
        if let Some(arm) = arm {
            // The arm was known when the application was opened.
            let _ = self.set_arm(arm);
        }
    }
}

/// The only application of a workspace, or the only one with a program of this name that is no test application.
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
        // Test applications begin with the same program, but on a controller without `val3 test`.
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
