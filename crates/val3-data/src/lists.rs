//! Lists of s5 and s6: `<num name="n"><valueNum index="0" value="3" /></num>`. All attributes of every value are
//! explicit, some of them on child elements, and the father of a variable is written once for all values.

use rustc_hash::FxHashMap;
use smol_str::SmolStr;
use val3_syntax::xml::{self, Attribute, XmlElement};
use val3_syntax::{TextEdit, TextSize};

use crate::edits::Edits;
use crate::layout::DataLayout;
use crate::{SavedContainer, SavedContent, SavedData, SavedValue, reference, saved_data, tag};

/// s7 attribute that corresponds to the element with the output of a tool.
const OUTPUT: &str = "ioLink";

/// Whether a data file has the format of s5 and s6, which contains no links of inputs, outputs and lines.
#[must_use]
pub fn is_list_file(text: &str) -> bool {
    let parse = val3_syntax::parse(text);
    xml::root(parse.view()).is_some_and(|root| root.name() == "dataList")
}

/// Values of a variable, each with the variable's father.
pub(crate) fn read(element: XmlElement<'_>) -> SavedData {
    let father = father_element(element).map(|found| ("fatherId".into(), reference::text(found)));
    let values = values(element).map(|value| SavedValue {
        key: value.value("index").unwrap_or_default().into_owned(),
        content: SavedContent::Attributes(attributes(value).chain(father.clone()).collect()),
    });
    let values: Vec<SavedValue> = values.collect();
    let size = element.value("size").and_then(|text| text.trim().parse().ok());
    let size = size.unwrap_or_else(|| u32::try_from(values.len()).unwrap_or(u32::MAX)).max(1);
    SavedData {
        name: element.value("name").unwrap_or_default().into(),
        type_name: element.name().into(),
        shape: SavedContainer::Sizes(vec![size]),
        values,
        is_part: false,
    }
}

fn attributes(value: XmlElement<'_>) -> impl Iterator<Item = (SmolStr, String)> {
    let texts = leaves(value).filter_map(|leaf| Some((name_of(leaf)?.into(), leaf.text().into_owned())));
    texts.chain(output(value).map(|io| (OUTPUT.into(), reference::text(io))))
}

