//! Attributes of a `Value` element.

use val3_lang::types::{self, BaseType};
use val3_syntax::xml::{self, Attribute, XmlElement};
use val3_syntax::{TextRange, TextSize, text_size};

use crate::edits::Edits;
use crate::layout::DataLayout;
use crate::{SavedContent, SavedValue, saved_data};

/// Escapes a text for an attribute with this quote. Control characters are escaped, because they would be read as
/// spaces.
pub(crate) fn escaped(text: &str, quote: char) -> String {
    let mut out = String::with_capacity(text.len());
    for character in xml::escaped(text).chars() {
        match character {
            '\0'..' ' => out.push_str(&format!("&#{};", u32::from(character))),
            '\'' if quote == '\'' => out.push_str("&apos;"),
            _ => out.push(character),
        }
    }
    out
}

/// Whether the element already contains the value.
pub(crate) fn is_same(type_name: &str, element: XmlElement<'_>, value: &SavedValue) -> bool {
    let same = |name: &str| saved_data::same_text(type_name, name, element.value(name).as_deref(), value.text(name));
    names(type_name, value).iter().all(|name| same(name))
}

/// Whether the element has the type's default.
pub(crate) fn is_default(type_name: &str, element: XmlElement<'_>) -> bool {
    let mut values = element.attributes().filter(|attribute| attribute.name != "key");
    element.elements().next().is_none()
        && values.all(|attribute| saved_data::same_text(type_name, attribute.name, Some(&attribute.text()), None))
}

/// Whether an attribute other than `name` contains an explicit default, or defaults are generally explicit in the file.
pub(crate) fn spells_another(layout: &DataLayout<'_>, type_name: &str, element: XmlElement<'_>, name: &str) -> bool {
    let mut others = element.attributes().filter(|other| other.name != name && other.name != "key");
    others.any(|other| saved_data::same_text(type_name, other.name, Some(&other.text()), None))
        || layout.spells_defaults()
}

/// Numbers of explicit and omitted defaults in the values of a variable with a built-in type.
pub(crate) fn count_defaults(data: XmlElement<'_>) -> (usize, usize) {
    let type_name = data.value("type").unwrap_or_default();
    let (mut spelt, mut omitted) = (0, 0);
    for name in known(&type_name) {
        for value in data.elements() {
            match value.attribute(name) {
                None => omitted += 1,
                Some(found) if saved_data::same_text(&type_name, name, Some(&found.text()), None) => spelt += 1,
                Some(_) => {}
            }
        }
    }
    (spelt, omitted)
}

/// Attributes of a new element that differ from the default, each preceded by a space.
pub(crate) fn attributes(type_name: &str, value: &SavedValue) -> String {
    let spelt = |name: &&str| !saved_data::same_text(type_name, name, value.text(name), None);
    names(type_name, value).into_iter().filter(spelt).map(|name| written(name, value)).collect()
}

/// Changes an element's attributes. New attributes are inserted at their usual position.
pub(crate) fn change(
    edits: &mut Edits,
    layout: &DataLayout<'_>,
    type_name: &str,
    element: XmlElement<'_>,
    value: &SavedValue,
) {
    let names = names(type_name, value);
    let place = |name: &str| names.iter().position(|known| *known == name);
    let mut at = element.name_range().end();
    let mut missing = names.iter().enumerate().filter(|(_, name)| element.attribute(name).is_none()).peekable();
    for attribute in element.attributes() {
        if let Some(own) = place(attribute.name) {
            while let Some((_, name)) = missing.next_if(|(at, _)| *at < own) {
                add(edits, type_name, at, name, value);
            }
            let spells = || spells_another(layout, type_name, element, attribute.name);
            replace(edits, layout, type_name, attribute, value, &spells);
        }
        at = attribute.range.end() + TextSize::of(attribute.quote);
    }
    missing.for_each(|(_, name)| add(edits, type_name, at, name, value));
}

fn add(edits: &mut Edits, type_name: &str, at: TextSize, name: &str, value: &SavedValue) {
    if !saved_data::same_text(type_name, name, value.text(name), None) {
        edits.insert(at, written(name, value));
    }
}

/// Changes an attribute. An attribute that has become the default is removed with the whitespace before it, unless the
/// value has an explicit text and defaults are explicit here (`spells`).
fn replace(
    edits: &mut Edits,
    layout: &DataLayout<'_>,
    type_name: &str,
    attribute: Attribute<'_>,
    value: &SavedValue,
    spells: &dyn Fn() -> bool,
) {
    let new = value.text(attribute.name);
    if saved_data::same_text(type_name, attribute.name, new, Some(&attribute.text())) {
        return;
    }
    let is_default = saved_data::same_text(type_name, attribute.name, new, None);
    if is_default && (new.is_none() || !spells()) {
        let before = layout.slice(TextRange::up_to(attribute.name_range.start()));
        let blanks = before.len() - before.trim_end().len();
        let start = attribute.name_range.start() - text_size(blanks);
        let end = attribute.range.end() + TextSize::of(attribute.quote);
        return edits.replace(TextRange::new(start, end), String::new());
    }
    let default = saved_data::default_text(type_name, attribute.name);
    edits.replace(attribute.range, escaped(new.unwrap_or(&default), attribute.quote));
}

fn written(name: &str, value: &SavedValue) -> String {
    format!(" {name}=\"{}\"", escaped(value.text(name).unwrap_or(""), '"'))
}

/// Attributes of a built-in type in file order.
fn known(type_name: &str) -> impl Iterator<Item = &'static str> {
    let found = BaseType::from_file_name(type_name);
    found.into_iter().flat_map(|(ty, arm)| types::attributes(ty, arm)).map(|attribute| attribute.name)
}

/// Attributes of the type, and further attributes of the value.
fn names<'v>(type_name: &str, value: &'v SavedValue) -> Vec<&'v str> {
    let mut names: Vec<&str> = known(type_name).collect();
    if let SavedContent::Attributes(attributes) = &value.content {
        for (name, _) in attributes {
            if !names.contains(&name.as_str()) {
                names.push(name);
            }
        }
    }
    names
}
