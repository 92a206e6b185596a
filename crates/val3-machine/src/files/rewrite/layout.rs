//! How a file is laid out, and elements written in that way.

use val3_syntax::xml::{self, Element};
use val3_syntax::{TextRange, TextSize};

use super::super::{Content, SavedData, SavedValue, Shape};
use super::tag;

/// One level of indentation in the XML that the tools write.
const LEVEL: &str = "  ";

#[derive(Debug)]
pub(super) struct Layout<'t> {
    pub(super) text: &'t str,
    /// How an element without content ends.
    pub(super) close: &'static str,
    line_end: &'static str,
}

impl<'t> Layout<'t> {
    pub(super) fn of(text: &'t str) -> Self {
        let close = if text.contains("/>") && !text.contains(" />") { "/>" } else { " />" };
        Self { text, close, line_end: xml::line_end(text) }
    }

    pub(super) fn slice(&self, range: TextRange) -> &'t str {
        self.text.get(usize::from(range.start())..usize::from(range.end())).unwrap_or("")
    }

    /// The lines of an element inside of the one at `outer`, each on a line of its own where the file is written so.
    pub(super) fn inside(&self, outer: TextSize, lines: &[String]) -> String {
        match xml::indentation(self.text, outer) {
            Some(blanks) => self.lines(&format!("{blanks}{LEVEL}"), lines),
            None => lines.iter().map(|line| line.trim_start()).collect(),
        }
    }

    /// The lines around an element.
    pub(super) fn beside(&self, neighbour: TextSize, lines: &[String]) -> String {
        match xml::indentation(self.text, neighbour) {
            Some(blanks) => self.lines(blanks, lines),
            None => lines.iter().map(|line| line.trim_start()).collect(),
        }
    }

    fn lines(&self, blanks: &str, lines: &[String]) -> String {
        lines.iter().map(|line| format!("{}{blanks}{line}", self.line_end)).collect()
    }

    /// The text from the last attribute of the start tag to the end of the element.
    pub(super) fn tail(&self, element: Element<'_>) -> TextRange {
        let tag = self.slice(element.tag_range());
        let head = tag.strip_suffix("/>").map_or_else(|| tag.len(), |head| head.trim_end().len());
        let start = element.tag_range().start() + TextSize::try_from(head).unwrap_or_default();
        TextRange::new(start, element.view().range().end())
    }

    /// An element that has this start tag and holds these lines.
    pub(super) fn filled(&self, element: Element<'_>, lines: &[String]) -> String {
        let at = element.tag_range().start();
        let tag = self.slice(element.tag_range());
        let open = if tag.ends_with("/>") { ">" } else { "" };
        let end = xml::indentation(self.text, at).map(|blanks| format!("{}{blanks}", self.line_end));
        format!("{open}{}{}</{}>", self.inside(at, lines), end.unwrap_or_default(), element.name())
    }

    /// A new value, line by line.
    pub(super) fn value(&self, data: &SavedData, value: &SavedValue) -> Vec<String> {
        let key = tag::escaped(&value.key);
        match &value.content {
            Content::Attributes(_) => {
                let attributes = tag::attributes(&data.type_name, value);
                vec![format!("<Value key=\"{key}\"{attributes}{}", self.close)]
            }
            Content::Fields(fields) => {
                let fields = fields.iter().flat_map(|field| self.field(&field.data));
                enclosed(format!("<Value key=\"{key}\">"), fields, "</Value>")
            }
        }
    }

    /// A new field, line by line.
    pub(super) fn field(&self, data: &SavedData) -> Vec<String> {
        let shape = match &data.shape {
            Shape::Keys => format!("xsi:type=\"collection\" type=\"{}\"", data.type_name),
            Shape::Sizes(sizes) => format!("xsi:type=\"array\" type=\"{}\" size=\"{}\"", data.type_name, spaced(sizes)),
        };
        let head = format!("<Field name=\"{}\" {shape}", data.name);
        let spelt = |value: &&SavedValue| data.shape == Shape::Keys || !value.is_default(&data.type_name);
        let mut values = data.values.iter().filter(spelt).peekable();
        if values.peek().is_none() {
            return vec![format!("{head}{}", self.close)];
        }
        enclosed(format!("{head}>"), values.flat_map(|value| self.value(data, value)), "</Field>")
    }
}

fn enclosed(start: String, inner: impl Iterator<Item = String>, end: &str) -> Vec<String> {
    let inner = inner.map(|line| format!("{LEVEL}{line}"));
    std::iter::once(start).chain(inner).chain([end.to_owned()]).collect()
}

/// Sizes as files spell them.
pub(super) fn spaced(sizes: &[u32]) -> String {
    sizes.iter().map(u32::to_string).collect::<Vec<_>>().join(" ")
}
