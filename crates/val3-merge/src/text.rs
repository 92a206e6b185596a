//! Text in an element: code, a description, a configuration value.

use val3_syntax::{TextSlice, decode_entities};

use crate::node::MergeNode;

/// Start and end mark of a CDATA section.
const CDATA: [&str; 2] = ["<![CDATA[", "]]>"];

/// Element text as written in the file.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ElementText<'t> {
    /// Blanks and the start mark of a CDATA section before the text.
    pub(crate) before: &'t str,
    /// Text as written.
    pub(crate) raw: &'t str,
    /// End mark of the CDATA section and blanks after the text.
    pub(crate) after: &'t str,
    /// Spelling of `<` and `&`.
    pub(crate) form: TextSpelling,
}

/// Spelling of `<` and `&` in a text.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum TextSpelling {
    /// Entity references.
    Escaped,
    /// Unchanged in a CDATA section, where only the end mark must be split.
    Section,
    /// Unchanged, in a text that is no XML.
    Plain,
}

/// A line with its line end, which is empty for the last line.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct TextLine<'t> {
    pub(crate) raw: &'t str,
    pub(crate) end: &'static str,
}

impl<'t> ElementText<'t> {
    /// Returns the text in an element; `None` for several sections, and for text between elements or comments.
    pub(crate) fn of(node: &MergeNode<'t>) -> Option<Self> {
        let all = node.content_text();
        let [open, close] = CDATA;
        if !node.children.is_empty() {
            return None;
        }
        let Some((before, rest)) = all.split_once(open) else {
            let is_plain = !all.contains('<');
            return is_plain.then_some(Self { before: "", raw: all, after: "", form: TextSpelling::Escaped });
        };
        let (raw, after) = rest.split_once(close)?;
        let is_single = before.trim().is_empty() && after.trim().is_empty();
        let before = all.get(..before.len() + open.len())?;
        let after = all.get(all.len() - after.len() - close.len()..)?;
        is_single.then_some(Self { before, raw, after, form: TextSpelling::Section })
    }

    /// Returns the lines of the text.
    pub(crate) fn lines(self) -> Vec<TextLine<'t>> {
        let mut lines: Vec<TextLine<'_>> = self.raw.split('\n').map(line).collect();
        if let Some(last) = lines.last_mut() {
            last.end = "";
        }
        lines
    }

    /// Decodes a line.
    pub(crate) fn decoded(self, line: &TextLine<'_>) -> String {
        match self.form {
            TextSpelling::Escaped => decode_entities(line.raw).into_owned(),
            TextSpelling::Section | TextSpelling::Plain => line.raw.to_owned(),
        }
    }

    /// Encodes a line for this text.
    pub(crate) fn encoded(self, line: &str) -> String {
        match self.form {
            TextSpelling::Escaped => line.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;"),
            TextSpelling::Section => line.replace("]]>", "]]]]><![CDATA[>"),
            TextSpelling::Plain => line.to_owned(),
        }
    }
}

fn line(text: &str) -> TextLine<'_> {
    match text.strip_suffix('\r') {
        Some(raw) => TextLine { raw, end: "\r\n" },
        None => TextLine { raw: text, end: "\n" },
    }
}

/// Returns the decoded lines of the text in an element, without leading and trailing blanks.
pub(crate) fn lines_of(node: &MergeNode<'_>) -> Vec<String> {
    let Some(content) = ElementText::of(node) else {
        return node.content_text().lines().map(str::to_owned).collect();
    };
    let lines: Vec<String> = content.lines().iter().map(|line| content.decoded(line)).collect();
    let start = lines.iter().position(|line| !line.trim().is_empty()).unwrap_or(lines.len());
    let end = lines.iter().rposition(|line| !line.trim().is_empty()).map_or(start, |last| last + 1);
    let kept = lines.part(start..end);
    match kept {
        [only] => vec![only.trim().to_owned()],
        kept => kept.to_vec(),
    }
}
