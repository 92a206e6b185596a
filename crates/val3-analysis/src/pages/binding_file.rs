//! Content of `<page>.bindings.json`.

use std::ops::Range;

use smol_str::SmolStr;
use val3_syntax::{TextRange, text_at};

use super::escapes::source_range;
use super::json::{self, JsonFault, JsonNode};
use crate::db::{Db, File};

/// Bindings of a page.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Bindings {
    /// First JSON fault. If it is set, the lists are empty.
    pub fault: Option<JsonFault>,
    /// Bindings of data to page elements.
    pub data: Vec<BoundData>,
    /// Programs that page events execute.
    pub callbacks: Vec<Callback>,
}

/// Binding of data to an element's attribute.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct BoundData {
    /// Element id.
    pub element: Option<BoundName>,
    /// Data path, for example `nSpeed[0]`.
    pub path: Option<BoundName>,
    /// Attribute name, for example `innerHTML`.
    pub attribute: Option<SmolStr>,
    /// Whether the page writes the data.
    pub is_written: bool,
}

/// A program that an element's event executes.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Callback {
    /// Element id.
    pub element: Option<BoundName>,
    /// Event name, for example `click`.
    pub event: Option<SmolStr>,
    /// Program of the application.
    pub program: Option<BoundName>,
    /// Priority of the task that executes the program.
    pub priority: Option<u32>,
}

/// A name in page bindings.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct BoundName {
    /// Content of the string without escapes.
    pub text: SmolStr,
    /// Range between the quotes.
    pub range: TextRange,
}

impl BoundName {
    /// Returns the source range for a part of the name; `source` is the text of the file.
    pub fn part(&self, source: &str, part: &Range<usize>) -> TextRange {
        let raw = text_at(source, self.range);
        source_range(raw, self.range.start(), part)
    }
}

impl Bindings {
    /// Returns the ids of page elements.
    pub fn elements(&self) -> impl Iterator<Item = &BoundName> {
        let of_data = self.data.iter().filter_map(|bound| bound.element.as_ref());
        of_data.chain(self.callbacks.iter().filter_map(|callback| callback.element.as_ref()))
    }
}

/// Reads a binding file.
#[salsa::tracked]
pub fn bindings(db: &dyn Db, file: File) -> Bindings {
    let root = match json::parse(file.text(db)) {
        Ok(root) => root,
        Err(fault) => return Bindings { fault: Some(fault), ..Bindings::default() },
    };
    let entries = |list: &str| root.member(list).map(JsonNode::elements).unwrap_or_default();
    let text = |entry: &JsonNode, key: &str| Some(SmolStr::from(entry.member(key)?.text()?.0));
    let data = entries("bindings").iter().map(|entry| BoundData {
        element: name(entry, "id"),
        path: name(entry, "data"),
        attribute: text(entry, "attribute"),
        is_written: text(entry, "direction").is_some_and(|direction| direction.contains('w')),
    });
    let callbacks = entries("callbacks").iter().map(|entry| Callback {
        element: name(entry, "id"),
        event: text(entry, "event"),
        program: name(entry, "data"),
        priority: entry.member("priority").and_then(JsonNode::integer),
    });
    Bindings { fault: None, data: data.collect(), callbacks: callbacks.collect() }
}

fn name(entry: &JsonNode, key: &str) -> Option<BoundName> {
    let (text, range) = entry.member(key)?.text().filter(|(text, _)| !text.is_empty())?;
    Some(BoundName { text: text.into(), range })
}
