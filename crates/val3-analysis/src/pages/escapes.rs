//! Escapes in JSON strings: `\"`, `\u00e9`.

use std::ops::Range;

use val3_syntax::{TextRange, TextSize, text_size};

/// Returns the content of a string without escapes.
pub fn unescaped(raw: &str) -> String {
    letters(raw).map(|(letter, _)| letter).collect()
}

/// Escapes quotes, backslashes and control characters for a JSON string.
pub fn escaped(text: &str) -> String {
    let mut raw = String::with_capacity(text.len());
    for letter in text.chars() {
        match letter {
            '"' | '\\' => raw.extend(['\\', letter]),
            control if control.is_control() => raw.push_str(&format!("\\u{:04x}", u32::from(control))),
            other => raw.push(other),
        }
    }
    raw
}

/// Returns the source range for a part of a string. `part` is in bytes of the unescaped string.
pub(super) fn source_range(raw: &str, start: TextSize, part: &Range<usize>) -> TextRange {
    let (mut from, mut to) = (None, raw.len());
    let mut at = 0;
    for (letter, source) in letters(raw) {
        if at >= part.end {
            to = source.start;
            break;
        }
        if at >= part.start {
            from = from.or(Some(source.start));
        }
        at += letter.len_utf8();
    }
    let from = from.unwrap_or(to);
    TextRange::at(start + text_size(from), text_size(to - from))
}

/// Returns the characters of a string with their ranges in `raw`.
fn letters(raw: &str) -> impl Iterator<Item = (char, Range<usize>)> {
    let mut at = 0;
    std::iter::from_fn(move || {
        let rest = raw.get(at..)?;
        let (letter, length) =
            escape(rest).or_else(|| rest.chars().next().map(|letter| (letter, letter.len_utf8())))?;
        let source = at..at + length;
        at += length;
        Some((letter, source))
    })
}

/// Parses an escape at the start of a string: the character and the length of the escape.
fn escape(text: &str) -> Option<(char, usize)> {
    let kind = text.strip_prefix('\\')?.chars().next()?;
    let letter = match kind {
        'u' => return unicode(text),
        'n' => '\n',
        't' => '\t',
        'r' => '\r',
        'b' => '\u{8}',
        'f' => '\u{c}',
        other => other,
    };
    Some((letter, 1 + kind.len_utf8()))
}

/// Parses `\u00e9` or a surrogate pair.
fn unicode(text: &str) -> Option<(char, usize)> {
    let first = code_unit(text)?;
    let second = text.get(6..).and_then(code_unit);
    let letter = char::decode_utf16([first].into_iter().chain(second)).next()?.unwrap_or(char::REPLACEMENT_CHARACTER);
    Some((letter, if u32::from(letter) > 0xFFFF { 12 } else { 6 }))
}

/// Parses the UTF-16 code unit of an escape at the start of `text`: `\u00e9`.
fn code_unit(text: &str) -> Option<u16> {
    let digits = text.strip_prefix("\\u")?.get(..4)?;
    u16::from_str_radix(digits, 16).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn escapes_are_replaced() {
        assert_eq!(unescaped(r#"s[\"k\"] \u00e9 \ud83d\ude00 \\ \n\/"#), "s[\"k\"] é 😀 \\ \n/");
        assert_eq!(unescaped(r"\ud83d x \u00"), "\u{fffd} x \\u00");
        assert_eq!(escaped("a\"b\\c\né"), r#"a\"b\\c\u000aé"#);
    }

    #[test]
    fn parts_have_their_range_in_the_file() {
        let raw = r"n\u0043ount[0]";
        let shown = |part: Range<usize>| &raw[source_range(raw, 0.into(), &part)];
        assert_eq!(shown(0..6), r"n\u0043ount");
        assert_eq!(shown(6..9), "[0]");
        assert_eq!(shown(0..9), raw);
        assert_eq!(shown(9..9), "");
    }

    proptest::proptest! {
        #[test]
        fn escaped_texts_are_read_back(text in ".*") {
            assert_eq!(unescaped(&escaped(&text)), text);
        }
    }
}
