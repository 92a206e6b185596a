//! Three-way merge of attributes.

use val3_syntax::xml::{Attribute, XmlElement, escaped};
use val3_syntax::{TextEdit, TextRange, TextSize};

use crate::kind::MergedKind;
use crate::merger::{ElementVersions, Merger};
use crate::node::MergeNode;
use crate::same::same_attribute;

/// Attributes that form one value: a mixture of two positions would be a position that was never taught.
const UNITS: [&[&str]; 2] = [
    &["x", "y", "z", "rx", "ry", "rz", "shoulder", "elbow", "wrist", "fatherId"],
    &["j1", "j2", "j3", "j4", "j5", "j6"],
];

/// Merges the attributes. Attributes in `of_theirs` are copied from theirs.
pub(crate) fn merge(merger: &mut Merger<'_>, versions: ElementVersions<'_, '_>, path: &str, of_theirs: &[&str]) {
    let mut names: Vec<&str> = Vec::new();
    for node in [Some(versions.theirs), Some(versions.ours), versions.base].into_iter().flatten() {
        for attribute in node.element.iter().flat_map(|element| element.attributes()) {
            let is_content = !attribute.name.starts_with("xmlns") && Some(attribute.name) != node.key_name;
            if is_content && !names.contains(&attribute.name) {
                names.push(attribute.name);
            }
        }
    }
    let mut contradictions = Vec::new();
    while let Some(first) = names.first().copied() {
        let (unit, rest): (Vec<&str>, Vec<&str>) = names.into_iter().partition(|name| belong_together(first, name));
        names = rest;
        match changed(merger, versions, &unit) {
            Changed::Ours => {}
            Changed::Both if !of_theirs.contains(&first) => contradictions.extend(described(merger, versions, &unit)),
            Changed::Theirs | Changed::Both => unit.iter().for_each(|name| {
                merger.edits.extend(take(versions.ours, versions.theirs, name));
            }),
        }
    }
    if !contradictions.is_empty() {
        let others = [versions.base, Some(versions.theirs)].map(|node| node.map(head));
        merger.conflict_at(versions.ours, path, contradictions.join(", "), others);
    }
}

enum Changed {
    /// Keep ours.
    Ours,
    /// Only theirs was changed.
    Theirs,
    /// Both were changed differently.
    Both,
}

fn changed(
    merger: &Merger<'_>,
    ElementVersions { base, ours, theirs }: ElementVersions<'_, '_>,
    unit: &[&str],
) -> Changed {
    let differs = |one, other| unit.iter().any(|name| !has_same_value(merger.kind, ours, name, [one, other]));
    if !differs(base, Some(theirs)) || !differs(Some(ours), Some(theirs)) {
        Changed::Ours
    } else if differs(base, Some(ours)) {
        Changed::Both
    } else {
        Changed::Theirs
    }
}

/// Whether the attributes are equal or parts of one value.
fn belong_together(one: &str, other: &str) -> bool {
    one == other || UNITS.iter().any(|unit| unit.contains(&one) && unit.contains(&other))
}

/// Whether an attribute has the same meaning in both versions of the element `node`.
fn has_same_value(kind: MergedKind, node: &MergeNode<'_>, name: &str, versions: [Option<&MergeNode<'_>>; 2]) -> bool {
    let [one, other] = versions.map(|version| version.and_then(|version| version.value(name)));
    same_attribute(kind, node, name, one.as_deref(), other.as_deref())
}

/// Formats the difference: `x is 5 in ours and 7 in theirs`.
fn described(
    merger: &Merger<'_>,
    ElementVersions { ours, theirs, .. }: ElementVersions<'_, '_>,
    unit: &[&str],
) -> Vec<String> {
    let differing = unit.iter().filter_map(|name| {
        let [one, other] = [ours, theirs].map(|node| node.value(name));
        let is_same = same_attribute(merger.kind, ours, name, one.as_deref(), other.as_deref());
        (!is_same).then(|| format!("{name} is {} in ours and {} in theirs", quoted(one), quoted(other)))
    });
    differing.collect()
}

fn quoted(value: Option<String>) -> String {
    value.map_or_else(|| "omitted".to_owned(), |value| format!("\"{value}\""))
}

/// Returns the text of the element without its content.
fn head<'t>(node: &MergeNode<'t>) -> &'t str {
    match node.element {
        Some(element) if node.content.is_some() => node.slice(element.tag_range()),
        _ => node.text(),
    }
}

/// Returns the edit that changes the attribute in ours to its value in theirs.
fn take(ours: &MergeNode<'_>, theirs: &MergeNode<'_>, name: &str) -> Option<TextEdit> {
    let (to, from) = (ours.element?, theirs.element?);
    match (to.attribute(name), from.attribute(name)) {
        (Some(old), Some(new)) if old.text() == new.text() => None,
        (Some(old), Some(new)) => Some(TextEdit { range: old.range, text: written(new, old.quote) }),
        (Some(old), None) => {
            let before = ours.source.get(..usize::from(old.name_range.start()))?;
            let blanks = TextSize::of(before) - TextSize::of(before.trim_end());
            let range = TextRange::new(old.name_range.start() - blanks, end(old));
            Some(TextEdit { range, text: String::new() })
        }
        (None, Some(new)) => {
            let insert = format!(" {name}={quote}{}{quote}", written(new, new.quote), quote = new.quote);
            Some(TextEdit { range: TextRange::empty(place(to, from, name)), text: insert })
        }
        (None, None) => None,
    }
}

/// Returns the end of the attribute in ours after which a new attribute is inserted.
fn place(to: XmlElement<'_>, from: XmlElement<'_>, name: &str) -> TextSize {
    let mut before: Vec<Attribute<'_>> = from.attributes().take_while(|attribute| attribute.name != name).collect();
    before.reverse();
    let known = before.into_iter().find_map(|attribute| to.attribute(attribute.name));
    known.map_or(to.name_range().end(), end)
}

fn end(attribute: Attribute<'_>) -> TextSize {
    attribute.range.end() + TextSize::of(attribute.quote)
}

/// Returns an attribute's value as written between this kind of quotes.
fn written(attribute: Attribute<'_>, quote: char) -> String {
    if attribute.quote == quote {
        return attribute.raw.to_owned();
    }
    escaped(&attribute.text()).replace('\'', "&apos;")
}
