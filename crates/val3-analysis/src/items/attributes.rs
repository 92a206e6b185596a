//! The attributes of an element against those that the file format knows.

use val3_lang::files::{self, FileKind, Presence};

use crate::xml::{Attribute, Element};

/// The attribute with the access to a variable, which says nothing about its type.
const ACCESS: &str = "access";

/// The attributes of `element` that are neither among `known` nor a matter of XML itself.
pub fn unknown<'g>(element: Element<'g>, known: impl Fn(&str) -> bool) -> impl Iterator<Item = Attribute<'g>> {
    element.attributes().filter(move |attribute| !known(attribute.name) && !is_of_xml(attribute.name))
}

/// A namespace, or an attribute with the prefix of another one than the format's `xsi`.
fn is_of_xml(name: &str) -> bool {
    match name.split_once(':') {
        Some(("xsi", local)) => matches!(local, "schemaLocation" | "noNamespaceSchemaLocation" | "nil"),
        Some(_) => true,
        None => name == "xmlns",
    }
}

/// The element has an attribute that the format does not know.
pub fn has_unknown(file: FileKind, element: Element<'_>) -> bool {
    let known = files::find(file, element.name());
    known.is_some_and(|known| unknown(element, |name| known.attribute(name).is_some()).next().is_some())
}

/// Every attribute that says what a variable is can be read, and none that every writer gives is missing: nothing is a
/// default that may not be meant.
pub fn is_plain(element: Element<'_>) -> bool {
    let Some((file, known)) = files::variable(element.name()) else { return true };
    !has_unknown(file, element) && left_out(element, known.attributes).iter().all(|missing| missing.name == ACCESS)
}

/// The attributes that are missing although every writer gives them. Where required ones are missing, the others are no
/// news.
pub fn left_out<'k>(element: Element<'_>, known: &'k [files::Attribute]) -> Vec<&'k files::Attribute> {
    let missing = known.iter().filter(|attribute| is_left_out(element, attribute));
    let (required, expected): (Vec<_>, Vec<_>) =
        missing.partition(|attribute| attribute.presence == Presence::Required);
    if required.is_empty() { expected } else { required }
}

/// The attribute is missing although every writer gives it.
fn is_left_out(element: Element<'_>, attribute: &files::Attribute) -> bool {
    let is_optional = matches!(attribute.presence, Presence::Optional(_));
    // A collection has no size.
    let has_none =
        attribute.name == "size" && element.value("xsi:type").is_some_and(|kind| kind.trim() == "collection");
    !is_optional && !has_none && element.attribute(attribute.name).is_none()
}
