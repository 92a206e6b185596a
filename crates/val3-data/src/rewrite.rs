//! Writes new values into a data file in its own format. Only changed elements are written; all other bytes are
//! unchanged.
//!
//! A value that has become the default is removed from an array, as the tools do (s7 and s8). Lists of s5 and s6
//! contain all values.

use rustc_hash::FxHashMap;
use val3_syntax::TextEdit;
use val3_syntax::xml::{self, XmlElement};

use crate::edits::Edits;
use crate::layout::{DataLayout, elements};
use crate::{SavedData, UnwritableValue, lists, unwritable, values};

/// Text of a data file with the values of `data`. Data that the file does not declare are skipped, and data that are
/// not in `data` are unchanged. The run time is linear in the size of the text and the data.
///
/// # Errors
/// A value that the file cannot contain.
pub fn rewrite(text: &str, data: &[SavedData]) -> Result<String, UnwritableValue> {
    let parse = val3_syntax::parse(text);
    let Some(root) = xml::root(parse.view()) else { return Ok(text.to_owned()) };
    declared(root, data).into_iter().try_for_each(|(element, data)| unwritable::check(element, data))?;
    Ok(TextEdit::apply_all(text, &edits(text, root, data)))
}

/// Edits that [`rewrite`] makes in a text with this root, sorted and without overlap.
#[must_use]
pub fn edits(text: &str, root: XmlElement<'_>, data: &[SavedData]) -> Vec<TextEdit> {
    let mut edits = Edits::default();
    let layout = DataLayout::of(text, root);
    for (element, data) in declared(root, data) {
        match element.name() {
            "Data" => values::data(&mut edits, &layout, element, data),
            _ => lists::data(&mut edits, &layout, element, data),
        }
    }
    edits.sorted()
}

/// Elements of variables with their new values.
fn declared<'g, 'd>(root: XmlElement<'g>, data: &'d [SavedData]) -> Vec<(XmlElement<'g>, &'d SavedData)> {
    let data: FxHashMap<&str, &SavedData> = data.iter().map(|data| (data.name.as_str(), data)).collect();
    let found = |element: XmlElement<'g>| Some((element, *data.get(element.value("name")?.as_ref())?));
    elements(root).filter_map(found).collect()
}

#[cfg(test)]
mod tests;
