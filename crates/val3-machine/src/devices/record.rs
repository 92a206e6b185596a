//! The events of a run, until the caller takes them.

use std::collections::BTreeMap;

use val3_lang::ports::{Origin, TaskNumber, Time};

use crate::event::{Event, EventKind, seconds};

/// The events of a run that were not taken, and the origin of the next ones.
#[derive(Debug, Clone, Default)]
pub(super) struct Record {
    events: Vec<Event>,
    /// The size of the events, roughly, in bytes.
    bytes: usize,
    origin: Origin,
    /// The names of tasks.
    names: BTreeMap<TaskNumber, String>,
}

/// Events that were set aside.
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

    /// Gives a task its name in events.
    pub(super) fn name(&mut self, task: TaskNumber, name: &str) {
        self.names.insert(task, name.to_owned());
    }

    /// Forgets the name of a task that is over.
    pub(super) fn forget(&mut self, task: TaskNumber) {
        self.names.remove(&task);
    }

    /// Adds an event of the task that runs.
    pub(super) fn push(&mut self, kind: EventKind) {
        let task = self.names.get(&self.origin.task).cloned();
        self.push_event(Event { t: seconds(self.origin.time), task, kind });
    }

    /// Adds an event of no task.
    pub(super) fn push_outside(&mut self, now: Time, kind: EventKind) {
        self.push_event(Event { t: seconds(now), task: None, kind });
    }

    fn push_event(&mut self, event: Event) {
        let data = if let EventKind::Sio { bytes, .. } = &event.kind { bytes.len() } else { 0 };
        self.bytes += size_of::<Event>() + data;
        self.events.push(event);
    }

    /// The size of the events, roughly, in bytes.
    pub(super) fn bytes(&self) -> usize {
        self.bytes
    }

    /// Takes the events and their origin out, until [`resume`](Self::resume).
    pub(super) fn set_aside(&mut self) -> Aside {
        let bytes = self.bytes;
        Aside { events: self.take(), bytes, origin: self.origin }
    }

    /// Puts back what was set aside, in place of what was recorded since.
    pub(super) fn resume(&mut self, aside: Aside) {
        (self.events, self.bytes, self.origin) = (aside.events, aside.bytes, aside.origin);
    }

    pub(super) fn take(&mut self) -> Vec<Event> {
        self.bytes = 0;
        std::mem::take(&mut self.events)
    }
}
