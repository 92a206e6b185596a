//! The lists of s5 and s6: `<num name="n"><valueNum index="0" value="3" /></num>`. Every value is spelt with all its
//! attributes, some of them on elements inside, and the father of a variable is written once for all its values.

use rustc_hash::FxHashMap;
use val3_syntax::TextRange;
use val3_syntax::xml::{self, Attribute, Element};

use super::super::{SavedData, SavedValue, Shape, saved_data};
use super::edits::Edits;
use super::layout::Layout;
use super::tag;

/// Writes the values of a variable into its element. Inputs, outputs and lines have no value there.
pub(super) fn data(edits: &mut Edits, layout: &Layout<'_>, element: Element<'_>, data: &SavedData) {
    let Shape::Sizes(sizes) = &data.shape else { return };
    let found: Vec<_> = element.elements().filter(|found| found.attribute("index").is_some()).collect();
    let Some(last) = found.last() else { return };
    if data.is_part {
        return part(edits, &found, data);
    }
    let count = sizes.iter().map(|size| *size as usize).product::<usize>();
    father(edits, element, data);
    let values: FxHashMap<&str, &SavedValue> = data.values.iter().map(|value| (value.key.as_str(), value)).collect();
    let value = |index: usize| values.get(index.to_string().as_str()).copied();
    for (index, found) in found.iter().enumerate() {
        if index < count {
            change(edits, *found, data, value(index));
        } else {
            edits.replace(xml::whole_line(layout.text, found.view().range()), String::new());
        }
    }
    let added = (found.len()..count).map(|index| copy(layout, *last, data, (index, value(index))));
    let text: String = added.map(|text| layout.beside(last.tag_range().start(), &[text])).collect();
    if !text.is_empty() {
        edits.replace(TextRange::empty(last.view().range().end()), text);
    }
}

/// Writes some of the values.
fn part(edits: &mut Edits, found: &[Element<'_>], data: &SavedData) {
    for (index, found) in found.iter().enumerate() {
        let value = data.values.iter().find(|value| value.key == index.to_string());
        if value.is_some() {
            change(edits, *found, data, value);
        }
    }
}

/// The attributes of one value that changed.
fn change(edits: &mut Edits, found: Element<'_>, data: &SavedData, value: Option<&SavedValue>) {
    for attribute in leaves(found) {
        let Some(name) = name_of(attribute) else { continue };
        let new = value.and_then(|value| value.text(name));
        if !saved_data::same_text(&data.type_name, name, new, Some(&attribute.text())) {
            edits.replace(attribute.range, new.map_or_else(|| default_text(&data.type_name, name), tag::escaped));
        }
    }
}

/// The attributes of a value and of the elements inside of it.
fn leaves<'g>(found: Element<'g>) -> impl Iterator<Item = Attribute<'g>> {
    found.attributes().chain(found.elements().flat_map(Element::attributes))
}

/// The attribute of s7 for an attribute of a value.
fn name_of<'g>(attribute: Attribute<'g>) -> Option<&'g str> {
    match attribute.name {
        "open" => Some("ioOpen"),
        "close" => Some("ioClose"),
        "index" | "alias" | "name" | "ioIndex" => None,
        name => Some(name),
    }
}

fn default_text(type_name: &str, name: &str) -> String {
    let candidates = ["0", "false", "joint", "ssame", "esame", "wsame", "100", "50", "99999"];
    let default = candidates.into_iter().find(|text| saved_data::same_text(type_name, name, Some(text), None));
    default.unwrap_or("").to_owned()
}

/// A further value, written like the last one.
fn copy(
    layout: &Layout<'_>,
    last: Element<'_>,
    data: &SavedData,
    (index, value): (usize, Option<&SavedValue>),
) -> String {
    let text = layout.slice(last.view().range());
    let parse = val3_syntax::parse(text);
    let Some(copied) = xml::root(parse.view()) else { return String::new() };
    let mut edits = Edits::default();
    if let Some(attribute) = copied.attribute("index") {
        edits.replace(attribute.range, index.to_string());
    }
    change(&mut edits, copied, data, value);
    edits.apply(text)
}

/// `<pFather alias="" name="world" fatherIndex="0" />`: that of the first value, as there is one for all.
fn father(edits: &mut Edits, element: Element<'_>, data: &SavedData) {
    let Some(found) = element.elements().find(|found| found.name().ends_with("Father")) else { return };
    let Some(new) = data.values.first().and_then(|value| value.text("fatherId")) else { return };
    let (name, index) = new.trim_end_matches(']').split_once('[').unwrap_or((new, "0"));
    for (attribute, text) in [("name", name), ("fatherIndex", index)] {
        if let Some(attribute) = found.attribute(attribute).filter(|attribute| attribute.text() != text) {
            edits.replace(attribute.range, tag::escaped(text));
        }
    }
}
