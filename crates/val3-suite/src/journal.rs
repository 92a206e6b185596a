//! The record of a test that its result keeps: what it has printed, and the last events before its end.

use std::collections::VecDeque;

use val3_machine::event::{Event, EventKind};

use crate::library::{EXPECTATION, FAILURE};

/// The lines of output that a result keeps.
const PRINTS: usize = 100;

/// The events that a result keeps.
const EVENTS: usize = 10;

/// The last lines that `?` has printed, and the last events that explain a failure.
#[derive(Debug, Default)]
pub(crate) struct Journal {
    prints: VecDeque<String>,
    events: VecDeque<Event>,
}

impl Journal {
    pub(crate) fn see(&mut self, event: &Event) {
        match &event.kind {
            EventKind::Print { text } => keep(&mut self.prints, PRINTS, text),
            _ if explains(event) => keep(&mut self.events, EVENTS, event),
            _ => {}
        }
    }

    /// The lines, and the events.
    pub(crate) fn into_parts(self) -> (Vec<String>, Vec<Event>) {
        (self.prints.into(), self.events.into())
    }
}

fn keep<T: Clone>(kept: &mut VecDeque<T>, most: usize, new: &T) {
    if kept.len() == most {
        kept.pop_front();
    }
    kept.push_back(new.clone());
}

/// Whether people look at an event of this kind for the cause of a failure.
///
/// Texts of the screen are shown where they are expected, and moves by their beginnings. A run-time error has its own event.
fn explains(event: &Event) -> bool {
    match &event.kind {
        EventKind::Log { text, .. } => !text.contains(FAILURE) && !text.contains(EXPECTATION),
        EventKind::Move { phase, .. } => matches!(*phase, "started" | "stopped" | "restarted" | "reset" | "error"),
        EventKind::Task { state, .. } => event.task.is_some() && !matches!(*state, "ended" | "error"),
        EventKind::Lib { code, .. } => event.task.is_some() || *code != 0,
        EventKind::Io { .. }
        | EventKind::Sio { .. }
        | EventKind::Popup { .. }
        | EventKind::Error { .. }
        | EventKind::Fault { .. }
        | EventKind::Power { .. }
        | EventKind::Mode { .. } => true,
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use val3_machine::blend_ends::BlendEnds;

    use super::*;

    fn event(t: f64, task: Option<&str>, kind: EventKind) -> Event {
        Event { t, task: task.map(str::to_owned), kind }
    }

    fn io(t: f64) -> Event {
        event(t, None, EventKind::Io { link: "a".to_owned(), value: t })
    }

    #[test]
    fn the_last_lines_and_events_are_kept() {
        let mut journal = Journal::default();
        (0..=PRINTS).for_each(|number| {
            let number = f64::from(u32::try_from(number).unwrap());
            journal.see(&event(number, None, EventKind::Print { text: number.to_string() }));
            journal.see(&io(number));
        });
        let (prints, events) = journal.into_parts();
        assert_eq!((prints.len(), prints[0].as_str(), prints[99].as_str()), (100, "1", "100"));
        assert_eq!(events, (91..=100).map(|number| io(f64::from(number))).collect::<Vec<_>>());
    }

    #[test]
    fn events_that_explain_nothing_are_left_out() {
        let task = |state| EventKind::Task {
            state,
            name: "a".to_owned(),
            program: "b".to_owned(),
            line: 1,
            code: None,
            file: String::new(),
        };
        let moved = |phase| EventKind::Move {
            id: 1.0,
            phase,
            instruction: "movej",
            program: "b".to_owned(),
            line: 1,
            blend: BlendEnds::default(),
        };
        let logged = |text: &str| EventKind::Log { level: "info", text: text.to_owned() };
        for (explaining, other) in [
            (event(0.0, Some("c"), task("created")), event(0.0, None, task("created"))),
            (event(0.0, Some("c"), task("killed")), event(0.0, Some("c"), task("ended"))),
            (event(0.0, None, moved("started")), event(0.0, None, moved("blend"))),
            (event(0.0, None, logged("USR full")), event(0.0, None, logged("USR val3assert failure: 1 instead of 2"))),
        ] {
            assert_eq!((explains(&explaining), explains(&other)), (true, false), "{other:?}");
        }
    }
}
