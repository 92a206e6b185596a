//! JSON parser that records the ranges of strings.

use super::escapes::unescaped;
use val3_syntax::{TextRange, TextSlice, text_size};

/// Maximum nesting of values. Bindings have four levels.
const DEEPEST: usize = 32;

/// A JSON value; only strings have a range.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum JsonNode {
    Object(Vec<(String, JsonNode)>),
    Array(Vec<JsonNode>),
    /// Content, and range between the quotes.
    Text(String, TextRange),
    /// An integer from 0.
    Integer(u32),
    Other,
}

/// First JSON fault of a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct JsonFault {
    /// Range of the fault.
    pub range: TextRange,
    /// Expected token.
    pub expected: &'static str,
}

impl JsonNode {
    pub(super) fn member(&self, name: &str) -> Option<&Self> {
        let Self::Object(members) = self else { return None };
        members.iter().find(|(known, _)| known == name).map(|(_, value)| value)
    }

    pub(super) fn elements(&self) -> &[Self] {
        if let Self::Array(elements) = self { elements } else { &[] }
    }

    pub(super) fn text(&self) -> Option<(&str, TextRange)> {
        if let Self::Text(text, range) = self { Some((text, *range)) } else { None }
    }

    pub(super) fn integer(&self) -> Option<u32> {
        if let Self::Integer(number) = self { Some(*number) } else { None }
    }
}

/// Reads one value.
///
/// # Errors
/// Reports the first JSON fault.
pub(super) fn parse(text: &str) -> Result<JsonNode, JsonFault> {
    let mut reader = JsonReader { text, at: 0 };
    let value = reader.value(0)?;
    reader.blanks();
    if reader.rest().is_empty() { Ok(value) } else { Err(reader.fault("the end of the file")) }
}

struct JsonReader<'t> {
    text: &'t str,
    /// Offset of the next character.
    at: usize,
}

impl<'t> JsonReader<'t> {
    fn rest(&self) -> &'t str {
        self.text.part(self.at..)
    }

    fn fault(&self, expected: &'static str) -> JsonFault {
        let length = self.rest().chars().next().map_or(0, char::len_utf8);
        JsonFault { range: range(self.at, self.at + length), expected }
    }

    fn blanks(&mut self) {
        let rest = self.rest();
        self.at += rest.len() - rest.trim_start_matches([' ', '\t', '\r', '\n', '\u{feff}']).len();
    }

    fn take(&mut self, sign: &str) -> bool {
        self.blanks();
        let is_next = self.rest().starts_with(sign);
        self.at += if is_next { sign.len() } else { 0 };
        is_next
    }

    fn value(&mut self, depth: usize) -> Result<JsonNode, JsonFault> {
        if depth > DEEPEST {
            return Err(self.fault("fewer values within values"));
        }
        if self.take("{") {
            return self.members(depth);
        }
        if self.take("[") {
            return self.elements(depth);
        }
        if self.rest().starts_with('"') {
            let (text, range) = self.string()?;
            return Ok(JsonNode::Text(text, range));
        }
        let length = self.rest().find(|letter: char| !letter.is_ascii_alphanumeric() && !"+-.".contains(letter));
        let length = length.unwrap_or(self.rest().len());
        let word = self.rest().part(..length);
        if matches!(word, "true" | "false" | "null") || word.parse::<f64>().is_ok() {
            self.at += length;
            return Ok(word.parse().map_or(JsonNode::Other, JsonNode::Integer));
        }
        Err(self.fault("a value"))
    }

    fn members(&mut self, depth: usize) -> Result<JsonNode, JsonFault> {
        let mut members = Vec::new();
        if self.take("}") {
            return Ok(JsonNode::Object(members));
        }
        loop {
            self.blanks();
            let (name, _) = self.string()?;
            if !self.take(":") {
                return Err(self.fault("`:`"));
            }
            members.push((name, self.value(depth + 1)?));
            match () {
                () if self.take(",") => {}
                () if self.take("}") => return Ok(JsonNode::Object(members)),
                () => return Err(self.fault("`,` or `}`")),
            }
        }
    }

    fn elements(&mut self, depth: usize) -> Result<JsonNode, JsonFault> {
        let mut elements = Vec::new();
        if self.take("]") {
            return Ok(JsonNode::Array(elements));
        }
        loop {
            elements.push(self.value(depth + 1)?);
            match () {
                () if self.take(",") => {}
                () if self.take("]") => return Ok(JsonNode::Array(elements)),
                () => return Err(self.fault("`,` or `]`")),
            }
        }
    }

    /// Parses a string: its content without escapes, and its range.
    fn string(&mut self) -> Result<(String, TextRange), JsonFault> {
        if !self.rest().starts_with('"') {
            return Err(self.fault("a string"));
        }
        let start = self.at + 1;
        let mut letters = self.text.part(start..).char_indices();
        while let Some((at, letter)) = letters.next() {
            match letter {
                '"' => {
                    self.at = start + at + 1;
                    let raw = self.text.part(start..start + at);
                    return Ok((unescaped(raw), range(start, start + at)));
                }
                '\\' => _ = letters.next(),
                '\n' | '\r' => break,
                _ => {}
            }
        }
        Err(JsonFault { range: range(self.at, self.at + 1), expected: "the closing quote of this string" })
    }
}

fn range(start: usize, end: usize) -> TextRange {
    TextRange::new(text_size(start), text_size(end.max(start)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn strings_have_their_places() {
        let text = r#"{"a": [{"b": "s[\"k\"]"}, 1.5e3, true, null], "c": ""}"#;
        let root = parse(text).unwrap();
        let (found, range) = root.member("a").unwrap().elements()[0].member("b").unwrap().text().unwrap();
        assert_eq!((found, &text[range]), (r#"s["k"]"#, r#"s[\"k\"]"#));
    }

    #[test]
    fn the_first_place_that_is_no_json_is_found() {
        let fault = |text: &str| parse(text).map_err(|fault| format!("{:?} {}", fault.range, fault.expected));
        assert_eq!(fault("{ broken"), Err("2..3 a string".to_owned()));
        assert_eq!(fault("[1,]"), Err("3..4 a value".to_owned()));
        assert_eq!(fault("[\"a"), Err("1..2 the closing quote of this string".to_owned()));
        assert_eq!(fault("[1] 2"), Err("4..5 the end of the file".to_owned()));
        assert!(fault(&"[".repeat(100_000)).is_err());
    }
}
