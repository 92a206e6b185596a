//! Format of a data file, and elements written in this format.

use std::cell::OnceCell;

use val3_syntax::xml::{self, XmlElement};
use val3_syntax::{TextRange, TextSize, TextSlice, text_size};

use crate::{SavedContainer, SavedContent, SavedData, SavedValue, tag};

/// One level of indentation in XML written by the tools.
const LEVEL: &str = "  ";

#[derive(Debug)]
pub(crate) struct DataLayout<'t> {
    pub(crate) text: &'t str,
    root: XmlElement<'t>,
    /// Tag end for elements without content.
    pub(crate) close: &'static str,
    line_end: &'static str,
    spells_defaults: OnceCell<bool>,
}

impl<'t> DataLayout<'t> {
    pub(crate) fn of(text: &'t str, root: XmlElement<'t>) -> Self {
        let close = if text.contains("/>") && !text.contains(" />") { "/>" } else { " />" };
        Self { text, root, close, line_end: xml::line_end(text), spells_defaults: OnceCell::new() }
    }

    /// Whether most defaults in the file are explicit, as in generated files. The vendor's tools omit them.
    pub(crate) fn spells_defaults(&self) -> bool {
        *self.spells_defaults.get_or_init(|| {
            let counts = self.root.list("Datas", "Data").map(tag::count_defaults);
            let (spelt, omitted) = counts.fold((0, 0), |(spelt, omitted), of| (spelt + of.0, omitted + of.1));
            spelt > omitted
        })
    }

    /// Whether variables without values have an end tag in this file.
    pub(crate) fn has_empty_elements(&self, name: &str) -> bool {
        let mut data = elements(self.root).filter(|data| data.name() == name);
        data.find(is_empty).is_some_and(|data| self.has_end_tag(data))
    }

    fn has_end_tag(&self, element: XmlElement<'_>) -> bool {
        !self.slice(element.tag_range()).ends_with("/>")
    }

