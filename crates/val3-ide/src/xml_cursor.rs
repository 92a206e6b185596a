//! Syntactic position in the XML of a file. A tag is usually incomplete while it is typed, so this module reads the
//! text instead of the tree. The text before the position is interpreted independently of the text after it.

use memchr::{memchr, memmem};
use val3_syntax::{TextRange, TextSize, TextSlice, text_at, text_size};

/// A start tag, possibly incomplete.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub(crate) struct Tag<'t> {
    /// Element name.
    pub(crate) name: &'t str,
    /// Attribute names and raw values.
    pub(crate) attributes: Vec<(&'t str, &'t str)>,
}

impl<'t> Tag<'t> {
    /// Raw attribute value.
    pub(crate) fn value(&self, name: &str) -> Option<&'t str> {
        self.attributes.iter().find(|(known, _)| *known == name).map(|(_, value)| *value)
    }
}

/// Syntactic context of a position.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum XmlPlace<'t> {
    /// Text between tags, with the word at the position.
    Content(TextRange),
    /// A start tag's name.
    ElementName(TextRange),
    /// An end tag's name.
    EndTag(TextRange),
    /// An attribute name; empty between attributes.
    AttributeName(TextRange),
    /// The value of the attribute with this name, without quotes.
    Value(&'t str, TextRange),
}

/// A position in XML.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct XmlCursor<'t> {
    /// Elements around the position, from the outermost to the innermost.
    pub(crate) open: Vec<Tag<'t>>,
    /// Tag that contains the position.
    pub(crate) tag: Option<Tag<'t>>,
    /// Syntactic context.
    pub(crate) place: XmlPlace<'t>,
    /// Other children of the innermost element, in order, with their attributes.
    pub(crate) siblings: Vec<Tag<'t>>,
}

impl<'t> XmlCursor<'t> {
    /// Context at `offset` of a text; `None` in a comment, a declaration or a CDATA section.
    pub(crate) fn at(text: &'t str, offset: TextSize) -> Option<Self> {
        let mut scan = Scan { text, open: Vec::new(), siblings: vec![Vec::new()] };
        let (at, end) = scan.find(usize::from(offset))?;
        let depth = scan.open.len();
        let (open, before) = (scan.open.clone(), scan.siblings.last().cloned().unwrap_or_default());
        scan.siblings = vec![Vec::new()];
        let after = scan.rest(end, depth);
        let siblings = before.into_iter().chain(after).collect();
        Some(Self { open, tag: at.tag, place: at.place, siblings })
    }

    /// Innermost element around the position.
    pub(crate) fn parent(&self) -> Option<&Tag<'t>> {
        self.open.last()
    }

    /// Whether the innermost element contains another element of this name.
    pub(crate) fn has_sibling(&self, name: &str) -> bool {
        self.siblings.iter().any(|sibling| sibling.name == name)
    }

    /// Whether another child of the innermost element has this raw attribute value.
    pub(crate) fn has_sibling_with(&self, attribute: &str, value: &str) -> bool {
        self.siblings.iter().any(|sibling| sibling.value(attribute) == Some(value))
    }

    /// The tag that contains the position, and the elements around it, innermost first.
    pub(crate) fn around(&self) -> impl Iterator<Item = &Tag<'t>> {
        self.tag.iter().chain(self.open.iter().rev())
    }
}

/// Context found at a position.
struct FoundContext<'t> {
    tag: Option<Tag<'t>>,
    place: XmlPlace<'t>,
}

/// A piece of markup that begins with `<`.
enum Markup<'t> {
    /// A comment, a declaration or a CDATA section.
    Other,
    End {
        name: &'t str,
    },
    Start {
        tag: StartTag<'t>,
        opens: bool,
    },
}

struct StartTag<'t> {
    name: TextRange,
    /// Ranges of the attribute names and values.
    attributes: Vec<(TextRange, TextRange)>,
    read: Tag<'t>,
}

struct Scan<'t> {
    text: &'t str,
    open: Vec<Tag<'t>>,
    /// Children read so far, for the file and for each open element.
    siblings: Vec<Vec<Tag<'t>>>,
}

