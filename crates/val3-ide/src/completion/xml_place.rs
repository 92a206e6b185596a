//! Which attribute the cursor is in.

use val3_syntax::SyntaxKind::*;
use val3_syntax::{SyntaxNode, TextRange, TextSize};

/// The value of an attribute.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub(super) struct AttributePlace {
    /// The element.
    pub(super) element: String,
    /// The element around it.
    pub(super) parent: String,
    /// The attribute.
    pub(super) attribute: String,
    /// The type of the innermost data, field, parameter or local around it.
    pub(super) data_type: Option<String>,
    /// The type of the next data or field further out, whose user type has the fields.
    pub(super) outer_type: Option<String>,
}

/// The attribute that holds a position, and where its value stands.
pub(super) fn attribute_place(root: &SyntaxNode, offset: TextSize) -> Option<(AttributePlace, TextRange)> {
    let tokens = root.text_range().contains_inclusive(offset).then(|| root.token_at_offset(offset))?;
    let token = tokens.into_iter().find(|token| token.kind() == XML_STRING)?;
    let range = token.text_range();
    let start = range.start() + TextSize::new(1);
    let closed = token.text().len() > 1 && token.text().ends_with(['"', '\'']);
    let inside = TextRange::new(start, if closed { range.end() - TextSize::new(1) } else { range.end() }.max(start));
    if !inside.contains_inclusive(offset) {
        return None;
    }
    let attribute = token.parent()?;
    let tag = attribute.parent()?;
    let element = tag.parent()?;
    let mut types = tag.ancestors().filter(|node| node.kind() == ELEMENT).filter_map(|element| data_type(&element));
    let place = AttributePlace {
        element: name(&tag),
        parent: element.parent().map(|parent| element_name(&parent)).unwrap_or_default(),
        attribute: name(&attribute),
        data_type: types.next(),
        outer_type: types.next(),
    };
    Some((place, inside))
}

/// The name of a tag or attribute.
fn name(node: &SyntaxNode) -> String {
    let tokens = node.children_with_tokens().filter_map(|child| child.into_token());
    tokens.into_iter().find(|token| token.kind() == XML_NAME).map(|token| token.text().to_owned()).unwrap_or_default()
}

fn start_tag(element: &SyntaxNode) -> Option<SyntaxNode> {
    element.children().find(|child| child.kind() == START_TAG)
}

fn element_name(element: &SyntaxNode) -> String {
    start_tag(element).map(|tag| name(&tag)).unwrap_or_default()
}

/// The `type` of an element; in the old dialect an entry of a `…Section` is called as its type.
fn data_type(element: &SyntaxNode) -> Option<String> {
    let attributes = start_tag(element)?.children().filter(|child| child.kind() == ATTRIBUTE);
    let written = attributes.into_iter().find(|attribute| name(attribute) == "type").and_then(|attribute| {
        let value = attribute.children_with_tokens().filter_map(|child| child.into_token());
        let value = value.into_iter().find(|token| token.kind() == XML_STRING)?;
        Some(value.text().trim_matches(['"', '\'']).to_owned())
    });
    let section = || element.parent().filter(|parent| element_name(parent).ends_with("Section"));
    written.or_else(|| section().map(|_| element_name(element)))
}
