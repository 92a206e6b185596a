//! Texts sent over serial lines and sockets.

use std::collections::BTreeMap;

use serde::de::Error as _;
use serde::{Deserialize, Deserializer};
use toml::Spanned;
use val3_machine::event::{Event, EventKind};
use val3_machine::script::{LineBytes, SentText};

use super::filled::NOTHING;
use super::fit::{ExpectationFault, Fit};
use crate::failure::Failure;
use crate::source::ExpectationSource;

/// Number of last bytes of a line's output in a failure.
const SHOWN: usize = 200;

/// Deserialises lines with their expected texts.
pub(super) fn texts<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec<Spanned<SentText>>, D::Error> {
    let texts: BTreeMap<Spanned<String>, LineBytes> = Deserialize::deserialize(deserializer)?;
    if texts.is_empty() {
        return Err(D::Error::custom(NOTHING));
    }
    let texts = texts.into_iter().map(|(link, text)| {
        let span = link.span();
        SentText::new(link.into_inner(), text).map(|text| Spanned::new(span, text)).map_err(D::Error::custom)
    });
    texts.collect()
}

/// Unknown links.
pub(super) fn faults(texts: &[Spanned<SentText>], fit: &Fit<'_>) -> Vec<ExpectationFault> {
    texts.iter().filter_map(|text| fit.line(text.get_ref().link(), &text.span())).collect()
}

/// A line with an expected text, and its output.
pub(super) struct Sent {
    expected: Spanned<SentText>,
    output: Vec<u8>,
}

impl Sent {
    pub(super) fn new(expected: &Spanned<SentText>) -> Self {
        Self { expected: expected.clone(), output: Vec::new() }
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

    pub(super) fn failure(&self, source: &ExpectationSource) -> Option<Failure> {
        let text = self.expected.get_ref();
        if text.is_in(&self.output) {
            return None;
        }
        let first = self.output.len().saturating_sub(SHOWN);
        let instead = match self.output.get(first..).unwrap_or_default() {
            [] => "nothing was".to_owned(),
            end => {
                let inside = end.iter().take_while(|byte| is_inside_character(**byte)).count();
                let cut = if first == 0 { 0 } else { inside.min(3) };
                format!("the output ends with {}", LineBytes::from(end.get(cut..).unwrap_or(end)))
            }
        };
        Some(Failure {
            message: format!("it did not happen that {text}: {instead}"),
            places: vec![source.place("expect.sent", self.expected.span())],
        })
    }
}

/// Whether a byte continues a UTF-8 character.
fn is_inside_character(byte: u8) -> bool {
    byte & 0b1100_0000 == 0b1000_0000
}

#[cfg(test)]
mod tests {
    use super::*;

    fn message(pieces: &[(&str, &'static str, &str)]) -> Option<String> {
        let text = SentText::new(r"Socket\host".to_owned(), "one two".into()).unwrap();
        let expected = Spanned::new(0..1, text);
        let mut sent = Sent::new(&expected);
        for (link, dir, bytes) in pieces {
            let (link, bytes) = ((*link).to_owned(), bytes.as_bytes().to_vec());
            sent.see(&[Event { t: 0.0, task: None, at: None, kind: EventKind::Sio { link, dir, bytes } }]);
        }
        sent.failure(&ExpectationSource::default()).map(|failure| failure.message)
    }

    #[test]
    fn a_text_may_be_sent_in_pieces() {
        assert_eq!(message(&[(r"Socket\host", "out", "one "), (r"Socket\HOST", "out", "two")]), None);
        let other = [(r"Socket\host", "in", "one two"), (r"Socket\other", "out", "one two")];
        let expected = "it did not happen that \"one two\" is sent over `Socket\\host`: ";
        assert_eq!(message(&other), Some(format!("{expected}nothing was")));
        let cut = [(r"Socket\host", "out", "one\n")];
        assert_eq!(message(&cut), Some(format!("{expected}the output ends with \"one\\n\"")));
        let long = "ä".repeat(SHOWN) + ".";
        let shown = format!("{expected}the output ends with \"{}.\"", "ä".repeat(SHOWN / 2 - 1));
        assert_eq!(message(&[(r"Socket\host", "out", &long)]), Some(shown));
        let binary = [(r"Socket\host", "out", "A\0\u{7f}")];
        assert_eq!(message(&binary), Some(format!("{expected}the output ends with 41 00 7F")));
    }
}