impl<'t> Scan<'t> {
    /// Scans the markup up to a position. Returns the context and the markup's end.
    fn find(&mut self, offset: usize) -> Option<(FoundContext<'t>, usize)> {
        let mut at = 0;
        loop {
            let start = self.next_angle(at).filter(|start| *start < offset);
            let Some(start) = start else {
                let place = XmlPlace::Content(word_around(self.text, offset));
                return Some((FoundContext { tag: None, place }, offset));
            };
            let (markup, end) = markup(self.text, start);
            if offset < end || offset == end && !self.is_closed(end) {
                return Some((self.inside(markup, start, offset)?, end));
            }
            self.enter(markup);
            at = end;
        }
    }

    /// Whether the text before `end` ends a tag.
    fn is_closed(&self, end: usize) -> bool {
        self.text.get(..end).is_some_and(|before| before.ends_with('>'))
    }

    fn next_angle(&self, from: usize) -> Option<usize> {
        memchr(b'<', self.text.as_bytes().get(from..)?).map(|at| from + at)
    }

    /// Context of a position inside a piece of markup.
    fn inside(&self, markup: Markup<'t>, start: usize, offset: usize) -> Option<FoundContext<'t>> {
        let position = size(offset);
        match markup {
            Markup::Other => None,
            Markup::End { name } => {
                let range = TextRange::at(size(start + 2), TextSize::of(name));
                let place = XmlPlace::EndTag(range);
                range.contains_inclusive(position).then_some(FoundContext { tag: None, place })
            }
            Markup::Start { tag, .. } => {
                let place = tag.place(self.text, position);
                Some(FoundContext { tag: Some(tag.read), place })
            }
        }
    }

    fn enter(&mut self, markup: Markup<'t>) {
        match markup {
            Markup::Other => {}
            // An end tag without an open element is ignored.
            Markup::End { name } => {
                if let Some(at) = self.open.iter().rposition(|open| open.name == name) {
                    self.open.truncate(at);
                    self.siblings.truncate(at + 1);
                }
            }
            Markup::Start { tag, opens } => {
                if let Some(siblings) = self.siblings.last_mut() {
                    siblings.push(tag.read.clone());
                }
                if opens {
                    self.open.push(tag.read);
                    self.siblings.push(Vec::new());
                }
            }
        }
    }

    /// Children after `from` in the innermost of `depth` open elements.
    fn rest(&mut self, from: usize, depth: usize) -> Vec<Tag<'t>> {
        // Children of outer elements are not collected.
        self.siblings = vec![Vec::new(); depth + 1];
        let mut at = from;
        while let Some(start) = self.next_angle(at) {
            let (markup, end) = markup(self.text, start);
            if matches!(&markup, Markup::End { name } if self.open.len() == depth && self.open.last().is_some_and(|open| open.name == *name))
            {
                break;
            }
            self.enter(markup);
            if self.open.len() < depth {
                break;
            }
            at = end;
        }
        self.siblings.get_mut(depth).map(std::mem::take).unwrap_or_default()
    }
}

