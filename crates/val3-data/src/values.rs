//! `Data` and `Field` elements of s7 and s8.

use std::borrow::Cow;

use rustc_hash::{FxHashMap, FxHashSet};
use val3_syntax::TextSize;
use val3_syntax::xml::{self, XmlElement};

use crate::edits::Edits;
use crate::layout::{DataLayout, spaced};
use crate::{SavedContainer, SavedContent, SavedData, SavedField, SavedValue, tag};

/// Writes the values of a variable or field into its element.
pub(crate) fn data(edits: &mut Edits, layout: &DataLayout<'_>, element: XmlElement<'_>, data: &SavedData) {
    if let SavedContainer::Sizes(sizes) = &data.shape
        && !data.is_part
    {
        size(edits, element, sizes);
    }
    let values: FxHashMap<&str, &SavedValue> = data.values.iter().map(|value| (value.key.as_str(), value)).collect();
    let value = |found: XmlElement<'_>| values.get(key(found).as_ref()).copied();
    let (kept, removed): (Vec<_>, Vec<_>) =
        spelt(element).partition(|found| stays(layout, data, *found, value(*found)));
    let known: FxHashSet<Cow<'_, str>> = kept.iter().chain(&removed).map(|found| key(*found)).collect();
    let spelt_values = data.values.iter().filter(|value| is_spelt(data, value));
    let added: Vec<_> = spelt_values.filter(|value| !known.contains(value.key.as_str())).collect();
    if kept.is_empty() && (!added.is_empty() || !removed.is_empty()) && layout.is_plain(element) {
        return refill(edits, layout, element, data, &added);
    }
    for found in removed {
        edits.replace(xml::whole_line(layout.text, found.view().range()), String::new());
    }
    for found in &kept {
        if let Some(value) = value(*found) {
            change(edits, layout, data, *found, value);
        }
    }
    if !added.is_empty() {
        NewValues { element, data, kept: &kept, added: &added }.insert(edits, layout);
    }
}

/// New values of a variable or field.
struct NewValues<'a, 'g> {
    element: XmlElement<'g>,
    data: &'a SavedData,
    /// Existing values that remain.
    kept: &'a [XmlElement<'g>],
    added: &'a [&'a SavedValue],
}

impl NewValues<'_, '_> {
    /// Inserts the values in order, each after the last existing value that precedes it.
    fn insert(&self, edits: &mut Edits, layout: &DataLayout<'_>) {
        // Minimum order from each element to the end. It is ascending, which allows a binary search for the last
        // element before a value.
        let mut least: Vec<_> = self.kept.iter().map(|found| order(self.data, &key(*found))).collect();
        for at in (1..least.len()).rev() {
            let (before, after) = least.split_at_mut(at);
            if let (Some(before), Some(after)) = (before.last_mut(), after.first()) {
                *before = (*before).min(*after);
            }
        }
        for value in self.added {
            let order = order(self.data, &value.key);
            let count = least.partition_point(|least| *least <= order);
            let before = count.checked_sub(1).and_then(|last| self.kept.get(last));
            let lines = layout.value(self.data, value);
            let text = match before.or(self.kept.first()) {
                Some(neighbour) => layout.beside(neighbour.tag_range().start(), &lines),
                None => layout.inside(self.element.tag_range().start(), &lines),
            };
            let at = before.map_or(self.element.tag_range().end(), |before| before.view().range().end());
            edits.insert(at, text);
        }
    }
}

fn spelt<'g>(element: XmlElement<'g>) -> impl Iterator<Item = XmlElement<'g>> {
    element.elements().filter(|found| found.name() == "Value")
}

/// Key of a value; an index has no spaces.
fn key<'g>(value: XmlElement<'g>) -> Cow<'g, str> {
    value.value("key").unwrap_or_default()
}

/// Sort key for a value: its indexes in an array; constant in a collection, which keeps the given order.
fn order(data: &SavedData, key: &str) -> [Option<u32>; 3] {
    let mut order = [None; 3];
    if matches!(data.shape, SavedContainer::Sizes(_)) {
        order.iter_mut().zip(indices(key)).for_each(|(at, index)| *at = Some(index));
    }
    order
}

fn indices(key: &str) -> impl Iterator<Item = u32> {
    key.split(',').filter_map(|index| index.trim().parse().ok())
}

