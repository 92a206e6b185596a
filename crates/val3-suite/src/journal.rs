//! Part of a test's event record in its result: printed lines, and the last events before its end.

use std::collections::VecDeque;

use val3_machine::event::{Event, EventKind};

use crate::library::{EXPECTATION, FAILURE, KNOWN_FAILURE, SKIP};

/// Maximum number of printed lines in a result.
const PRINTS: usize = 100;

/// Maximum number of events in a result.
const EVENTS: usize = 100;

/// Maximum number of similar events in a result, for example blocks of a stream over one line.
const ALIKE: usize = 3;

/// An event that represents earlier equal or similar events.
#[derive(Debug, Clone, PartialEq)]
pub struct RepeatedEvent {
    /// Last event.
    pub event: Event,
    /// Number of events.
    pub count: u32,
    /// Time of the first event, in seconds on the controller's clock.
    pub since: f64,
}

/// Last lines printed by `?`, and last events that explain a failure.
#[derive(Debug, Default)]
pub(crate) struct Journal {
    prints: VecDeque<String>,
    events: VecDeque<RepeatedEvent>,
}

impl Journal {
    pub(crate) fn see(&mut self, event: &Event) {
        match &event.kind {
            EventKind::Print { text } => keep(&mut self.prints, PRINTS, text),
            _ if explains(event) => self.note(event),
            _ => {}
        }
    }

    /// Records an event as the last event. It replaces an equal event. If there are many similar events, the oldest
    /// ones are merged.
    fn note(&mut self, event: &Event) {
        let mut events = self.events.iter().map(|known| &known.event);
        let equal = events.position(|known| known.task == event.task && known.kind == event.kind);
        let equal = equal.and_then(|at| self.events.remove(at));
        let (count, since) = equal.map_or((0, event.t), |known| (known.count, known.since));
        keep(&mut self.events, EVENTS, &RepeatedEvent { event: event.clone(), count: count.saturating_add(1), since });
        let alike: Vec<usize> =
            (0..).zip(&self.events).filter(|(_, known)| is_alike(&known.event, event)).map(|(at, _)| at).collect();
        let [oldest, next, ..] = alike.as_slice() else { return };
        if alike.len() > ALIKE
            && let Some(RepeatedEvent { count, since, .. }) = self.events.remove(*oldest)
            && let Some(next) = self.events.get_mut(next - 1)
        {
            (next.count, next.since) = (next.count.saturating_add(count), since.min(next.since));
        }
    }

    /// Printed lines and events.
    pub(crate) fn into_parts(self) -> (Vec<String>, Vec<RepeatedEvent>) {
        (self.prints.into(), self.events.into())
    }
}

fn keep<T: Clone>(kept: &mut VecDeque<T>, most: usize, new: &T) {
    if kept.len() == most {
        kept.pop_front();
    }
    kept.push_back(new.clone());
}

/// Whether two events have the same kind and origin: bytes over one line in one direction, or phases of moves from one
/// line of code.
fn is_alike(one: &Event, other: &Event) -> bool {
    match (&one.kind, &other.kind) {
        (EventKind::Sio { link: a, dir: b, .. }, EventKind::Sio { link: c, dir: d, .. }) => (a, b) == (c, d),
        (
            EventKind::Move { phase: a, program: b, line: c, .. },
            EventKind::Move { phase: d, program: e, line: f, .. },
        ) => (a, b, c) == (d, e, f),
        _ => false,
    }
}

/// Whether an event of this kind helps to explain a failure.
///
/// Texts of the screen are shown by expectations, and moves by their start. A run-time error has its own event.
fn explains(event: &Event) -> bool {
    match &event.kind {
        EventKind::Log { text, .. } => {
            ![FAILURE, EXPECTATION, SKIP, KNOWN_FAILURE].iter().any(|start| text.contains(start))
        }
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
        Event { t, task: task.map(str::to_owned), at: None, kind }
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
        let events: Vec<Event> = events.into_iter().map(|repeated| repeated.event).collect();
        assert_eq!(events, (1..=100).map(|number| io(f64::from(number))).collect::<Vec<_>>());
    }

    #[test]
    fn a_repeated_event_is_kept_once() {
        let mut journal = Journal::default();
        let sent = |t, byte| {
            event(t, Some("a"), EventKind::Sio { link: "Socket\\b".to_owned(), dir: "out", bytes: vec![byte] })
        };
        for number in 0..50_u8 {
            journal.see(&sent(f64::from(number), number));
            journal.see(&event(0.5, None, EventKind::Io { link: "a".to_owned(), value: f64::from(number % 2) }));
        }
        let (_, events) = journal.into_parts();
        let kept: Vec<(f64, u32, f64)> = events.iter().map(|kept| (kept.since, kept.count, kept.event.t)).collect();
        assert_eq!(kept, [(0.0, 48, 47.0), (48.0, 1, 48.0), (0.5, 25, 0.5), (49.0, 1, 49.0), (0.5, 25, 0.5)]);
        assert_eq!(events[3].event, sent(49.0, 49));
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
            target: None,
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
