//! Equality of elements: attributes and content, ignoring layout and the order of unordered lists.

use val3_data::same_text;
use val3_lang::types::BaseType;
use val3_syntax::xml::XmlElement;

use crate::kind::MergedKind;
use crate::node::MergeNode;
use crate::text::lines_of;

/// Whether both elements have the same meaning, including comments.
pub(crate) fn same(kind: MergedKind, one: &MergeNode<'_>, other: &MergeNode<'_>) -> bool {
    one.id == other.id && same_content(kind, one, other)
}

/// Like [`same`], ignoring the keys of the elements.
pub(crate) fn same_content(kind: MergedKind, one: &MergeNode<'_>, other: &MergeNode<'_>) -> bool {
    one.name() == other.name()
        && same_attributes(kind, one, other)
        && one.has_text == other.has_text
        && (!one.has_text || lines_of(one) == lines_of(other))
        && same_children(kind, one, other)
}

/// Like [`same`]; a missing element has the type's default.
pub(crate) fn same_value(kind: MergedKind, one: Option<&MergeNode<'_>>, other: Option<&MergeNode<'_>>) -> bool {
    match (one, other) {
        (Some(one), Some(other)) => same(kind, one, other),
        (Some(written), None) | (None, Some(written)) => is_default(kind, written),
        (None, None) => true,
    }
}

/// Whether an array element has the default of a built-in type, which files may omit.
pub(crate) fn is_default(kind: MergedKind, node: &MergeNode<'_>) -> bool {
    kind == MergedKind::Data && node.name() == "Value" && has_defaults(node, &[])
}

/// Whether a value of a built-in type equals the default, ignoring some attributes.
pub(crate) fn has_defaults(node: &MergeNode<'_>, except: &[&str]) -> bool {
    let attributes = node.element.into_iter().flat_map(XmlElement::attributes);
    let mut content =
        attributes.filter(|attribute| Some(attribute.name) != node.key_name && !except.contains(&attribute.name));
    BaseType::from_file_name(&node.type_name).is_some()
        && content.all(|attribute| same_text(&node.type_name, attribute.name, Some(&attribute.text()), None))
        && node.children.iter().all(|child| has_defaults(child, except))
}

fn same_attributes(kind: MergedKind, one: &MergeNode<'_>, other: &MergeNode<'_>) -> bool {
    let (Some(first), Some(second)) = (one.element, other.element) else { return true };
    let names = first.attributes().chain(second.attributes()).map(|attribute| attribute.name);
    let mut names = names.filter(|name| !name.starts_with("xmlns") && Some(*name) != one.key_name);
    names.all(|name| same_attribute(kind, one, name, first.value(name).as_deref(), second.value(name).as_deref()))
}

/// Whether two attribute values have the same meaning; `None` for an omitted attribute.
pub(crate) fn same_attribute(
    kind: MergedKind,
    node: &MergeNode<'_>,
    name: &str,
    one: Option<&str>,
    other: Option<&str>,
) -> bool {
    if one == other {
        return true;
    }
    if is_in_value(kind, node) {
        return same_text(&node.type_name, name, one, other);
    }
    kind.default_of(name).is_some_and(|default| one.unwrap_or(default) == other.unwrap_or(default))
}

/// Whether the element is a value of a variable or a part of a value.
fn is_in_value(kind: MergedKind, node: &MergeNode<'_>) -> bool {
    let Some(element) = node.element else { return false };
    let declares = matches!(element.name(), "Data" | "Field") || node.type_name.as_str() == element.name();
    kind == MergedKind::Data && !node.type_name.is_empty() && !declares
}

fn same_children(kind: MergedKind, one: &MergeNode<'_>, other: &MergeNode<'_>) -> bool {
    let (first, second) = (written(kind, one), written(kind, other));
    first.len() == second.len() && first.iter().zip(&second).all(|(one, other)| same(kind, one, other))
}

/// Returns the children without omissible default values, sorted by identity if their order has no meaning.
fn written<'n, 't>(kind: MergedKind, node: &'n MergeNode<'t>) -> Vec<&'n MergeNode<'t>> {
    let is_collection = node.value("xsi:type").is_some_and(|shape| shape == "collection");
    let counts = |child: &&MergeNode<'_>| is_collection || !is_default(kind, child);
    let mut children: Vec<_> = node.children.iter().filter(counts).collect();
    if !kind.is_ordered(node.name()) {
        children.sort_by(|one, other| one.id.cmp(&other.id));
    }
    children
}