impl<'t> StartTag<'t> {
    fn place(&self, text: &'t str, position: TextSize) -> XmlPlace<'t> {
        if self.name.contains_inclusive(position) {
            return XmlPlace::ElementName(self.name);
        }
        for (name, value) in &self.attributes {
            if name.contains_inclusive(position) {
                return XmlPlace::AttributeName(*name);
            }
            if value.contains_inclusive(position) {
                return XmlPlace::Value(slice(text, *name), *value);
            }
        }
        XmlPlace::AttributeName(TextRange::empty(position))
    }
}

/// Piece of markup at `start`, and its end.
fn markup(text: &str, start: usize) -> (Markup<'_>, usize) {
    let rest = text.part(start..);
    for (open, close) in [("<!--", "-->"), ("<![CDATA[", "]]>"), ("<?", "?>"), ("<!", ">")] {
        if let Some(inside) = rest.strip_prefix(open) {
            let end = memmem::find(inside.as_bytes(), close.as_bytes()).map(|at| open.len() + at + close.len());
            return (Markup::Other, start + end.unwrap_or(rest.len()));
        }
    }
    if let Some(inside) = rest.strip_prefix("</") {
        let name = name_at(inside);
        let behind = inside.part(name.len()..);
        let blanks = behind.len() - behind.trim_start().len();
        let closed = usize::from(behind.trim_start().starts_with('>'));
        let end = start + 2 + name.len() + if closed > 0 { blanks + 1 } else { 0 };
        return (Markup::End { name }, end);
    }
    start_tag(text, start)
}

fn start_tag(text: &str, start: usize) -> (Markup<'_>, usize) {
    let mut at = start + 1;
    let name = name_at(text.part(at..));
    let name_range = TextRange::at(size(at), TextSize::of(name));
    at += name.len();
    let read = Tag { name, attributes: Vec::new() };
    let mut tag = StartTag { name: name_range, attributes: Vec::new(), read };
    loop {
        let rest = text.part(at..);
        let blanks = rest.len() - rest.trim_start().len();
        at += blanks;
        let rest = rest.trim_start();
        if rest.starts_with("/>") || rest.starts_with('>') {
            let opens = rest.starts_with('>');
            return (Markup::Start { tag, opens }, at + if opens { 1 } else { 2 });
        }
        let Some(next) = rest.chars().next().filter(|next| *next != '<') else {
            // The tag is incomplete, so the text on later lines does not belong to it.
            return (Markup::Start { tag, opens: false }, at);
        };
        let name = name_at(rest);
        if name.is_empty() {
            at += next.len_utf8();
            continue;
        }
        let (value, end) = value_at(text, at + name.len());
        tag.attributes.push((TextRange::at(size(at), TextSize::of(name)), value));
        tag.read.attributes.push((name, slice(text, value)));
        at = end;
    }
}

/// Range of the value after an attribute name, without quotes, and its end. A missing value is empty.
fn value_at(text: &str, name_end: usize) -> (TextRange, usize) {
    let none = (TextRange::empty(size(name_end)), name_end);
    let rest = text.part(name_end..);
    let Some(behind) = rest.trim_start().strip_prefix('=') else { return none };
    let Some(quote) = behind.trim_start().chars().next().filter(|quote| matches!(quote, '"' | '\'')) else {
        let end = text.len() - behind.len();
        return (TextRange::empty(size(end)), end);
    };
    let behind = behind.trim_start();
    let start = text.len() - behind.len() + 1;
    let inside = text.part(start..);
    let closing = inside.find(quote).unwrap_or(inside.len());
    let value = inside.part(..closing);
    let unclosed = end_of_unclosed(value).or_else(|| (closing == inside.len()).then(|| line_of(inside)));
    match unclosed {
        Some(len) => (TextRange::at(size(start), size(len)), start + len),
        None => (TextRange::at(size(start), size(closing)), start + closing + 1),
    }
}

/// End of a value without a closing quote. A value that contains another tag or attribute has no closing quote.
fn end_of_unclosed(value: &str) -> Option<usize> {
    if value.contains(['<', '\n', '\r']) {
        return Some(line_of(value));
    }
    let name = value.trim_end().strip_suffix('=')?.rfind(char::is_whitespace)?;
    Some(value.get(..name)?.trim_end().len())
}

/// Length of the text on the first line, without the end of a tag.
fn line_of(text: &str) -> usize {
    let line = text.split(['<', '\n', '\r']).next().unwrap_or("");
    line.trim_end().trim_end_matches("/>").trim_end_matches('>').trim_end().len()
}

fn name_at(text: &str) -> &str {
    let end = text.find(|letter: char| !is_name(letter)).unwrap_or(text.len());
    text.part(..end)
}

fn is_name(letter: char) -> bool {
    letter.is_alphanumeric() || matches!(letter, '_' | ':' | '.' | '-')
}

/// Word around a position.
fn word_around(text: &str, offset: usize) -> TextRange {
    let (before, after) = text.split_at_checked(offset).unwrap_or((text, ""));
    let start = before.trim_end_matches(is_name).len();
    TextRange::new(size(start), size(before.len() + name_at(after).len()))
}

fn slice(text: &str, range: TextRange) -> &str {
    text_at(text, range)
}

fn size(at: usize) -> TextSize {
    text_size(at)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Context of `|`, the elements around it, and the siblings.
    fn shown(marked: &str) -> String {
        let offset = marked.find('|').unwrap();
        let text = marked.replacen('|', "", 1);
        let Some(found) = XmlCursor::at(&text, size(offset)) else { return "nothing".to_owned() };
        let place = match &found.place {
            XmlPlace::Content(range) => format!("content `{}`", slice(&text, *range)),
            XmlPlace::ElementName(range) => format!("element `{}`", slice(&text, *range)),
            XmlPlace::EndTag(range) => format!("end `{}`", slice(&text, *range)),
            XmlPlace::AttributeName(range) => format!("attribute `{}`", slice(&text, *range)),
            XmlPlace::Value(name, range) => format!("{name} `{}`", slice(&text, *range)),
        };
        let names = |tags: &[Tag<'_>]| tags.iter().map(|tag| tag.name.to_owned()).collect::<Vec<_>>().join(" ");
        let tag = found.tag.as_ref().map(|tag| format!(" of <{}>", tag.name)).unwrap_or_default();
        format!("{place}{tag} in {} with {}", names(&found.open), names(&found.siblings))
    }

    #[test]
    fn positions_of_whole_files_are_classified() {
        assert_eq!(shown("<A>|<B/></A>"), "content `` in A with B");
        assert_eq!(shown("<A><B/>x|y<C></C></A><D/>"), "content `xy` in A with B C");
        assert_eq!(shown("<A><B|C/></A>"), "element `BC` of <BC> in A with ");
        assert_eq!(shown("<A><B a=\"1\" |/><C/></A>"), "attribute `` of <B> in A with C");
        assert_eq!(shown("<A><B a|b=\"1\"/></A>"), "attribute `ab` of <B> in A with ");
        assert_eq!(shown("<A><B ab='1|2' c='3'>x</B></A>"), "ab `12` of <B> in A with ");
        assert_eq!(shown("<A></|A>"), "end `A` in A with ");
        assert_eq!(shown("|"), "content `` in  with ");
        assert_eq!(shown("<A><![CDATA[a<b|]]></A>"), "nothing");
        assert_eq!(shown("<A><!-- <B | --></A>"), "nothing");
        assert_eq!(shown("<A><![CDATA[a<b]]>|</A>"), "content `` in A with ");
    }

    #[test]
    fn incomplete_tags_are_read() {
        assert_eq!(shown("<A>\n  <|\n  <B/>\n</A>"), "element `` of <> in A with B");
        assert_eq!(shown("<A>\n  <B a=\"|\n  <C/>\n</A>"), "a `` of <B> in A with C");
        assert_eq!(shown("<A>\n  <B a=\"x| />\n  <C/>\n</A>"), "a `x` of <B> in A with C");
        assert_eq!(shown("<A>\n  <B a=\"| c=\"1\" />\n</A>"), "a `` of <B> in A with ");
        assert_eq!(shown("<A>\n  <B a=\"1\" |\n  <C/>\n</A>"), "attribute `` of <B> in A with C");
        assert_eq!(shown("<A>\n  <B a=|\n</A>"), "a `` of <B> in A with ");
        assert_eq!(shown("<A><B>\n</|"), "end `` in A B with ");
        assert_eq!(shown("<A><B></C>|"), "content `` in A B with ");
        assert_eq!(shown("<A|"), "element `A` of <A> in  with ");
    }

    #[test]
    fn every_position_of_a_broken_text_can_be_read() {
        for text in ["<", "<<<<", "<a =\"", "</", "<!", "<a ä='ö", "<a/", "]]>", "<a b='<c d=\"'>"] {
            for at in 0..=text.len() {
                let _ = XmlCursor::at(text, size(at));
            }
        }
    }
}