    /// End of a variable's start tag if it has content. The controller writes a space there. `None` if the file has no
    /// such tag.
    pub(crate) fn open(&self) -> Option<&'static str> {
        let tag = elements(self.root).find(|data| self.has_end_tag(*data)).map(|data| self.slice(data.tag_range()))?;
        Some(if tag.ends_with(" >") { " >" } else { ">" })
    }

    /// Whether the element contains only elements and whitespace.
    pub(crate) fn is_plain(&self, element: XmlElement<'_>) -> bool {
        let mut from = element.tag_range().end();
        for inner in element.elements() {
            let range = inner.view().range();
            if !self.is_blank(from, range.start()) {
                return false;
            }
            from = range.end();
        }
        let range = element.view().range();
        let tag = self.slice(range).rfind("</").filter(|_| self.has_end_tag(element));
        let close = tag.map_or(range.end(), |at| range.start() + text_size(at));
        self.is_blank(from, close)
    }

    /// Whether the text between the offsets is whitespace, or `to` is not after `from`.
    fn is_blank(&self, from: TextSize, to: TextSize) -> bool {
        self.slice(TextRange::new(from, to.max(from))).trim().is_empty()
    }

    pub(crate) fn slice(&self, range: TextRange) -> &'t str {
        self.text.part(usize::from(range.start())..usize::from(range.end()))
    }

    /// Child element of the element at `outer`, on separate lines if the file uses separate lines.
    pub(crate) fn inside(&self, outer: TextSize, lines: &[String]) -> String {
        match xml::indentation(self.text, outer) {
            Some(blanks) => self.lines(&format!("{blanks}{LEVEL}"), lines),
            None => lines.iter().map(|line| line.trim_start()).collect(),
        }
    }

    /// Lines next to an element, at its indentation.
    pub(crate) fn beside(&self, neighbour: TextSize, lines: &[String]) -> String {
        match xml::indentation(self.text, neighbour) {
            Some(blanks) => self.lines(blanks, lines),
            None => lines.iter().map(|line| line.trim_start()).collect(),
        }
    }

    fn lines(&self, blanks: &str, lines: &[String]) -> String {
        lines.iter().map(|line| format!("{}{blanks}{line}", self.line_end)).collect()
    }

    /// Edit that inserts `lines` into an element that contains only whitespace. The replaced range starts after the
    /// last attribute.
    pub(crate) fn filled(&self, element: XmlElement<'_>, lines: &[String]) -> (TextRange, String) {
        let at = element.tag_range().start();
        let tag = self.slice(element.tag_range());
        let (start, open) = match tag.strip_suffix("/>") {
            Some(head) => (at + size(head.trim_end()), self.open().unwrap_or(">")),
            None => (element.tag_range().end(), ""),
        };
        let text = format!("{open}{}{}</{}>", self.inside(at, lines), self.line_before(at), element.name());
        (TextRange::new(start, element.view().range().end()), text)
    }

    /// Like [`filled`](Self::filled), but without content.
    pub(crate) fn emptied(&self, element: XmlElement<'_>) -> (TextRange, String) {
        self.closed(element, self.has_empty_elements(element.name()))
    }

    /// Like [`emptied`](Self::emptied), for a list of declarations.
    pub(crate) fn emptied_list(&self, list: XmlElement<'_>) -> (TextRange, String) {
        let mut others = self.root.elements().filter(is_empty);
        let has_end_tag = match others.next() {
            Some(other) => self.has_end_tag(other),
            None => self.has_empty_elements("Data"),
        };
        self.closed(list, has_end_tag)
    }

    fn closed(&self, element: XmlElement<'_>, has_end_tag: bool) -> (TextRange, String) {
        let tag = element.tag_range();
        let end = element.view().range().end();
        if has_end_tag {
            return (TextRange::new(tag.end(), end), format!("{}</{}>", self.line_before(tag.start()), element.name()));
        }
        let head = self.slice(tag).trim_end_matches(['>', '/']).trim_end();
        (TextRange::new(tag.start() + size(head), end), self.close.to_owned())
    }

    /// Line end and indentation before an end tag on its own line.
    fn line_before(&self, at: TextSize) -> String {
        xml::indentation(self.text, at).map(|blanks| format!("{}{blanks}", self.line_end)).unwrap_or_default()
    }

    /// Lines of a new value.
    pub(crate) fn value(&self, data: &SavedData, value: &SavedValue) -> Vec<String> {
        let key = tag::escaped(&value.key, '"');
        match &value.content {
            SavedContent::Attributes(_) => {
                let attributes = tag::attributes(&data.type_name, value);
                vec![format!("<Value key=\"{key}\"{attributes}{}", self.close)]
            }
            SavedContent::Fields(fields) if fields.is_empty() => vec![format!("<Value key=\"{key}\"{}", self.close)],
            SavedContent::Fields(fields) => {
                let fields = fields.iter().flat_map(|field| self.field(&field.data));
                let open = self.open().unwrap_or(">");
                enclosed(format!("<Value key=\"{key}\"{open}"), fields, "</Value>")
            }
        }
    }

    /// Lines of a new field.
    pub(crate) fn field(&self, data: &SavedData) -> Vec<String> {
        self.container("Field", "", data)
    }

    /// Lines of new data.
    pub(crate) fn data(&self, data: &SavedData, is_public: bool) -> Vec<String> {
        self.container("Data", if is_public { " access=\"public\"" } else { " access=\"private\"" }, data)
    }

    /// Lines of a new element with values. `access` is a text for the start tag.
    fn container(&self, element: &str, access: &str, data: &SavedData) -> Vec<String> {
        let shape = match &data.shape {
            SavedContainer::Keys => format!("xsi:type=\"collection\" type=\"{}\"", data.type_name),
            SavedContainer::Sizes(sizes) => {
                format!("xsi:type=\"array\" type=\"{}\" size=\"{}\"", data.type_name, spaced(sizes))
            }
        };
        let head = format!("<{element} name=\"{}\"{access} {shape}", data.name);
        let spelt = |value: &&SavedValue| data.shape == SavedContainer::Keys || !value.is_default(&data.type_name);
        let mut values = data.values.iter().filter(spelt).peekable();
        if values.peek().is_none() {
            return vec![format!("{head}{}", self.close)];
        }
        let open = self.open().unwrap_or(">");
        enclosed(format!("{head}{open}"), values.flat_map(|value| self.value(data, value)), &format!("</{element}>"))
    }
}

fn is_empty(element: &XmlElement<'_>) -> bool {
    element.elements().next().is_none()
}

fn size(text: &str) -> TextSize {
    text_size(text.len())
}

fn enclosed(start: String, inner: impl Iterator<Item = String>, end: &str) -> Vec<String> {
    let inner = inner.map(|line| format!("{LEVEL}{line}"));
    std::iter::once(start).chain(inner).chain([end.to_owned()]).collect()
}

/// Sizes as spelled in files.
pub(crate) fn spaced(sizes: &[u32]) -> String {
    sizes.iter().map(u32::to_string).collect::<Vec<_>>().join(" ")
}

/// Elements that declare data: in `<Datas>`, or in all sections of s5 and s6.
pub(crate) fn elements(root: XmlElement<'_>) -> impl Iterator<Item = XmlElement<'_>> {
    let is_new = root.name() == "Database";
    let lists = root.elements().filter(move |list| !is_new || list.name() == "Datas");
    lists.flat_map(XmlElement::elements).filter(move |element| !is_new || element.name() == "Data")
}
