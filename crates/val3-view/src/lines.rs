//! Program files, and their lines of code for messages.

use std::collections::BTreeMap;

use rustc_hash::FxHashMap;
use val3_machine::event::{Event, EventKind};

use crate::wire::PageEvent;

/// Reads the text of a program's file; `None` if the file cannot be read.
pub type FileReader = fn(&str) -> Option<String>;

/// Texts of program files, by path. Each file is read once, and again when its application or library is loaded.
#[derive(Debug)]
pub(crate) struct Lines {
    read: FileReader,
    texts: FxHashMap<String, Option<String>>,
    /// Lines that were replaced in memory, by path: the code, by line.
    replaced: FxHashMap<String, BTreeMap<u32, String>>,
    /// Code of the lines that messages have contained.
    known: FxHashMap<(String, u32), Option<String>>,
}

impl Lines {
    pub(crate) fn new(read: FileReader) -> Self {
        Self { read, texts: FxHashMap::default(), replaced: FxHashMap::default(), known: FxHashMap::default() }
    }

    /// Sets the lines of a file that were replaced in memory. Returns whether they differ from the previous ones.
    pub(crate) fn replace(&mut self, file: &str, lines: BTreeMap<u32, String>) -> bool {
        if self.replaced(file).eq(lines.iter()) {
            return false;
        }
        self.known.retain(|(known, _), _| known != file);
        self.replaced.insert(file.to_owned(), lines);
        true
    }

    /// Returns the lines of a file that were replaced in memory.
    pub(crate) fn replaced(&self, file: &str) -> impl Iterator<Item = (&u32, &String)> {
        self.replaced.get(file).into_iter().flatten()
    }

    /// Reads a file again. Returns whether its text differs from the previous one.
    pub(crate) fn reload(&mut self, file: &str) -> bool {
        let text = (self.read)(file);
        if self.texts.get(file) == Some(&text) {
            return false;
        }
        self.known.retain(|(known, _), _| known != file);
        self.texts.insert(file.to_owned(), text);
        true
    }

    /// Returns the text of a file.
    pub(crate) fn text(&mut self, file: &str) -> Option<&str> {
        let read = self.read;
        self.texts.entry(file.to_owned()).or_insert_with(|| read(file)).as_deref()
    }

    /// Returns the code of a line in memory, from 1; `None` if the file cannot be read, or if the line is empty.
    pub(crate) fn code(&mut self, file: &str, line: u32) -> Option<String> {
        let key = (file.to_owned(), line);
        if let Some(known) = self.known.get(&key) {
            return known.clone();
        }
        let replaced = self.replaced.get(file).and_then(|lines| lines.get(&line)).cloned();
        let code = match replaced {
            Some(code) => code_of_line(&code, 1),
            None => self.text(file).and_then(|text| code_of_line(text, line)),
        };
        self.known.insert(key, code.clone());
        code
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

/// Returns the code in a line, from 1, without blanks around it; `None` without code.
#[must_use]
pub fn code_of_line(text: &str, line: u32) -> Option<String> {
    let code = text.lines().nth(usize::try_from(line).ok()?.checked_sub(1)?)?.trim();
    (!code.is_empty()).then(|| code.to_owned())
}
