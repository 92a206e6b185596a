//! The attributes of a `Value`.

use val3_lang::types::{self, BaseType};
use val3_syntax::xml::{self, Attribute, Element};

use super::super::{Content, SavedValue, saved_data};

/// A text as an attribute in double quotes holds it. Characters below a blank would be read as blanks.
pub(super) fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for character in xml::escaped(text).chars() {
        match character {
            '\0'..' ' => out.push_str(&format!("&#{};", u32::from(character))),
            _ => out.push(character),
        }
    }
    out
}

/// The element holds the value already.
pub(super) fn is_same(type_name: &str, element: Element<'_>, value: &SavedValue) -> bool {
    let same = |name: &str| saved_data::same_text(type_name, name, element.value(name).as_deref(), value.text(name));
    names(type_name, value).iter().all(|name| same(name))
}

/// The element holds the default of its type.
pub(super) fn is_default(type_name: &str, element: Element<'_>) -> bool {
    let mut values = element.attributes().filter(|attribute| attribute.name != "key");
    element.elements().next().is_none()
        && values.all(|attribute| saved_data::same_text(type_name, attribute.name, Some(&attribute.text()), None))
}

/// The attributes of a new element that are not the default, each with a blank before it.
pub(super) fn attributes(type_name: &str, value: &SavedValue) -> String {
    let spelt = |name: &&str| !saved_data::same_text(type_name, name, value.text(name), None);
    names(type_name, value).into_iter().filter(spelt).map(|name| written(name, value)).collect()
}

/// The attributes of an existing element in their order. New ones are where files usually have them.
pub(super) fn changed(type_name: &str, element: Element<'_>, value: &SavedValue) -> String {
    let names = names(type_name, value);
    let place = |name: &str| names.iter().position(|known| *known == name);
    let mut out: Vec<(&str, String)> = Vec::new();
    for attribute in element.attributes() {
        if let Some(text) = kept(type_name, attribute, value, place(attribute.name).is_some()) {
            out.push((attribute.name, text));
        }
    }
    for (at, name) in names.iter().enumerate().filter(|(_, name)| element.attribute(name).is_none()) {
        if !saved_data::same_text(type_name, name, value.text(name), None) {
            let behind = out.iter().position(|(other, _)| place(other).is_some_and(|other| other > at));
            out.insert(behind.unwrap_or(out.len()), (name, written(name, value)));
        }
    }
    out.into_iter().map(|(_, text)| text).collect()
}

/// The new attribute; `None` where it has become the default.
fn kept(type_name: &str, attribute: Attribute<'_>, value: &SavedValue, known: bool) -> Option<String> {
    let new = value.text(attribute.name);
    let old = attribute.text();
    let same = |other: Option<&str>| saved_data::same_text(type_name, attribute.name, new, other);
    if !known || same(Some(&old)) {
        return Some(format!(" {}=\"{}\"", attribute.name, attribute.raw.replace('"', "&quot;")));
    }
    (!same(None)).then(|| written(attribute.name, value))
}

fn written(name: &str, value: &SavedValue) -> String {
    format!(" {name}=\"{}\"", escaped(value.text(name).unwrap_or("")))
}

/// The attributes of the type in the order of files, and what else the value names.
fn names<'v>(type_name: &str, value: &'v SavedValue) -> Vec<&'v str> {
    let mut names: Vec<&str> = match BaseType::from_file_name(type_name) {
        Some((ty, arm)) => types::attributes(ty, arm).iter().map(|attribute| attribute.name).collect(),
        None => Vec::new(),
    };
    if let Content::Attributes(attributes) = &value.content {
        for (name, _) in attributes {
            if !names.contains(&name.as_str()) {
                names.push(name);
            }
        }
    }
    names
}
