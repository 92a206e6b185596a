//! Text below the user page.

use std::collections::VecDeque;

use val3_lang::runtime_errors;
use val3_machine::event::{Event, EventKind};

/// Maximum number of stored lines, similar to the history of a terminal.
const KEPT: usize = 1000;

/// Last lines printed by `?`, and last messages and errors.
#[derive(Debug, Default)]
pub(super) struct Journal {
    lines: VecDeque<String>,
}

impl Journal {
    /// Records an event's text, if it is relevant for the user.
    pub(super) fn record_event(&mut self, event: &Event) {
        if let Some(line) = line(event) {
            self.lines.extend(line.lines().map(str::to_owned));
            self.lines.drain(..self.lines.len().saturating_sub(KEPT));
        }
    }

    /// Last lines, at most `count`.
    pub(super) fn last(&self, count: usize) -> impl Iterator<Item = &str> {
        self.lines.iter().skip(self.lines.len().saturating_sub(count)).map(String::as_str)
    }

    /// Removes and returns all stored lines.
    pub(super) fn take(&mut self) -> Vec<String> {
        std::mem::take(&mut self.lines).into()
    }
}

fn line(event: &Event) -> Option<String> {
    match &event.kind {
        EventKind::Print { text } => Some(text.clone()),
        EventKind::Notice { text } => Some(format!("note: {text}")),
        EventKind::Log { text, .. } => Some(format!("log: {text}")),
        EventKind::Popup { text } => Some(format!("pop-up: {text}")),
        EventKind::Error { code, file, line, .. } => {
            let short = runtime_errors::find(*code).map_or("unknown run-time error", |error| error.short);
            let task = event.task.as_deref().unwrap_or_default();
            Some(format!("{file}:{line}: run-time error {code}: {short} (task `{task}`)"))
        }
        EventKind::Fault { instruction, text, file, line, .. } => {
            Some(format!("{file}:{line}: the arm cannot follow the path of this {instruction}: {text}"))
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn print(text: &str) -> Event {
        Event { t: 0.0, task: None, at: None, kind: EventKind::Print { text: text.to_owned() } }
    }

    #[test]
    fn the_last_lines_are_kept() {
        let mut journal = Journal::default();
        (0..=KEPT).for_each(|number| journal.record_event(&print(&number.to_string())));
        assert_eq!(journal.last(2).collect::<Vec<_>>(), ["999", "1000"]);
        assert_eq!(journal.last(5000).next(), Some("1"));
        assert_eq!(journal.take().len(), KEPT);
    }

    #[test]
    fn other_events_are_not_shown() {
        let mut journal = Journal::default();
        journal.record_event(&Event { t: 0.0, task: None, at: None, kind: EventKind::Power { on: true } });
        assert!(journal.take().is_empty());
    }
}
