//! Actions of the operator while the application runs.

use serde_json::{Map, Value};
use val3_lang::ports::Time;

use super::{Controller, RunPhase};
use crate::event::EventKind;

/// Action of the operator.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OperatorAction {
    /// Taps a key of the pendant.
    Tap(u16),
    /// Shows the next user page.
    NextPage,
    /// Shows the previous user page.
    PreviousPage,
    /// Stops the application.
    Stop,
    /// Removes the application and its libraries from memory, as soon as the application has stopped.
    Unload,
    /// Loads the [prepared project](Controller::prepare_project) with this number and its libraries with their initial
    /// values, as soon as the application has stopped.
    Load(usize),
    /// Starts the application with its present values, as soon as it has stopped.
    Start,
}

impl OperatorAction {
    /// Returns the action as in the record of a run. Scripts have no key for another page, and none for loading,
    /// unloading and starting.
    fn keys(self) -> Map<String, Value> {
        let (key, value): (&str, Value) = match self {
            Self::Tap(code) => ("key", code.into()),
            Self::NextPage => ("userPage", "next".into()),
            Self::PreviousPage => ("userPage", "previous".into()),
            Self::Stop => ("stop", true.into()),
            Self::Unload => ("application", "unload".into()),
            Self::Load(_) => ("application", "load".into()),
            Self::Start => ("application", "start".into()),
        };
        Map::from_iter([(key.to_owned(), value)])
    }

    /// Whether the action waits until the application has stopped.
    const fn awaits_stop(self) -> bool {
        matches!(self, Self::Unload | Self::Load(_) | Self::Start)
    }
}

/// Actions of the operator with the times of the next cycles, so that a restored controller repeats the actions.
#[derive(Debug, Clone, Default)]
pub(super) struct Operations {
    recorded: Vec<(Time, OperatorAction)>,
    /// The number of actions that have taken effect.
    done: usize,
}

impl Operations {
    /// Returns the next action that is due. `has_stopped`: whether the application has stopped.
    fn take_due(&mut self, now: Time, has_stopped: bool) -> Option<OperatorAction> {
        let (_, operation) = self.recorded.get(self.done).filter(|(time, _)| *time <= now)?;
        if operation.awaits_stop() && !has_stopped {
            return None;
        }
        self.done += 1;
        Some(*operation)
    }

    pub(super) fn next_due(&self) -> Option<Time> {
        self.recorded.get(self.done).map(|(time, _)| *time)
    }

    /// Returns the actions that have not taken effect yet.
    pub(super) fn pending(&self) -> impl Iterator<Item = OperatorAction> {
        self.recorded.iter().skip(self.done).map(|(_, operation)| *operation)
    }

    /// Adds an action that takes effect at this time. It replaces the later actions, which only a replay has: they belong
    /// to a future that does not occur.
    fn add(&mut self, time: Time, operation: OperatorAction) {
        let later = self.recorded.iter().skip(self.done).position(|(due, _)| *due > time);
        self.recorded.truncate(later.map_or(self.recorded.len(), |later| self.done + later));
        self.recorded.push((time, operation));
    }

    /// Returns to an earlier position. Later actions take effect again.
    pub(super) fn rewind(&mut self, earlier: &Self) {
        self.done = earlier.done;
    }
}

impl Controller {
    /// Adds an action of the operator before the next cycle.
    pub fn operate(&mut self, operation: OperatorAction) {
        let time = if self.schedule.is_within_cycle() { self.schedule.cycle_end() } else { self.schedule.now };
        self.operations.add(time, operation);
    }

    /// Whether the operator has stopped the application, and the present cycle is the last one before the stop.
    #[must_use]
    pub fn is_about_to_stop(&self) -> bool {
        let end = self.schedule.cycle_end();
        let mut due = self.operations.recorded.iter().skip(self.operations.done).take_while(|(time, _)| *time <= end);
        self.phase == RunPhase::Running && due.any(|(_, operation)| *operation == OperatorAction::Stop)
    }

    pub(super) fn follow_operator(&mut self, now: Time) {
        while let Some(operation) = self.operations.take_due(now, self.has_stopped()) {
            let mut keys = operation.keys();
            if let OperatorAction::Load(number) = operation
                && let Some(project) = self.prepared.get(number)
            {
                keys.insert("project".to_owned(), project.path.clone().into());
            }
            self.devices.record_outside(now, EventKind::Act { keys });
            let pendant = &mut self.devices.state.pendant;
            match operation {
                OperatorAction::Tap(code) => pendant.tap(code, now),
                OperatorAction::NextPage => pendant.show_next(),
                OperatorAction::PreviousPage => pendant.show_previous(),
                OperatorAction::Stop => self.stop(),
                OperatorAction::Unload => self.vm.space.unload_application(),
                OperatorAction::Load(number) => self.load_application(number),
                OperatorAction::Start => self.start_application(now),
            }
        }
    }
}