fn fits(sizes: &[u32], key: &str) -> bool {
    indices(key).count() == sizes.len() && indices(key).zip(sizes).all(|(index, size)| index < *size)
}

fn size(edits: &mut Edits, element: XmlElement<'_>, sizes: &[u32]) {
    let Some(attribute) = element.attribute("size") else {
        return missing_size(edits, element, sizes);
    };
    let old = attribute.text().split_whitespace().filter_map(|size| size.parse().ok()).collect::<Vec<u32>>();
    if old != sizes {
        edits.replace(attribute.range, spaced(sizes));
    }
}

/// Adds a missing array size, which every writer includes. Without a size, there is one value.
fn missing_size(edits: &mut Edits, element: XmlElement<'_>, sizes: &[u32]) {
    let last = element.attributes().last().filter(|_| sizes != [1]);
    if let Some(last) = last {
        edits.insert(last.range.end() + TextSize::of(last.quote), format!(" size=\"{}\"", spaced(sizes)));
    }
}

/// Whether the element is kept, unchanged or with the new `value`.
fn stays(layout: &DataLayout<'_>, data: &SavedData, found: XmlElement<'_>, value: Option<&SavedValue>) -> bool {
    match (&data.shape, value) {
        (_, None) if data.is_part => true,
        (SavedContainer::Keys, value) => value.is_some(),
        (SavedContainer::Sizes(sizes), _) if !fits(sizes, &key(found)) => false,
        (_, None) => tag::is_default(&data.type_name, found),
        (_, Some(SavedValue { content: SavedContent::Fields(_), .. })) => true,
        (_, Some(value)) => {
            let spells = || value.has_texts() && tag::spells_another(layout, &data.type_name, found, "");
            tag::is_same(&data.type_name, found, value) || !value.is_default(&data.type_name) || spells()
        }
    }
}

/// Whether the value requires an element.
fn is_spelt(data: &SavedData, value: &SavedValue) -> bool {
    data.shape == SavedContainer::Keys || !value.is_default(&data.type_name)
}

/// Replaces all existing values, if none of them is kept and the element has no other content.
fn refill(
    edits: &mut Edits,
    layout: &DataLayout<'_>,
    element: XmlElement<'_>,
    data: &SavedData,
    added: &[&SavedValue],
) {
    let lines: Vec<String> = added.iter().flat_map(|value| layout.value(data, value)).collect();
    let (range, text) = if lines.is_empty() { layout.emptied(element) } else { layout.filled(element, &lines) };
    edits.replace(range, text);
}

fn change(edits: &mut Edits, layout: &DataLayout<'_>, data: &SavedData, found: XmlElement<'_>, value: &SavedValue) {
    match &value.content {
        SavedContent::Fields(fields) if found.elements().next().is_some() => self::fields(edits, layout, found, fields),
        SavedContent::Fields(_) if value.is_default(&data.type_name) => {}
        SavedContent::Fields(_) => {
            let lines = layout.value(data, value);
            let text = layout.beside(found.tag_range().start(), &lines);
            edits.replace(found.view().range(), text.trim_start().to_owned());
        }
        SavedContent::Attributes(_) => tag::change(edits, layout, &data.type_name, found, value),
    }
}

/// Writes the fields of a value whose element contains fields.
fn fields(edits: &mut Edits, layout: &DataLayout<'_>, value: XmlElement<'_>, fields: &[SavedField]) {
    for found in value.elements() {
        match fields.iter().find(|field| is_of(found, field)) {
            Some(field) => data(edits, layout, found, &field.data),
            None => edits.replace(xml::whole_line(layout.text, found.view().range()), String::new()),
        }
    }
    let missing = fields.iter().filter(|field| !field.initial && !value.elements().any(|found| is_of(found, field)));
    let lines: Vec<String> = missing.flat_map(|field| layout.field(&field.data)).collect();
    if let Some(last) = value.elements().last().filter(|_| !lines.is_empty()) {
        let text = layout.beside(last.tag_range().start(), &lines);
        edits.insert(last.view().range().end(), text);
    }
}

/// Whether the element contains the field.
fn is_of(element: XmlElement<'_>, field: &SavedField) -> bool {
    element.value("name").is_some_and(|name| name == *field.data.name)
}
