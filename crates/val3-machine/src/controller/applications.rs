//! Loading, starting and unloading of the application after it has stopped, by a client or the operator.

use std::fmt;
use std::sync::Arc;

use val3_lang::fault::Fault;
use val3_lang::ports::{MotionPort as _, Ports as _, Time};
use val3_lang::runtime_errors;
use val3_vm::Host as _;

use super::operator::OperatorAction;
use super::{Controller, NotStarted, RunPhase};
use crate::controller_state::MessageSeverity;

/// Program that starts an application.
const START: &str = "start";

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
            (OperatorAction::Stop, Started) | (OperatorAction::Load, Unloaded) => Stopped,
            (OperatorAction::Start, Stopped) => Started,
            (_, state) => state,
        })
    }

    /// Loads the application and its libraries with their initial values.
    pub(super) fn load_application(&mut self) {
        let Some(instance) = self.vm.space.instance(self.application).filter(|instance| !instance.loaded) else {
            return;
        };
        let (image, path) = (Arc::clone(&instance.image), instance.path.clone());
        // The files may have changed since the image was compiled.
        let files = self.devices.loaded_files(self.application);
        self.devices.origin(self.outside());
        match self.vm.space.load(image, path.clone(), &mut self.devices) {
            Ok(loaded) => {
                self.devices.keep_loaded_files(loaded, files);
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
