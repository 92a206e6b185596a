//! The content of `<page>.bindings.json`.

use smol_str::SmolStr;
use val3_syntax::TextRange;

use super::json::{self, JsonFault, Value};
use crate::db::{Db, File};

/// The names that the bindings of a page contain.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Bindings {
    /// The first place that is no JSON. Nothing else is known then.
    pub fault: Option<JsonFault>,
    /// Ids of elements of the page.
    pub elements: Vec<BoundName>,
    /// Paths of data: `nSpeed[0]`.
    pub data: Vec<BoundName>,
    /// Programs that events of the page call.
    pub programs: Vec<BoundName>,
}

/// A name in the bindings of a page.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct BoundName {
    /// The text of the string.
    pub text: SmolStr,
    /// The range between the quotes.
    pub range: TextRange,
    /// Whether the page writes the data.
    pub is_written: bool,
}

impl BoundName {
    /// The name of the data at the start of a path: `nSpeed` of `nSpeed[0]`.
    pub fn root(&self) -> &str {
        self.text.split(['[', '.', ':']).next().unwrap_or("")
    }
}

/// Reads the file with the bindings of a page.
#[salsa::tracked]
pub fn bindings(db: &dyn Db, file: File) -> Bindings {
    let root = match json::parse(file.text(db)) {
        Ok(root) => root,
        Err(fault) => return Bindings { fault: Some(fault), ..Bindings::default() },
    };
    let mut found = Bindings::default();
    for binding in root.member("bindings").map(Value::elements).unwrap_or_default() {
        found.elements.extend(name(binding, "id", false));
        let is_written = binding.member("direction").and_then(Value::text).is_some_and(|(text, _)| text.contains('w'));
        found.data.extend(name(binding, "data", is_written));
    }
    for callback in root.member("callbacks").map(Value::elements).unwrap_or_default() {
        found.elements.extend(name(callback, "id", false));
        found.programs.extend(name(callback, "data", false));
    }
    found
}

fn name(entry: &Value, key: &str, is_written: bool) -> Option<BoundName> {
    let (text, range) = entry.member(key)?.text().filter(|(text, _)| !text.is_empty())?;
    Some(BoundName { text: text.into(), range, is_written })
}
