//! Code of program lines in messages.

use rustc_hash::FxHashMap;
use val3_machine::event::{Event, EventKind};

use crate::wire::PageEvent;

/// Reads the code of a line of a program's file, from 1; `None` if the file or the line cannot be read.
pub type LineReader = fn(&str, u32) -> Option<String>;

/// Code of lines. Each line is read once.
#[derive(Debug)]
pub(crate) struct Lines {
    read: LineReader,
    known: FxHashMap<(String, u32), Option<String>>,
}

impl Lines {
    pub(crate) fn new(read: LineReader) -> Self {
        Self { read, known: FxHashMap::default() }
    }

    pub(crate) fn code(&mut self, file: &str, line: u32) -> Option<String> {
        let read = self.read;
        self.known.entry((file.to_owned(), line)).or_insert_with(|| read(file, line)).clone()
    }

    /// Adds the code of the line to the event of a fault.
    pub(crate) fn with_code(&mut self, event: &Event) -> PageEvent {
        let line_code = match &event.kind {
            EventKind::Error { file, line, .. }
            | EventKind::Fault { file, line, .. }
            | EventKind::Lacking { file, line, .. } => self.code(file, *line),
            _ => None,
        };
        PageEvent { event: event.clone(), line_code }
    }
}
