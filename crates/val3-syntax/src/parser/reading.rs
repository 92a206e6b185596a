//! Repeated parsing of the same tokens in different modes, and selection of the best result.

use super::{Matching, ParseEvent, Parser};
use crate::error::SyntaxError;

/// Result of parsing some tokens.
struct ParseAttempt {
    events: Vec<ParseEvent>,
    errors: Vec<SyntaxError>,
}

/// State of the parser before an attempt: the token, and the numbers of events and errors.
#[derive(Clone, Copy)]
struct ReadingStart {
    position: usize,
    events: usize,
    errors: usize,
}

impl Parser<'_> {
    /// Runs `read`, which parses the code at the cursor to its end. If blocks do not match, further modes are tried:
    /// the result with the fewest errors is kept; for equal numbers, the result by indentation.
    pub(crate) fn best_reading(&mut self, read: impl Fn(&mut Self)) {
        let start = ReadingStart { position: self.position(), events: self.events.len(), errors: self.errors.len() };
        read(self);
        if !self.errors.iter().skip(start.errors).any(|error| error.kind.is_about_blocks()) {
            return;
        }
        let plain = self.take_reading(start);
        let guided = self.read_by(Matching::Guided, start, &read);
        let mut best = if guided.errors.len() <= plain.errors.len() { guided } else { plain };
        if best.errors.len() > 1 {
            let strict = self.read_by(Matching::Strict, start, &read);
            best = if strict.errors.len() < best.errors.len() { strict } else { best };
        }
        self.events.append(&mut best.events);
        self.errors.append(&mut best.errors);
    }

    fn read_by(&mut self, matching: Matching, start: ReadingStart, read: impl Fn(&mut Self)) -> ParseAttempt {
        let end = self.pos;
        self.pos = start.position;
        self.matching = matching;
        read(self);
        self.matching = Matching::Plain;
        debug_assert_eq!(self.pos, end, "every way reads all of the code");
        self.take_reading(start)
    }

    fn take_reading(&mut self, start: ReadingStart) -> ParseAttempt {
        ParseAttempt { events: self.events.split_off(start.events), errors: self.errors.split_off(start.errors) }
    }
}
