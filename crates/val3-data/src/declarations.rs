//! Removing, copying and inserting declarations of data.

use rustc_hash::FxHashSet;
use val3_syntax::xml::{self, XmlElement};
use val3_syntax::{TextEdit, TextRange, TextSize};

use crate::edits::Edits;
use crate::layout::{DataLayout, elements};
use crate::tag;

/// Edits that remove `data`, with their lines. A list that becomes empty is written like other empty lists in the file.
#[must_use]
pub fn remove(text: &str, root: XmlElement<'_>, data: &[XmlElement<'_>]) -> Vec<TextEdit> {
    let layout = DataLayout::of(text, root);
    let removed: FxHashSet<TextRange> = data.iter().map(|data| data.view().range()).collect();
    let mut edits = Edits::default();
    for list in root.elements() {
        let (gone, kept): (Vec<_>, Vec<_>) = list.elements().partition(|data| removed.contains(&data.view().range()));
        if !gone.is_empty() && kept.is_empty() && layout.is_plain(list) {
            let (range, text) = layout.emptied_list(list);
            edits.replace(range, text);
        } else {
            gone.iter().for_each(|data| edits.replace(xml::whole_line(text, data.view().range()), String::new()));
        }
    }
    edits.sorted()
}

/// Edit that inserts a copy of `data` with another name after it.
#[must_use]
pub fn duplicate(text: &str, root: XmlElement<'_>, data: XmlElement<'_>, name: &str) -> Option<TextEdit> {
    let layout = DataLayout::of(text, root);
    let range = data.view().range();
    let attribute = data.attribute("name")?;
    let renamed = TextEdit { range: attribute.range - range.start(), text: tag::escaped(name, attribute.quote) };
    let copy = TextEdit::apply_all(layout.slice(range), &[renamed]);
    Some(after(text, root, data, &[copy]))
}

/// Edit that inserts lines after `data`.
#[must_use]
pub fn after(text: &str, root: XmlElement<'_>, data: XmlElement<'_>, lines: &[String]) -> TextEdit {
    let insert = DataLayout::of(text, root).beside(data.tag_range().start(), lines);
    TextEdit { range: TextRange::empty(data.view().range().end()), text: insert }
}

/// Edit that renames the key of a value.
#[must_use]
pub fn rename_key(value: XmlElement<'_>, key: &str) -> Option<TextEdit> {
    let attribute = value.attribute("key")?;
    Some(TextEdit { range: attribute.range, text: tag::escaped(key, attribute.quote) })
}

/// Lines of a declaration in the format of the file: the order and the quotes of attributes, the ends of tags, and
/// variables without values.
#[must_use]
pub fn in_style(text: &str, root: XmlElement<'_>, lines: Vec<String>) -> Vec<String> {
    let layout = DataLayout::of(text, root);
    let mut lines = lines.into_iter();
    let Some(first) = lines.next() else { return Vec::new() };
    let head = ordered(&layout, root, &first);
    let styled = std::iter::once(head).chain(lines).map(|line| ended(&layout, line));
    let mut styled: Vec<String> = styled.collect();
    let name = first.trim_start_matches('<').split([' ', '>', '/']).next().unwrap_or("").to_owned();
    if let [only] = styled.as_mut_slice()
        && layout.has_empty_elements(&name)
        && let Some(head) = only.strip_suffix("/>")
    {
        let open = layout.open().unwrap_or(">");
        *only = format!("{}{open}", head.trim_end());
        styled.push(format!("</{name}>"));
    }
    styled
}

/// Adapts the tag end in a line to the format of the file.
fn ended(layout: &DataLayout<'_>, line: String) -> String {
    let has_attributes = line.contains('=');
    match (line.strip_suffix("/>"), line.strip_suffix('>'), layout.open()) {
        (Some(head), ..) => format!("{}{}", head.trim_end(), layout.close),
        (None, Some(head), Some(open)) if has_attributes => format!("{}{open}", head.trim_end()),
        _ => line,
    }
}

/// A start tag with its attributes ordered as in the first declaration of the same kind. A missing attribute that other
/// declarations have (`privilege` in s6) gets its default.
fn ordered(layout: &DataLayout<'_>, root: XmlElement<'_>, line: &str) -> String {
    let parse = val3_syntax::parse(line);
    let Some(own) = xml::root(parse.view()) else { return line.to_owned() };
    let alike =
        elements(root).find(|other| other.name() == own.name() && other.value("xsi:type") == own.value("xsi:type"));
    let Some(model) = alike.or_else(|| elements(root).next()) else { return line.to_owned() };
    let mut attributes: Vec<_> = own.attributes().collect();
    let place = |name: &str| model.attributes().position(|other| other.name == name).unwrap_or(usize::MAX);
    attributes.sort_by_key(|attribute| place(attribute.name));
    let quote = model.attributes().next().map_or('"', |attribute| attribute.quote);
    let mut written: Vec<String> = attributes
        .iter()
        .map(|found| format!(" {}={quote}{}{quote}", found.name, tag::escaped(&found.text(), quote)))
        .collect();
    let privilege = model.attribute(PRIVILEGE).filter(|_| own.attribute(PRIVILEGE).is_none());
    if let Some(found) = privilege {
        let place = place(PRIVILEGE).min(written.len());
        written.insert(place, format!(" {}={quote}0{quote}", found.name));
    }
    let after =
        own.attributes().last().map_or(own.name_range().end(), |last| last.range.end() + TextSize::of(last.quote));
    let end = line.get(usize::from(after)..).unwrap_or(layout.close);
    format!("<{}{}{end}", own.name(), written.concat())
}

/// An attribute of s6 that occurs only in some files.
const PRIVILEGE: &str = "privilege";
