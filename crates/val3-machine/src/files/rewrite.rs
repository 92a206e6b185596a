//! Writes new values into a data file in its style: only changed elements are written, every other byte stays.
//!
//! A value that has become the default leaves an array, as the tools write it (formats of s7 and s8); the lists of s5
//! and s6 spell every value.

mod edits;
mod layout;
mod lists;
mod tag;
mod values;

use rustc_hash::FxHashMap;
use val3_syntax::xml;

use super::SavedData;
use edits::Edits;
use layout::Layout;

/// The text of a data file with the values of `data`. Data that the file does not declare are skipped, and what `data`
/// does not name stays. Takes time in proportion to the text and the data.
#[must_use]
pub fn rewrite(text: &str, data: &[SavedData]) -> String {
    let parse = val3_syntax::parse(text);
    let Some(root) = xml::root(parse.view()) else { return text.to_owned() };
    let mut edits = Edits::default();
    let layout = Layout::of(text);
    let data: FxHashMap<&str, &SavedData> = data.iter().map(|data| (data.name.as_str(), data)).collect();
    let named = |name: &str| data.get(name).copied();
    match root.name() {
        "Database" => {
            for element in root.list("Datas", "Data") {
                if let Some(data) = element.value("name").and_then(|name| named(&name)) {
                    values::data(&mut edits, &layout, element, data);
                }
            }
        }
        _ => {
            for element in root.elements().flat_map(xml::Element::elements) {
                if let Some(data) = element.value("name").and_then(|name| named(&name)) {
                    lists::data(&mut edits, &layout, element, data);
                }
            }
        }
    }
    edits.apply(text)
}

#[cfg(test)]
mod tests;
