//! Texts that a program outputs: printed lines, event log lines, messages.

use std::collections::VecDeque;

use toml::Spanned;
use val3_machine::event::{Event, EventKind};

use crate::failure::Failure;
use crate::source::ExpectationSource;

/// Maximum number of last lines in a failure.
const SHOWN: usize = 5;

/// An output of a program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum OutputKind {
    /// Lines printed by `?`.
    Print,
    /// Lines of the event log.
    Log,
    /// Messages above the page.
    Popup,
}

/// Expected output texts.
pub(super) struct ExpectedOutput {
    kind: OutputKind,
    missing: Vec<Spanned<String>>,
    last: VecDeque<String>,
}

impl OutputKind {
    /// Text that an event writes to the output.
    pub(super) fn text(self, event: &Event) -> Option<&str> {
        match (self, &event.kind) {
            (Self::Print, EventKind::Print { text })
            | (Self::Log, EventKind::Log { text, .. })
            | (Self::Popup, EventKind::Popup { text }) => Some(text),
            _ => None,
        }
    }

    fn key(self) -> &'static str {
        match self {
            Self::Print => "expect.print",
            Self::Log => "expect.log",
            Self::Popup => "expect.popup",
        }
    }

    fn absence(self) -> &'static str {
        match self {
            Self::Print => "no printed line contains",
            Self::Log => "no line of the event log contains",
            Self::Popup => "no message of `popUpMsg` contains",
        }
    }
}

impl ExpectedOutput {
    pub(super) fn new(kind: OutputKind, texts: &[Spanned<String>]) -> Self {
        Self { kind, missing: texts.to_vec(), last: VecDeque::new() }
    }

    pub(super) fn see(&mut self, events: &[Event]) {
        if self.missing.is_empty() {
            return;
        }
        for text in events.iter().filter_map(|event| self.kind.text(event)) {
            self.missing.retain(|missing| !text.contains(missing.get_ref().as_str()));
            if self.last.len() == SHOWN {
                self.last.pop_front();
            }
            self.last.push_back(text.to_owned());
        }
    }

    pub(super) fn failures(&self, source: &ExpectationSource) -> Vec<Failure> {
        let lines: String = self.last.iter().map(|line| format!("\n| {line}")).collect();
        let last = if lines.is_empty() { "there is none".to_owned() } else { format!("the last ones{lines}") };
        let failures = self.missing.iter().map(|text| Failure {
            message: format!("{} {:?}: {last}", self.kind.absence(), text.get_ref()),
            places: vec![source.place(self.kind.key(), text.span())],
        });
        failures.collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_lines_are_shown_for_a_text_that_is_missing() {
        let texts = [Spanned::new(0..1, "b".to_owned()), Spanned::new(1..2, "x".to_owned())];
        let mut output = ExpectedOutput::new(OutputKind::Print, &texts);
        let missing = |output: &ExpectedOutput| -> Vec<String> {
            output.failures(&ExpectationSource::default()).into_iter().map(|failure| failure.message).collect()
        };
        assert_eq!(missing(&output)[0], "no printed line contains \"b\": there is none");
        let print =
            |text: &str| Event { t: 0.0, task: None, at: None, kind: EventKind::Print { text: text.to_owned() } };
        let log = Event { t: 0.0, task: None, at: None, kind: EventKind::Log { level: "info", text: "x".to_owned() } };
        output.see(&[print("abc"), log]);
        (0..SHOWN).for_each(|number| output.see(&[print(&number.to_string())]));
        assert_eq!(missing(&output), ["no printed line contains \"x\": the last ones\n| 0\n| 1\n| 2\n| 3\n| 4"]);
    }
}
