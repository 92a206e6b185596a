//! Texts that go out over serial lines and sockets.

use std::collections::BTreeMap;
use std::fmt;

use serde::Deserialize;
use toml::Spanned;
use val3_machine::event::{Event, EventKind};

use super::fit::{Fault, Fit};
use crate::result::Failure;
use crate::source::Source;

/// The key of these expectations.
const KEY: &str = "expect.sent";

/// The bytes at the end of a line's output that a failure shows.
const SHOWN: usize = 200;

/// A line with the text that it should send, as a table with one key.
#[derive(Debug, Clone, Deserialize)]
#[serde(try_from = "BTreeMap<String, String>")]
pub(super) struct SentText {
    link: String,
    text: String,
}

impl TryFrom<BTreeMap<String, String>> for SentText {
    type Error = &'static str;

    fn try_from(mut table: BTreeMap<String, String>) -> Result<Self, Self::Error> {
        match (table.pop_first(), table.is_empty()) {
            (Some((link, text)), true) => Ok(Self { link, text }),
            _ => Err("write one line and its text, such as { \"Socket\\\\host\" = \"ready\" }"),
        }
    }
}

impl SentText {
    pub(super) fn link(&self) -> &str {
        &self.link
    }

    /// Whether one instruction has sent the text.
    pub(super) fn is_sent_by(&self, event: &Event) -> bool {
        output(event).is_some_and(|(link, bytes)| link == self.link && contains(bytes, &self.text))
    }
}

impl fmt::Display for SentText {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:?} is sent over `{}`", self.text, self.link)
    }
}

/// The texts that lines should send, as the file has them.
pub(super) type SentTexts = BTreeMap<Spanned<String>, String>;

/// Links that the application does not have.
pub(super) fn faults(texts: &SentTexts, fit: &Fit<'_>) -> Vec<Fault> {
    texts.keys().filter_map(|link| fit.line(link.get_ref(), &link.span())).collect()
}

/// The output of the lines that should send something.
pub(super) struct Sent<'s> {
    expected: &'s SentTexts,
    output: BTreeMap<&'s str, Vec<u8>>,
}

impl<'s> Sent<'s> {
    pub(super) fn new(expected: &'s SentTexts) -> Self {
        let output = expected.keys().map(|link| (link.get_ref().as_str(), Vec::new()));
        Self { expected, output: output.collect() }
    }

    pub(super) fn see(&mut self, events: &[Event]) {
        for (link, bytes) in events.iter().filter_map(output) {
            if let Some(output) = self.output.get_mut(link) {
                output.extend(bytes);
            }
        }
    }

    pub(super) fn failures(&self, source: &Source) -> Vec<Failure> {
        let failure = |(link, text): (&Spanned<String>, &String)| {
            let output = self.output.get(link.get_ref().as_str()).map(Vec::as_slice).unwrap_or_default();
            let message = format!("{text:?} was not sent over `{}`: {}", link.get_ref(), described(output));
            let places = vec![source.place(KEY, link.span())];
            (!contains(output, text)).then_some(Failure { message, places })
        };
        self.expected.iter().filter_map(failure).collect()
    }
}

/// The bytes that an event sends, with their line.
fn output(event: &Event) -> Option<(&str, &[u8])> {
    match &event.kind {
        EventKind::Sio { link, dir: "out", bytes } => Some((link, bytes)),
        _ => None,
    }
}

fn contains(bytes: &[u8], text: &str) -> bool {
    text.is_empty() || bytes.windows(text.len()).any(|part| part == text.as_bytes())
}

fn described(output: &[u8]) -> String {
    let end = output.get(output.len().saturating_sub(SHOWN)..).unwrap_or(output);
    match end {
        [] => "nothing was".to_owned(),
        _ => format!("\"{}\" was", end.escape_ascii()),
    }
}
