//! The text that grows while an image is written.

use std::sync::Arc;

use val3_lang::memory::Kind;

use super::forms::{Public, Word};
use crate::{Image, Program};

/// The text so far, and what names in it refer to.
pub(super) struct Writer<'i> {
    pub(super) image: &'i Image,
    /// The program that is written.
    pub(super) code: Option<&'i Program>,
    /// The user types that were needed so far.
    pub(super) kinds: Vec<Arc<Kind>>,
    /// The declarations of these types.
    pub(super) types: String,
    /// The text constants of the program in the order of their first use.
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

    /// Adds a text with a blank before it, unless it is empty or continues a word.
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

    /// A name, quoted if it could be read as something else.
    pub(super) fn name(&mut self, name: &str) {
        let is_plain = name.starts_with(|first: char| first.is_ascii_alphabetic())
            && name.chars().all(|other| other.is_ascii_alphanumeric() || other == '_')
            && name != Public::WORD;
        if is_plain { self.put(name) } else { self.quoted(name) }
    }

    /// An item by its name, or by its number if another item has the same name.
    pub(super) fn item<'n>(&mut self, names: impl IntoIterator<Item = &'n str>, number: usize) {
        let mut names: Vec<&str> = names.into_iter().collect();
        names.truncate(number + 1);
        match names.pop() {
            Some(name) if names.len() == number && !names.contains(&name) => self.name(name),
            _ => self.put(&number.to_string()),
        }
    }

    /// Items with a separator between them.
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

    /// The text that `write` adds, apart from the text so far.
    pub(super) fn aside(&mut self, write: impl FnOnce(&mut Self)) -> String {
        let before = std::mem::take(&mut self.text);
        write(self);
        std::mem::replace(&mut self.text, before)
    }
}
