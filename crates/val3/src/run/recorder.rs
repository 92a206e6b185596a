//! `record` command of pages: scenarios of a served run.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;

use camino::Utf8PathBuf;
use serde_json::{Map, Value};
use val3_lang::ports::Time;
use val3_machine::event::{Event, EventKind, seconds};
use val3_view::wire::{Arguments as _, RecordScenario};

use crate::args::{ControllerArgs, RunArgs};
use crate::paths::current_folder;
use crate::serve::PendingCommand;
use crate::test::{ServedRun, record_served};
use crate::user_error::UserError;

/// Maximum number of recorded events: several hours of a usual cell, about 100 MB.
const MAX_EVENTS: usize = 500_000;

/// Events of a served run, and the scenario that is being written from them.
pub(super) struct ScenarioRecorder {
    application: Utf8PathBuf,
    controller: ControllerArgs,
    events: Vec<Event>,
    /// Whether there were more than `MAX_EVENTS` events.
    is_full: bool,
    /// Whether a thread writes a scenario.
    is_writing: Arc<AtomicBool>,
}

impl ScenarioRecorder {
    /// Records the run with these arguments from its start.
    ///
    /// # Errors
    /// The current folder cannot be read.
    pub(super) fn new(args: &RunArgs) -> Result<Self, UserError> {
        let application = current_folder()?.join(&args.application);
        let controller = args.controller.clone();
        Ok(Self { application, controller, events: Vec::new(), is_full: false, is_writing: Arc::default() })
    }

    /// Discards the events, because the application starts again on a controller with these properties.
    pub(super) fn restart(&mut self, controller: ControllerArgs) {
        self.controller = controller;
        self.events.clear();
        self.is_full = false;
    }

    /// Adds events of a cycle that began at `start`. Later events, from which a debugger has gone back, are discarded.
    pub(super) fn add_events(&mut self, start: Time, events: &[Event]) {
        let start = seconds(start);
        while self.events.pop_if(|event| event.t > start).is_some() {}
        let recorded = events.iter().filter(|event| is_recorded(&event.kind));
        let room = MAX_EVENTS.saturating_sub(self.events.len());
        let before = self.events.len();
        self.events.extend(recorded.clone().take(room).cloned());
        self.is_full |= self.events.len() - before < recorded.count();
    }

    /// Writes the scenario that a command names in a thread, which responds to the command.
    pub(super) fn record(&mut self, command: PendingCommand, now: Time) {
        let name = match RecordScenario::read(&command.message) {
            Ok(RecordScenario { name }) => name,
            Err(error) => return command.answer(Err(error.to_string())),
        };
        if self.is_full {
            let reason = format!(
                "the run has had more than {MAX_EVENTS} events; start it with --events run.jsonl, and use `val3 test --record run.jsonl`"
            );
            return command.answer(Err(reason));
        }
        if self.is_writing.swap(true, Ordering::AcqRel) {
            return command.answer(Err("a scenario is being recorded; wait until it is written".to_owned()));
        }
        let run = ServedRun {
            application: self.application.clone(),
            controller: self.controller.clone(),
            events: self.events.clone(),
            now: seconds(now),
        };
        let is_writing = Arc::clone(&self.is_writing);
        thread::spawn(move || {
            let result = recorded(&run, &name);
            // The next command may follow the answer immediately.
            is_writing.store(false, Ordering::Release);
            command.answer(result);
        });
    }
}

fn recorded(run: &ServedRun, name: &str) -> Result<Map<String, Value>, String> {
    record_served(run, name).map(|recorded| val3_view::response(&recorded)).map_err(|error| error.lines())
}

/// Whether a scenario repeats or expects events of this kind.
fn is_recorded(kind: &EventKind) -> bool {
    match kind {
        EventKind::Task { state, .. } => *state == "created",
        EventKind::Act { .. }
        | EventKind::Sio { .. }
        | EventKind::Line { .. }
        | EventKind::Power { .. }
        | EventKind::Print { .. }
        | EventKind::Log { .. }
        | EventKind::Popup { .. }
        | EventKind::Error { .. }
        | EventKind::Io { .. }
        | EventKind::End { .. } => true,
        _ => false,
    }
}