fn values(element: XmlElement<'_>) -> impl Iterator<Item = XmlElement<'_>> {
    element.elements().filter(|found| found.attribute("index").is_some())
}

/// Writes the values of a variable into its element. Inputs, outputs and lines only have a size there.
pub(crate) fn data(edits: &mut Edits, layout: &DataLayout<'_>, element: XmlElement<'_>, data: &SavedData) {
    let SavedContainer::Sizes(sizes) = &data.shape else { return };
    let found: Vec<_> = values(element).collect();
    if data.is_part {
        return part(edits, &found, data);
    }
    let count = sizes.iter().map(|size| *size as usize).product::<usize>();
    size(edits, element, count);
    let Some(last) = found.last() else { return };
    write_father(edits, element, data);
    let values: FxHashMap<&str, &SavedValue> = data.values.iter().map(|value| (value.key.as_str(), value)).collect();
    let value = |index: usize| values.get(index.to_string().as_str()).copied();
    for (index, found) in found.iter().enumerate() {
        if index < count {
            change(edits, *found, data, value(index));
        } else {
            edits.replace(xml::whole_line(layout.text, found.view().range()), String::new());
        }
    }
    let added = (found.len()..count).map(|index| copy(layout, *last, data, index, value(index)));
    let text: String = added.map(|text| layout.beside(last.tag_range().start(), &[text])).collect();
    if !text.is_empty() {
        edits.insert(last.view().range().end(), text);
    }
}

fn size(edits: &mut Edits, element: XmlElement<'_>, count: usize) {
    match element.attribute("size") {
        Some(size) if size.text().trim().parse() == Ok(count) => {}
        Some(size) => edits.replace(size.range, count.to_string()),
        // The number of values is the size.
        None if count == 1 || values(element).next().is_some() => {}
        None => {
            let last = element.attributes().last();
            let end = last.map_or(element.name_range().end(), |last| last.range.end() + TextSize::of(last.quote));
            edits.insert(end, format!(" size=\"{count}\""));
        }
    }
}

/// Writes some of the values.
fn part(edits: &mut Edits, found: &[XmlElement<'_>], data: &SavedData) {
    let values: FxHashMap<&str, &SavedValue> = data.values.iter().map(|value| (value.key.as_str(), value)).collect();
    for (index, found) in found.iter().enumerate() {
        if let Some(value) = values.get(index.to_string().as_str()) {
            change(edits, *found, data, Some(value));
        }
    }
}

/// Writes a value's changed attributes.
fn change(edits: &mut Edits, found: XmlElement<'_>, data: &SavedData, value: Option<&SavedValue>) {
    for attribute in leaves(found) {
        let Some(name) = name_of(attribute) else { continue };
        let new = value.and_then(|value| value.text(name));
        if !saved_data::same_text(&data.type_name, name, new, Some(&attribute.text())) {
            let default = saved_data::default_text(&data.type_name, name);
            edits.replace(attribute.range, tag::escaped(new.unwrap_or(&default), attribute.quote));
        }
    }
    // A running application sets a physical output here, which these files cannot name.
    let named = value.and_then(|value| value.text(OUTPUT)).filter(|text| text.is_empty() || text.ends_with(']'));
    if let Some((io, text)) = output(found).zip(named) {
        reference::write(edits, io, text);
    }
}

/// Element with the output that opens and closes a tool.
fn output(value: XmlElement<'_>) -> Option<XmlElement<'_>> {
    value.elements().find(|part| part.attribute("ioIndex").is_some())
}

/// Attributes of a value and its child elements.
pub(crate) fn leaves<'g>(found: XmlElement<'g>) -> impl Iterator<Item = Attribute<'g>> {
    found.attributes().chain(found.elements().flat_map(XmlElement::attributes))
}

/// s7 name of a value's attribute.
pub(crate) fn name_of<'g>(attribute: Attribute<'g>) -> Option<&'g str> {
    match attribute.name {
        "open" => Some("ioOpen"),
        "close" => Some("ioClose"),
        "index" | "alias" | "name" | "ioIndex" => None,
        name => Some(name),
    }
}

/// An additional value in the format of the last value.
fn copy(
    layout: &DataLayout<'_>,
    last: XmlElement<'_>,
    data: &SavedData,
    index: usize,
    value: Option<&SavedValue>,
) -> String {
    let text = layout.slice(last.view().range());
    let parse = val3_syntax::parse(text);
    let Some(copied) = xml::root(parse.view()) else { return String::new() };
    let mut edits = Edits::default();
    if let Some(attribute) = copied.attribute("index") {
        edits.replace(attribute.range, index.to_string());
    }
    change(&mut edits, copied, data, value);
    TextEdit::apply_all(text, &edits.sorted())
}

/// Variable to which a variable is relative, with its library: `fTray`, `lib:fTray`.
pub(crate) fn father(element: XmlElement<'_>) -> Option<String> {
    let text = reference::text(father_element(element)?);
    text.split_once('[').map(|(variable, _)| variable.to_owned())
}

fn father_element(element: XmlElement<'_>) -> Option<XmlElement<'_>> {
    element.elements().find(|found| found.name().ends_with("Father"))
}

/// Whether the file contains the father of the variable, even if it is empty.
pub(crate) fn has_father(element: XmlElement<'_>) -> bool {
    father_element(element).is_some()
}

/// Father of a value, if it has one.
pub(crate) fn father_of(value: &SavedValue) -> Option<&str> {
    value.text("fatherId").filter(|father| !father.is_empty())
}

/// First value that has a father, with its father.
pub(crate) fn common_father(data: &SavedData) -> Option<(&SavedValue, &str)> {
    data.values.iter().find_map(|value| Some((value, father_of(value)?)))
}

/// Writes the variable's father.
fn write_father(edits: &mut Edits, element: XmlElement<'_>, data: &SavedData) {
    let first = data.values.first().and_then(|value| value.text("fatherId"));
    let new = common_father(data).map(|(_, father)| father).or(first);
    if let Some((found, new)) = father_element(element).zip(new) {
        reference::write(edits, found, new);
    }
}
