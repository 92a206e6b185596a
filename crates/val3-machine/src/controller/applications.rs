//! Loading, starting and unloading of applications after the present one has stopped, by a client or the operator.

use std::fmt;
use std::sync::Arc;

use val3_bytecode::Image;
use val3_lang::fault::Fault;
use val3_lang::ports::{MotionPort as _, Ports as _, Time};
use val3_lang::runtime_errors;
use val3_vm::Host as _;

use super::operator::OperatorAction;
use super::{Controller, NotStarted, RunPhase};
use crate::controller_state::MessageSeverity;
use crate::files::LibraryFiles;
use crate::screen::HtmlPage;

/// Program that starts an application.
const START: &str = "start";

/// Project that was read and compiled, before it is loaded into memory.
#[derive(Debug, Clone)]
pub struct PreparedProject {
    /// Image.
    pub image: Arc<Image>,
    /// Path on the media, such as `Disk://app`.
    pub path: String,
    /// Files from which the image was compiled.
    pub files: Arc<LibraryFiles>,
    /// HTML user pages.
    pub pages: Vec<HtmlPage>,
}

/// State of the application.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ApplicationState {
    /// The application is not in memory.
    Unloaded,
    /// The application is in memory and has stopped, or is stopping.
    Stopped,
    /// The application runs.
    Started,
}

impl fmt::Display for NotStarted {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoProgram => f.write_str("it has no such program"),
            Self::HasParameters => f.write_str("the program has parameters"),
            Self::Fault(Fault(code)) => {
                write!(f, "error {code}: {}", runtime_errors::find(*code).map_or("unknown", |error| error.short))
            }
        }
    }
}

impl Controller {
    /// Whether no task of the application exists, and its program `stop` has ended.
    pub(super) fn has_stopped(&self) -> bool {
        self.phase == RunPhase::Stopped
    }

    /// State of the application after all pending actions of the operator ([`operate`](Self::operate)).
    #[must_use]
    pub fn application_state(&self) -> ApplicationState {
        use ApplicationState::{Started, Stopped, Unloaded};
        let is_loaded = self.vm.space.instance(self.application).is_some_and(|instance| instance.loaded);
        let present = match self.phase {
            _ if !is_loaded => Unloaded,
            RunPhase::Running => Started,
            RunPhase::Stopping | RunPhase::Stopped => Stopped,
        };
        self.operations.pending().fold(present, |state, action| match (action, state) {
            (OperatorAction::Unload, _) => Unloaded,
            (OperatorAction::Stop, Started) | (OperatorAction::Load(_), Unloaded) => Stopped,
            (OperatorAction::Start, Stopped) => Started,
            (_, state) => state,
        })
    }

    /// Adds a project that [`OperatorAction::Load`] loads. Returns its number.
    pub fn prepare_project(&mut self, project: PreparedProject) -> usize {
        self.prepared.push(project);
        self.prepared.len() - 1
    }

    /// Path and image of the application after all pending actions of the operator. An application that was removed from
    /// memory remains until another one is loaded.
    #[must_use]
    pub fn next_application(&self) -> (&str, Option<&Image>) {
        let pending = self.operations.pending().filter_map(|action| match action {
            OperatorAction::Load(number) => self.prepared.get(number),
            _ => None,
        });
        match (pending.last(), self.vm.space.instance(self.application)) {
            (Some(project), _) => (&project.path, Some(&project.image)),
            (None, Some(instance)) => (&instance.path, Some(&instance.image)),
            (None, None) => ("", None),
        }
    }

    /// Loads a prepared project and its libraries with their initial values, unless an application is in memory.
    pub(super) fn load_application(&mut self, number: usize) {
        let is_free = self.vm.space.instance(self.application).is_some_and(|instance| !instance.loaded);
        let Some(PreparedProject { image, path, files, pages }) =
            self.prepared.get(number).filter(|_| is_free).cloned()
        else {
            return;
        };
        self.devices.origin(self.outside());
        match self.vm.space.load(image, path.clone(), &mut self.devices) {
            Ok(loaded) => {
                self.application = loaded;
                self.devices.state.pendant.set_html_pages(pages);
                self.devices.keep_loaded_files(loaded, Some(files));
                self.vm.space.load_with(loaded, &mut self.devices);
            }
            Err(_) => self.devices.no_memory_for(&path),
        }
        // The application starts only when everything is in memory.
        self.devices.take_elapsed();
    }

    /// Starts the application with its present values.
    pub(super) fn start_application(&mut self, now: Time) {
        if !self.vm.space.instance(self.application).is_some_and(|instance| instance.loaded) {
            return;
        }
        (self.phase, self.stopped) = (RunPhase::Running, false);
        if let Err(reason) = self.start(START) {
            self.phase = RunPhase::Stopped;
            let text = format!("the application cannot be started: {reason}");
            self.devices.report(&text, MessageSeverity::Error, now);
        }
    }

    /// Discards all moves, as the program of a task could do.
    pub fn discard_moves(&mut self) {
        self.devices.origin(self.outside());
        self.devices.reset_motion(None);
    }
}
