//! Writer of the text form.

use std::sync::Arc;

use val3_lang::memory::ValueType;

use super::forms::{Public, Word};
use crate::{Image, Program};

/// Text so far, and the objects to which its names refer.
pub(super) struct Writer<'i> {
    pub(super) image: &'i Image,
    /// Current program.
    pub(super) code: Option<&'i Program>,
    /// User types in use.
    pub(super) kinds: Vec<Arc<ValueType>>,
    /// Declarations of these types.
    pub(super) types: String,
    /// The program's string constants in the order of first use.
    pub(super) constants: Vec<u16>,
    pub(super) text: String,
}

impl<'i> Writer<'i> {
    pub(super) fn new(image: &'i Image) -> Self {
        let (types, text) = (String::new(), String::new());
        Self { image, code: None, kinds: Vec::new(), types, constants: Vec::new(), text }
    }

    pub(super) fn put(&mut self, text: &str) {
        self.text.push_str(text);
    }

    /// Adds a part, after a space unless the part is empty or continues a word.
    pub(super) fn part(&mut self, write: impl FnOnce(&mut Self)) {
        let part = self.aside(write);
        let is_apart = !part.is_empty() && !part.starts_with(['[', '&']);
        if is_apart && !self.text.is_empty() && !self.text.ends_with(['\n', ' ', '(', '@', '$']) {
            self.put(" ");
        }
        self.put(&part);
    }

    pub(super) fn quoted(&mut self, text: &str) {
        let escaped = text.replace('\\', "\\\\").replace('"', "\\\"").replace('\n', "\\n");
        self.put(&format!("\"{escaped}\""));
    }

    /// Writes a name, quoted if it could be read as something else.
    pub(super) fn name(&mut self, name: &str) {
        let is_plain = name.starts_with(|first: char| first.is_ascii_alphabetic())
            && name.chars().all(|other| other.is_ascii_alphanumeric() || other == '_')
            && name != Public::WORD;
        if is_plain { self.put(name) } else { self.quoted(name) }
    }

    /// Writes an item as its name, or as its number if an earlier item has the same name.
    pub(super) fn item<'n>(&mut self, names: impl IntoIterator<Item = &'n str>, number: usize) {
        let mut names: Vec<&str> = names.into_iter().collect();
        names.truncate(number + 1);
        match names.pop() {
            Some(name) if names.len() == number && !names.contains(&name) => self.name(name),
            _ => self.put(&number.to_string()),
        }
    }

    /// Writes items with a separator.
    pub(super) fn list<T>(
        &mut self,
        items: impl IntoIterator<Item = T>,
        separator: &str,
        mut write: impl FnMut(T, &mut Self),
    ) {
        for (at, item) in items.into_iter().enumerate() {
            if at > 0 {
                self.put(separator);
            }
            write(item, self);
        }
    }

    /// Returns the text that `write` adds, without adding it.
    pub(super) fn aside(&mut self, write: impl FnOnce(&mut Self)) -> String {
        let before = std::mem::take(&mut self.text);
        write(self);
        std::mem::replace(&mut self.text, before)
    }
}
