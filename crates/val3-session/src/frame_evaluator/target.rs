//! Evaluation context: the project, the image and the program in which code is evaluated.

use std::sync::Arc;

use camino::Utf8Path;
use rustc_hash::FxHashMap;
use val3_analysis::db::{Database, File, Project, Sources};
use val3_analysis::items::project::program_files;
use val3_analysis::paths::path_key;
use val3_analysis::system::Disk;
use val3_bytecode::{FrameVariable, Image};
use val3_vm::{FragmentContext, InstanceId, Vm};

use super::evaluation::EvaluationError;
use crate::application::Application;

/// Applications in whose stack frames code is evaluated, with a scratch file for each project.
pub(super) struct Targets {
    /// The running application.
    main: Application,
    /// Libraries that it does not reference.
    others: Vec<Application>,
    pub(super) files: FxHashMap<(usize, Project), File>,
    /// Images of projects that are not in memory.
    images: FxHashMap<(usize, Project), Arc<Image>>,
}

/// Evaluation context.
pub(super) struct EvaluationContext {
    /// Index of the application, which contains the database.
    pub(super) application: usize,
    pub(super) project: Project,
    /// Program file, which declares the variables.
    pub(super) program: Option<File>,
    pub(super) image: Arc<Image>,
    /// Variables of the program.
    pub(super) variables: Vec<FrameVariable>,
}

impl Targets {
    pub(super) fn new(application: Application) -> Self {
        Self { main: application, others: Vec::new(), files: FxHashMap::default(), images: FxHashMap::default() }
    }

    /// Replaces the running application. The previous one stays known as long as its programs stop.
    pub(super) fn set_main(&mut self, application: Application) {
        let previous = std::mem::replace(&mut self.main, application);
        self.others = vec![previous];
        self.files.clear();
        self.images.clear();
    }

    /// Application with this index. The fallback is the running application.
    pub(super) fn application(&self, number: usize) -> &Application {
        number.checked_sub(1).and_then(|number| self.others.get(number)).unwrap_or(&self.main)
    }

    /// Like [`application`](Self::application), mutable.
    pub(super) fn application_mut(&mut self, number: usize) -> &mut Application {
        number.checked_sub(1).and_then(|number| self.others.get_mut(number)).unwrap_or(&mut self.main)
    }

    /// File with this path, with its database.
    pub(super) fn source_file(&self, path: &str) -> Option<(&Database, File)> {
        let key = path_key(path);
        let mut databases = self.applications().map(|(_, application)| application.db());
        databases.find_map(|db| Some((db, Sources::get(db).files(db).get(&key).copied()?)))
    }

    fn applications(&self) -> impl Iterator<Item = (usize, &Application)> {
        std::iter::once(&self.main).chain(&self.others).enumerate()
    }

    /// Evaluation context of a fragment context.
    pub(super) fn of_context(
        &mut self,
        vm: &Vm,
        context: FragmentContext,
    ) -> Result<EvaluationContext, EvaluationError> {
        match context {
            FragmentContext::Instance(id) => self.of_program(vm, id, None),
            FragmentContext::Frame(task, depth) => {
                let found = vm.tasks().iter().find(|known| known.id == task);
                let frame = found.and_then(|task| task.thread.frames.iter().rev().nth(depth));
                let frame = frame.ok_or("the stack frame no longer exists")?;
                self.of_program(vm, frame.instance, Some(frame.program))
            }
        }
    }

    /// Evaluation context of a program in a file, which need not be in memory.
    pub(super) fn of_file(&mut self, vm: &Vm, path: &str) -> Result<EvaluationContext, EvaluationError> {
        for (id, instance) in vm.space.loaded() {
            let image = &instance.image;
            if let Some(number) = program_in(image, |file| file == path) {
                return self.of_program(vm, id, Some(number));
            }
        }
        self.of_source(path)
    }

    fn of_program(
        &mut self,
        vm: &Vm,
        id: InstanceId,
        program: Option<u16>,
    ) -> Result<EvaluationContext, EvaluationError> {
        let instance = vm.space.instance(id).filter(|instance| instance.loaded);
        let image = Arc::clone(&instance.ok_or("the library is no longer in memory")?.image);
        let (application, project) = self.project(&image.path)?;
        Ok(self.target(application, project, image, program))
    }

    fn target(
        &self,
        application: usize,
        project: Project,
        image: Arc<Image>,
        number: Option<u16>,
    ) -> EvaluationContext {
        let program = number.and_then(|number| image.programs.get(usize::from(number)));
        let variables = program.map(|program| program.variables.clone()).unwrap_or_default();
        let path = program.and_then(|program| image.files.get(program.file as usize));
        let db = self.application(application).db();
        let program = path.and_then(|path| Sources::get(db).files(db).get(&path_key(path)).copied());
        EvaluationContext { application, project, program, image, variables }
    }

    /// Evaluation context of a program whose application or library is not in memory.
    fn of_source(&mut self, path: &str) -> Result<EvaluationContext, EvaluationError> {
        let found = self.applications().find_map(|(number, application)| {
            let db = application.db();
            let file = *Sources::get(db).files(db).get(&path_key(path))?;
            let projects = Sources::get(db).projects(db).values();
            let project = *projects.into_iter().find(|project| program_files(db, **project).contains(&file))?;
            Some((number, project))
        });
        let (number, project) = found.ok_or("the file holds no program of the application or its libraries")?;
        let db = self.application(number).db();
        let image = match self.images.get(&(number, project)) {
            Some(image) => Arc::clone(image),
            None => Arc::new(val3_compile::compile(db, project).map_err(|error| error.limit.to_string())?),
        };
        self.images.insert((number, project), Arc::clone(&image));
        let program = program_in(&image, |file| path_key(file) == path_key(path));
        Ok(self.target(number, project, image, program))
    }

    /// Project from which an image was compiled. An unreferenced library is read from its files.
    pub(super) fn project(&mut self, path: &str) -> Result<(usize, Project), EvaluationError> {
        let key = path_key(path);
        let known = self.applications().find_map(|(number, application)| {
            let db = application.db();
            Some((number, *Sources::get(db).projects(db).get(&key)?))
        });
        if let Some(known) = known {
            return Ok(known);
        }
        let library = Application::open(&Disk, Utf8Path::new(path), None);
        let library = library.map_err(|_| format!("the files of `{path}` cannot be read"))?;
        let project = library.project();
        self.others.push(library);
        Ok((self.others.len(), project))
    }
}

/// Number of the first program in a matching file.
fn program_in(image: &Image, is_wanted: impl Fn(&str) -> bool) -> Option<u16> {
    let mut programs = image.programs.iter();
    let position =
        programs.position(|program| image.files.get(program.file as usize).is_some_and(|file| is_wanted(file)));
    u16::try_from(position?).ok()
}
