//! Events of a run, stored until the caller removes them.

use std::collections::BTreeMap;

use val3_lang::ports::{Origin, TaskNumber, Time};

use crate::event::{Event, EventKind, seconds};

/// Events of a run that were not taken, and the origin of the next events.
#[derive(Debug, Clone, Default)]
pub(super) struct Record {
    events: Vec<Event>,
    /// Approximate size of the events, in bytes.
    bytes: usize,
    origin: Origin,
    /// Names of tasks.
    names: BTreeMap<TaskNumber, String>,
}

/// Saved events.
#[derive(Debug)]
pub(super) struct Aside {
    events: Vec<Event>,
    bytes: usize,
    origin: Origin,
}

impl Record {
    /// The task, the line and the time of the instruction that is executed.
    pub(super) fn origin(&self) -> Origin {
        self.origin
    }

    pub(super) fn set_origin(&mut self, origin: Origin) {
        self.origin = origin;
    }

    /// Sets the name of a task in events.
    pub(super) fn name(&mut self, task: TaskNumber, name: &str) {
        self.names.insert(task, name.to_owned());
    }

    /// Removes the name of a task that has ended.
    pub(super) fn forget(&mut self, task: TaskNumber) {
        self.names.remove(&task);
    }

    /// Adds an event of the task that runs.
    pub(super) fn push(&mut self, kind: EventKind) {
        let task = self.names.get(&self.origin.task).cloned();
        self.push_event(Event { t: seconds(self.origin.time), task, at: Some(self.origin.at), kind });
    }

    /// Adds an event of no task.
    pub(super) fn push_outside(&mut self, now: Time, kind: EventKind) {
        self.push_event(Event { t: seconds(now), task: None, at: None, kind });
    }

    fn push_event(&mut self, event: Event) {
        let data = if let EventKind::Sio { bytes, .. } = &event.kind { bytes.len() } else { 0 };
        self.bytes += size_of::<Event>() + data;
        self.events.push(event);
    }

    /// Events since the last [`take`](Self::take).
    pub(super) fn pending(&self) -> &[Event] {
        &self.events
    }

    /// Approximate size of the events, in bytes.
    pub(super) fn bytes(&self) -> usize {
        self.bytes
    }

    /// Removes and returns the events and their origin, until [`resume`](Self::resume).
    pub(super) fn set_aside(&mut self) -> Aside {
        let bytes = self.bytes;
        Aside { events: self.take(), bytes, origin: self.origin }
    }

    /// Restores saved events, in place of all later events.
    pub(super) fn resume(&mut self, aside: Aside) {
        (self.events, self.bytes, self.origin) = (aside.events, aside.bytes, aside.origin);
    }

    pub(super) fn take(&mut self) -> Vec<Event> {
        self.bytes = 0;
        std::mem::take(&mut self.events)
    }
}
