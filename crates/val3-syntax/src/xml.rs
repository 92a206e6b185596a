//! Elements and attributes, as views of the tree.

use std::borrow::Cow;

use crate::never::TextSlice;
use crate::view::{TokenView, View};
use crate::{SyntaxKind, TextRange, TextSize, decode_entities};

/// An element in a file.
#[derive(Debug, Clone, Copy)]
pub struct XmlElement<'g> {
    view: View<'g>,
    tag: View<'g>,
}

/// An attribute with a value.
#[derive(Debug, Clone, Copy)]
pub struct Attribute<'g> {
    /// Name with its prefix.
    pub name: &'g str,
    /// Range of the name.
    pub name_range: TextRange,
    /// Value as written in the file, without quotes.
    pub raw: &'g str,
    /// Range of the value, without quotes.
    pub range: TextRange,
    /// Quote character of the value.
    pub quote: char,
}

/// Returns the root element of a file.
pub fn root<'g>(file: View<'g>) -> Option<XmlElement<'g>> {
    file.children().find_map(XmlElement::new)
}

impl<'g> XmlElement<'g> {
    fn new(view: View<'g>) -> Option<Self> {
        let is_element = view.kind() == SyntaxKind::ELEMENT;
        is_element.then(|| view.child(SyntaxKind::START_TAG)).flatten().map(|tag| Self { view, tag })
    }

    /// Returns the name in the start tag; empty if it is missing.
    pub fn name(self) -> &'g str {
        self.tag.token(SyntaxKind::XML_NAME).map_or("", TokenView::text)
    }

    /// Returns the range of the start tag.
    pub fn tag_range(self) -> TextRange {
        self.tag.range()
    }

    /// Returns the range of the name in the start tag.
    pub fn name_range(self) -> TextRange {
        self.tag.token(SyntaxKind::XML_NAME).map_or(self.tag.range(), TokenView::range)
    }

    /// Returns the node of the element.
    pub fn view(self) -> View<'g> {
        self.view
    }

    /// Returns the attributes with values.
    pub fn attributes(self) -> impl Iterator<Item = Attribute<'g>> {
        self.tag.children().filter_map(Attribute::new)
    }

    /// Returns the attribute called `name`.
    pub fn attribute(self, name: &str) -> Option<Attribute<'g>> {
        let children = self.tag.children();
        let mut named = children.filter(|view| view.token(SyntaxKind::XML_NAME).is_some_and(|token| token.is(name)));
        named.find_map(Attribute::new)
    }

    /// Returns the decoded value of the attribute called `name`.
    pub fn value(self, name: &str) -> Option<Cow<'g, str>> {
        self.attribute(name).map(Attribute::text)
    }

    /// Returns the child elements.
    pub fn elements(self) -> impl Iterator<Item = XmlElement<'g>> {
        self.view.children().filter_map(XmlElement::new)
    }

    /// Returns the first child element with one of these `names`.
    pub fn child(self, names: &[&str]) -> Option<XmlElement<'g>> {
        self.elements().find(|element| names.contains(&element.name()))
    }

    /// Returns the `item` elements in all `list` elements below this one: `<Programs><Program/></Programs>`.
    pub fn list(self, list: &'static str, item: &'static str) -> impl Iterator<Item = XmlElement<'g>> {
        self.elements()
            .filter(move |element| element.name() == list)
            .flat_map(XmlElement::elements)
            .filter(move |element| element.name() == item)
    }
}

impl<'g> Attribute<'g> {
    fn new(view: View<'g>) -> Option<Self> {
        if view.kind() != SyntaxKind::ATTRIBUTE {
            return None;
        }
        let name = view.token(SyntaxKind::XML_NAME)?;
        let value = view.token(SyntaxKind::XML_STRING)?;
        let text = value.text();
        let raw = text.get(1..).map_or("", |rest| rest.strip_suffix(['"', '\'']).unwrap_or(rest));
        let range = TextRange::at(value.range().start() + TextSize::new(1), TextSize::of(raw));
        let quote = text.chars().next().unwrap_or('"');
        Some(Self { name: name.text(), name_range: name.range(), raw, range, quote })
    }

    /// Returns the value with entity references replaced.
    pub fn text(self) -> Cow<'g, str> {
        decode_entities(self.raw)
    }
}

/// Returns the blanks before `at`, if nothing else precedes it on its line.
pub fn indentation(text: &str, at: TextSize) -> Option<&str> {
    let before = text.get(..usize::from(at))?;
    let line = before.rsplit(['\r', '\n']).next()?;
    (line.len() < before.len() && line.trim().is_empty()).then_some(line)
}

/// Returns the line end of a file.
pub fn line_end(text: &str) -> &'static str {
    if text.contains("\r\n") { "\r\n" } else { "\n" }
}

/// Extends an element's range to its line, if nothing else is on the line.
pub fn whole_line(text: &str, range: TextRange) -> TextRange {
    let (start, end) = (usize::from(range.start()), usize::from(range.end()));
    let before = text.part(..start);
    let rest = text.part(end..);
    let blanks = before.len() - before.trim_end_matches([' ', '\t']).len();
    let own = before.get(..start - blanks).is_some_and(|before| before.ends_with(['\n', '\r']))
        && rest.trim_start_matches([' ', '\t']).starts_with(['\r', '\n']);
    if !own {
        return range;
    }
    let line = before.part(..start - blanks);
    let line_end = if line.ends_with("\r\n") { 2 } else { 1 };
    let from = start - blanks - line_end;
    TextSize::try_from(from).map_or(range, |from| TextRange::new(from, range.end()))
}

/// Escapes a text for an attribute in double quotes or for code outside of a CDATA section.
pub fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::{root, whole_line};
    use crate::{TextRange, TextSize};

    #[test]
    fn elements_and_attributes() {
        let text = "<a><b x='1' y=\"&lt;2&gt;\" z=\"\"/><c><b/></c></a>";
        let parse = crate::parse(text);
        let root = root(parse.view()).unwrap();
        let b = root.child(&["b"]).unwrap();
        let shown = b.attributes().map(|found| format!("{}={} at {:?}", found.name, found.text(), found.range));
        assert_eq!(shown.collect::<Vec<_>>(), ["x=1 at 9..10", "y=<2> at 15..24", "z= at 29..29"]);
        assert_eq!(root.list("c", "b").count(), 1);
        assert!(b.value("w").is_none() && root.child(&["d"]).is_none());
    }

    #[test]
    fn the_line_of_an_entry() {
        assert_eq!(line_of("<e/>"), "\r\n  <e/>");
        assert_eq!(line_of("<f/>"), "<f/>");
    }

    fn line_of(part: &str) -> &str {
        let text = "<L>\r\n  <e/>\r\n  <f/></L>";
        let at = TextSize::try_from(text.find(part).unwrap()).unwrap();
        &text[std::ops::Range::<usize>::from(whole_line(text, TextRange::at(at, TextSize::of(part))))]
    }
}
