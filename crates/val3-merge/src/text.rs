//! The text of an element: code, a description, a setting.

use val3_syntax::{Part, decode_entities};

use crate::node::Node;

/// The opening and the end of a CDATA section.
const CDATA: [&str; 2] = ["<![CDATA[", "]]>"];

/// The text of an element in the form of the file.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Content<'t> {
    /// Blanks and the opening of a CDATA section before the text.
    pub(crate) before: &'t str,
    /// The text.
    pub(crate) raw: &'t str,
    /// The end of the CDATA section and blanks after the text.
    pub(crate) after: &'t str,
    /// How `<` and `&` are written.
    pub(crate) form: Form,
}

/// How a text writes `<` and `&`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Form {
    /// As entity references.
    Escaped,
    /// In a CDATA section, where only its end cannot be written.
    Section,
    /// Unchanged, in a text that is no XML.
    Plain,
}

/// A line with its end, which is empty for the last one.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Line<'t> {
    pub(crate) raw: &'t str,
    pub(crate) end: &'static str,
}

impl<'t> Content<'t> {
    /// The text in an element; `None` for several sections, and for text with elements or comments in between.
    pub(crate) fn of(node: &Node<'t>) -> Option<Self> {
        let all = node.content_text();
        let [open, close] = CDATA;
        if !node.children.is_empty() {
            return None;
        }
        let Some((before, rest)) = all.split_once(open) else {
            let is_plain = !all.contains('<');
            return is_plain.then_some(Self { before: "", raw: all, after: "", form: Form::Escaped });
        };
        let (raw, after) = rest.split_once(close)?;
        let is_single = before.trim().is_empty() && after.trim().is_empty();
        let before = all.get(..before.len() + open.len())?;
        let after = all.get(all.len() - after.len() - close.len()..)?;
        is_single.then_some(Self { before, raw, after, form: Form::Section })
    }

    /// The lines of the text.
    pub(crate) fn lines(self) -> Vec<Line<'t>> {
        let mut lines: Vec<Line<'_>> = self.raw.split('\n').map(line).collect();
        if let Some(last) = lines.last_mut() {
            last.end = "";
        }
        lines
    }

    /// A line as the program reads it.
    pub(crate) fn decoded(self, line: &Line<'_>) -> String {
        match self.form {
            Form::Escaped => decode_entities(line.raw).into_owned(),
            Form::Section | Form::Plain => line.raw.to_owned(),
        }
    }

    /// A decoded line as this text writes it.
    pub(crate) fn encoded(self, line: &str) -> String {
        match self.form {
            Form::Escaped => line.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;"),
            Form::Section => line.replace("]]>", "]]]]><![CDATA[>"),
            Form::Plain => line.to_owned(),
        }
    }
}

fn line(text: &str) -> Line<'_> {
    match text.strip_suffix('\r') {
        Some(raw) => Line { raw, end: "\r\n" },
        None => Line { raw: text, end: "\n" },
    }
}

/// The lines of the text in an element, as programs read them, without blanks around the whole.
pub(crate) fn lines_of(node: &Node<'_>) -> Vec<String> {
    let Some(content) = Content::of(node) else {
        return node.content_text().lines().map(str::to_owned).collect();
    };
    let lines: Vec<String> = content.lines().iter().map(|line| content.decoded(line)).collect();
    let is_blank = |line: &&String| line.trim().is_empty();
    let start = lines.iter().take_while(is_blank).count();
    let end = lines.len() - lines.iter().rev().take_while(is_blank).count().min(lines.len() - start);
    let kept = lines.part(start..end);
    match kept {
        [only] => vec![only.trim().to_owned()],
        kept => kept.to_vec(),
    }
}
