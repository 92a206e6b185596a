//! Texts that go out over serial lines and sockets.

use std::collections::BTreeMap;

use serde::de::Error as _;
use serde::{Deserialize, Deserializer};
use toml::Spanned;
use val3_machine::event::{Event, EventKind};
use val3_machine::script::SentText;

use super::fit::{Fault, Fit};
use crate::result::Failure;
use crate::source::Source;

/// The bytes at the end of a line's output that a failure shows.
const SHOWN: usize = 200;

/// Reads lines with the text that each should send.
pub(super) fn texts<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec<Spanned<SentText>>, D::Error> {
    let texts: BTreeMap<Spanned<String>, String> = Deserialize::deserialize(deserializer)?;
    let text = |(link, text): (Spanned<String>, String)| {
        let span = link.span();
        SentText::new(link.into_inner(), text).map(|text| Spanned::new(span, text)).map_err(D::Error::custom)
    };
    texts.into_iter().map(text).collect()
}

/// Links that the application does not have.
pub(super) fn faults(texts: &[Spanned<SentText>], fit: &Fit<'_>) -> Vec<Fault> {
    texts.iter().filter_map(|text| fit.line(text.get_ref().link(), &text.span())).collect()
}

/// A line that should send a text, and its output.
pub(super) struct Sent<'s> {
    expected: &'s Spanned<SentText>,
    output: Vec<u8>,
}

impl<'s> Sent<'s> {
    pub(super) fn new(expected: &'s Spanned<SentText>) -> Self {
        Self { expected, output: Vec::new() }
    }

    pub(super) fn see(&mut self, events: &[Event]) {
        for event in events {
            if let EventKind::Sio { link, dir: "out", bytes } = &event.kind
                && link.eq_ignore_ascii_case(self.expected.get_ref().link())
            {
                self.output.extend(bytes);
            }
        }
    }

    pub(super) fn failure(&self, source: &Source) -> Option<Failure> {
        let text = self.expected.get_ref();
        let end = self.output.get(self.output.len().saturating_sub(SHOWN)..).unwrap_or(&self.output);
        let instead = match end {
            [] => "nothing was".to_owned(),
            _ => format!("the output ends with \"{}\"", end.escape_ascii()),
        };
        let failure = || Failure {
            message: format!("it did not happen that {text}: {instead}"),
            places: vec![source.place("expect.sent", self.expected.span())],
        };
        (!text.is_in(&self.output)).then(failure)
    }
}
