//! Comparison of attributes with the file format.

use val3_lang::files::{self, FileKind, Presence};

use crate::xml::{Attribute, XmlElement};

/// Attribute for the access to a variable, which does not affect its type.
const ACCESS: &str = "access";

/// Returns the attributes of `element` that are neither `known` nor part of XML itself.
pub fn unknown<'g>(element: XmlElement<'g>, known: impl Fn(&str) -> bool) -> impl Iterator<Item = Attribute<'g>> {
    element.attributes().filter(move |attribute| !known(attribute.name) && !is_of_xml(attribute.name))
}

/// Whether the attribute is a namespace declaration, a general `xsi` attribute, or has another prefix.
fn is_of_xml(name: &str) -> bool {
    match name.split_once(':') {
        Some(("xsi", local)) => matches!(local, "schemaLocation" | "noNamespaceSchemaLocation" | "nil"),
        Some(_) => true,
        None => name == "xmlns",
    }
}

/// Whether the element has an attribute that the file format does not define.
pub fn has_unknown(file: FileKind, element: XmlElement<'_>) -> bool {
    let known = files::find(file, element.name());
    known.is_some_and(|known| unknown(element, |name| known.attribute(name).is_some()).next().is_some())
}

/// Whether all attributes that define a variable are known, and no required or expected one is missing, so that no
/// default replaces a misspelt value.
pub fn is_plain(element: XmlElement<'_>) -> bool {
    let Some((file, known)) = files::variable(element.name()) else { return true };
    !has_unknown(file, element) && left_out(element, known.attributes).iter().all(|missing| missing.name == ACCESS)
}

/// Returns the missing required attributes. If no required one is missing, returns the missing attributes that every
/// tool writes.
pub fn left_out<'k>(element: XmlElement<'_>, known: &'k [files::AttributePage]) -> Vec<&'k files::AttributePage> {
    let missing = known.iter().filter(|attribute| is_left_out(element, attribute));
    let (required, expected): (Vec<_>, Vec<_>) =
        missing.partition(|attribute| attribute.presence == Presence::Required);
    if required.is_empty() { expected } else { required }
}

/// Whether the attribute is missing although every tool writes it.
fn is_left_out(element: XmlElement<'_>, attribute: &files::AttributePage) -> bool {
    let is_optional = matches!(attribute.presence, Presence::Optional(_));
    // A collection has no size.
    let has_none =
        attribute.name == "size" && element.value("xsi:type").is_some_and(|kind| kind.trim() == "collection");
    !is_optional && !has_none && element.attribute(attribute.name).is_none()
}
