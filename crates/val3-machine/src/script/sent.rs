//! Text, or other bytes, that a task sends over a serial line or socket.

use std::collections::BTreeMap;
use std::fmt;

use serde::Deserialize;

use super::bytes::LineBytes;
use crate::event::{Event, EventKind};

/// Line with a text that it sends, as a table with one key.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(try_from = "BTreeMap<String, LineBytes>")]
pub struct SentText {
    link: String,
    text: LineBytes,
}

impl TryFrom<BTreeMap<String, LineBytes>> for SentText {
    type Error = &'static str;

    fn try_from(mut table: BTreeMap<String, LineBytes>) -> Result<Self, Self::Error> {
        match (table.pop_first(), table.is_empty()) {
            (Some((link, text)), true) => Self::new(link, text),
            _ => Err("write one line and its text, such as { \"Socket\\\\host\" = \"ready\" }"),
        }
    }
}

impl SentText {
    /// Creates the condition that the line with this link sends a text.
    ///
    /// # Errors
    /// The text is empty.
    pub fn new(link: String, text: LineBytes) -> Result<Self, &'static str> {
        if text.as_slice().is_empty() { Err("the text that is sent cannot be empty") } else { Ok(Self { link, text }) }
    }

    /// The link of the line.
    #[must_use]
    pub fn link(&self) -> &str {
        &self.link
    }

    /// Whether these bytes of the line contain the text.
    #[must_use]
    pub fn is_in(&self, bytes: &[u8]) -> bool {
        let text = self.text.as_slice();
        bytes.windows(text.len()).any(|part| part == text)
    }

    /// Whether the event's instruction has sent the text.
    #[must_use]
    pub fn is_sent_by(&self, event: &Event) -> bool {
        match &event.kind {
            EventKind::Sio { link, dir: "out", bytes } => link.eq_ignore_ascii_case(&self.link) && self.is_in(bytes),
            _ => false,
        }
    }
}

/// Clause of a sentence.
impl fmt::Display for SentText {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} is sent over `{}`", self.text, self.link)
    }
}
