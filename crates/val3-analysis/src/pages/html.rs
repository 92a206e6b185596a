//! HTML file of a page: element ids.

use std::ops::Range;

use val3_syntax::{TextRange, TextSlice, decode_entities, text_size};

use crate::db::{Db, File};

/// Ids in the HTML file of a page, with their ranges without quotes.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct PageIds {
    /// Values of `id` attributes in source order.
    pub declared: Vec<(String, TextRange)>,
    /// Values of `for` attributes, which refer to the element of a label.
    pub named: Vec<(String, TextRange)>,
    /// Ranges outside of comments.
    pub parts: Vec<TextRange>,
    /// Whether a script in the page may add elements.
    pub is_dynamic: bool,
}

impl PageIds {
    /// Whether an element has the id.
    pub fn declares(&self, id: &str) -> bool {
        self.declared.iter().any(|(known, _)| known == id)
    }
}

/// Names in scripts that add elements.
const ADDING: [&str; 4] = ["createElement", "innerHTML", "insertAdjacentHTML", "document.write"];

/// Reads the ids in the HTML file of a page, outside of comments.
#[salsa::tracked]
pub fn page_ids(db: &dyn Db, file: File) -> PageIds {
    let text = file.text(db);
    let (mut declared, mut named) = (Vec::new(), Vec::new());
    let parts = outside_comments(text);
    for part in parts.iter().cloned() {
        for (name, value) in attributes(text, part) {
            let range = range(&value);
            let id = decode_entities(text.get(value).unwrap_or("")).into_owned();
            if name.eq_ignore_ascii_case("id") {
                declared.push((id, range));
            } else if name.eq_ignore_ascii_case("for") {
                named.push((id, range));
            }
        }
    }
    let parts = parts.iter().map(range).collect();
    PageIds { declared, named, parts, is_dynamic: ADDING.iter().any(|sign| text.contains(sign)) }
}

fn range(bytes: &Range<usize>) -> TextRange {
    TextRange::new(text_size(bytes.start), text_size(bytes.end))
}

fn outside_comments(text: &str) -> Vec<Range<usize>> {
    let mut parts = Vec::new();
    let mut at = 0;
    while let Some(start) = text.get(at..).and_then(|rest| rest.find("<!--")) {
        parts.push(at..at + start);
        let comment = at + start;
        let end = text.get(comment..).and_then(|rest| rest.find("-->"));
        at = end.map_or(text.len(), |end| comment + end + "-->".len());
    }
    parts.push(at..text.len());
    parts
}

/// Returns attribute names and the ranges of the values: `name="value"`, `name='value'`, `name=value`.
fn attributes(text: &str, part: Range<usize>) -> Vec<(&str, Range<usize>)> {
    let mut found = Vec::new();
    let end = part.end;
    let mut at = part.start;
    while let Some(equals) = text.get(at..end).and_then(|rest| rest.find('=')) {
        let equals = at + equals;
        let before = text.part(at..equals).trim_end();
        let name =
            before.rsplit(|letter: char| letter.is_whitespace() || "<>\"'".contains(letter)).next().unwrap_or("");
        let behind = text.part(equals + 1..end);
        let value = behind.trim_start();
        let start = end - value.len();
        at = equals + 1;
        let quote = value.chars().next().filter(|quote| matches!(quote, '"' | '\''));
        let value = match quote {
            Some(quote) => match value.get(1..).and_then(|inner| inner.find(quote)) {
                Some(length) => start + 1..start + 1 + length,
                None => continue,
            },
            None => {
                let length = value.find(|letter: char| letter.is_whitespace() || "/>\"'".contains(letter));
                start..start + length.unwrap_or(value.len())
            }
        };
        at = at.max(if quote.is_some() { value.end + 1 } else { value.end });
        let is_attribute = before.strip_suffix(name).is_some_and(|before| before.ends_with(char::is_whitespace));
        if !name.is_empty() && is_attribute {
            found.push((name, value));
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(text: &str) -> Vec<(&str, &str)> {
        let parts = outside_comments(text).into_iter();
        parts.flat_map(|part| attributes(text, part)).map(|(name, value)| (name, &text[value])).collect()
    }

    #[test]
    fn attributes_have_their_values() {
        let text = "<div id=\"a\" data-id=\"no\"><p class='x'\n ID = 'b &amp; c'>1=2 id</p><hr id=d/><a href=\"?id=e\"/></div>";
        let expected =
            [("id", "a"), ("data-id", "no"), ("class", "x"), ("ID", "b &amp; c"), ("id", "d"), ("href", "?id=e")];
        assert_eq!(shown(text), expected);
    }

    #[test]
    fn comments_have_no_attributes() {
        assert_eq!(
            shown("<a id=\"x\"/><!-- <a id=\"y\"/> --><a id=\"z\"/><!-- id=\"open\""),
            [("id", "x"), ("id", "z")]
        );
        assert_eq!(shown("<a id=\"x"), []);
    }
}
