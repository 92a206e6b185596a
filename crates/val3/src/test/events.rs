//! Text of the last events before a failure.

use val3_machine::event::EventKind;
use val3_suite::RepeatedEvent;

/// An event's line: its time, task, description and number of repetitions.
pub(super) fn line(RepeatedEvent { event, count, since }: &RepeatedEvent) -> String {
    let task = event.task.as_ref().map(|task| format!(" (task `{task}`)")).unwrap_or_default();
    let times = if *count > 1 { format!(", {count} times since {since:.3} s") } else { String::new() };
    format!("{:.3} s  {}{task}{times}", event.t, text(&event.kind))
}

fn text(kind: &EventKind) -> String {
    match kind {
        EventKind::Io { link, value } => format!("{link} = {value}"),
        EventKind::Sio { link, dir, bytes } => format!("{link} {dir}: {}", bytes.escape_ascii()),
        EventKind::Log { text, .. } => format!("log: {text}"),
        EventKind::Popup { text } => format!("pop-up: {text}"),
        EventKind::Task { state, name, program, line, .. } => format!("task `{name}` {state} at {program}:{line}"),
        EventKind::Error { code, message, program, line, .. } => format!("error {code}: {message} at {program}:{line}"),
        EventKind::Lib { op, alias, path, code } => format!("library {op} `{alias}` {path}: code {code}"),
        EventKind::Power { on } => format!("power {}", if *on { "on" } else { "off" }),
        EventKind::Mode { mode } => format!("working mode {mode}"),
        EventKind::Move { id, phase, instruction, program, line, .. } => {
            format!("{instruction} {} {phase}, {program}:{line}", id.trunc())
        }
        EventKind::Fault { instruction, text, program, line, .. } => {
            format!("the arm cannot follow the path of {instruction}, {program}:{line}: {text}")
        }
        other => serde_json::to_string(other).unwrap_or_default(),
    }
}

#[cfg(test)]
mod tests {
    use val3_machine::blend_ends::BlendEnds;
    use val3_machine::event::Event;

    use super::*;

    #[test]
    fn events_are_worded_for_people() {
        let line = |task, kind| repeated(task, kind, 1);
        let (program, link) = ("pick".to_owned(), "Socket\\host".to_owned());
        let moved = EventKind::Move {
            id: 4.25,
            phase: "started",
            instruction: "movel",
            program,
            line: 27,
            blend: BlendEnds::default(),
            target: None,
        };
        assert_eq!(line(None, moved), "1.250 s  movel 4 started, pick:27");
        let sent = EventKind::Sio { link, dir: "out", bytes: b"a\r".to_vec() };
        assert_eq!(line(Some("host"), sent), "1.250 s  Socket\\host out: a\\r (task `host`)");
        assert_eq!(line(None, EventKind::Io { link: "valve1".to_owned(), value: 1.0 }), "1.250 s  valve1 = 1");
        let sent = EventKind::Sio { link: "Socket\\a".to_owned(), dir: "in", bytes: b"b".to_vec() };
        let expected = "1.250 s  Socket\\a in: b (task `host`), 300 times since 0.500 s";
        assert_eq!(repeated(Some("host"), sent, 300), expected);
    }

    fn repeated(task: Option<&str>, kind: EventKind, count: u32) -> String {
        let event = Event { t: 1.25, task: task.map(str::to_owned), at: None, kind };
        line(&RepeatedEvent { event, count, since: 0.5 })
    }
}
