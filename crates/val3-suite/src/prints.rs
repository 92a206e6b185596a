//! The lines that a test has printed.

use std::collections::VecDeque;

use val3_machine::event::{Event, EventKind};

/// The lines of output that a result keeps.
const KEPT: usize = 100;

/// The last lines that `?` has printed.
#[derive(Debug, Default)]
pub(crate) struct Prints(VecDeque<String>);

impl Prints {
    pub(crate) fn see(&mut self, event: &Event) {
        if let EventKind::Print { text } = &event.kind {
            if self.0.len() == KEPT {
                self.0.pop_front();
            }
            self.0.push_back(text.clone());
        }
    }

    pub(crate) fn into_lines(self) -> Vec<String> {
        self.0.into()
    }
}
