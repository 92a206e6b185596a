//! Values in a data file, in the form that [`rewrite`](crate::rewrite()) accepts.

use val3_lang::types::BaseType;
use val3_syntax::xml::XmlElement;

use crate::lists;
use crate::{SavedContainer, SavedContent, SavedData, SavedField, SavedValue};

/// Nesting limit of fields within fields.
const NESTING: usize = 8;

/// Values of the variable or field that `element` declares, as spelled in the file. Omitted attributes and fields are
/// omitted. Invalid sizes count as one value.
#[must_use]
pub fn read(element: XmlElement<'_>) -> SavedData {
    match element.name() {
        "Data" | "Field" => read_nested(element, NESTING),
        _ => lists::read(element),
    }
}

/// Type name of a variable or field, as spelled in the file; empty if it is missing.
pub fn type_name(element: XmlElement<'_>) -> smol_str::SmolStr {
    match element.name() {
        "Data" | "Field" => element.value("type").unwrap_or_default().into(),
        list => list.into(),
    }
}

fn read_nested(element: XmlElement<'_>, nesting: usize) -> SavedData {
    let type_name = element.value("type").unwrap_or_default();
    let is_user = BaseType::from_file_name(&type_name).is_none();
    let values = element.elements().filter(|found| found.name() == "Value").map(|value| {
        let content = match is_user && nesting > 0 {
            true => SavedContent::Fields(fields(value, nesting - 1)),
            false => SavedContent::Attributes(attributes(value)),
        };
        SavedValue { key: key(value), content }
    });
    SavedData {
        name: element.value("name").unwrap_or_default().into(),
        type_name: type_name.into(),
        shape: shape(element),
        values: values.collect(),
        is_part: false,
    }
}

fn fields(value: XmlElement<'_>, nesting: usize) -> Vec<SavedField> {
    let fields = value.elements().filter(|found| found.name() == "Field");
    fields.map(|field| SavedField { initial: false, data: read_nested(field, nesting) }).collect()
}

fn attributes(value: XmlElement<'_>) -> Vec<(smol_str::SmolStr, String)> {
    let attributes = value.attributes().filter(|attribute| attribute.name != "key");
    attributes.map(|attribute| (attribute.name.into(), attribute.text().into_owned())).collect()
}

fn key(value: XmlElement<'_>) -> String {
    value.value("key").unwrap_or_default().into_owned()
}

fn shape(element: XmlElement<'_>) -> SavedContainer {
    if element.value("xsi:type").is_some_and(|shape| shape.trim() == "collection") {
        return SavedContainer::Keys;
    }
    let size = element.value("size");
    let sizes: Option<Vec<u32>> = size.and_then(|text| text.split_whitespace().map(|size| size.parse().ok()).collect());
    SavedContainer::Sizes(sizes.filter(|sizes| !sizes.is_empty()).unwrap_or_else(|| vec![1]))
}
