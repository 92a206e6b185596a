//! Visible forms of control characters, so that untrusted text cannot control a terminal or forge lines of a report.

use std::borrow::Cow;
use std::fmt::Write as _;

/// Distance from a control character below a blank to its picture (U+2400 to U+241F).
const PICTURES: u32 = 0x2400;

/// Returns the text with a visible form of each control character except tab and line feed.
pub(crate) fn pictured(text: &str) -> Cow<'_, str> {
    replaced(text, is_unprintable)
}

/// As [`pictured`], and replaces line feeds, too: for names and paths within a line.
pub(crate) fn one_line(text: &str) -> Cow<'_, str> {
    replaced(text, |character| character == '\n' || is_unprintable(character))
}

fn replaced(text: &str, is_replaced: impl Fn(char) -> bool) -> Cow<'_, str> {
    if !text.contains(&is_replaced) {
        return Cow::Borrowed(text);
    }
    let mut shown = String::with_capacity(text.len());
    for character in text.chars() {
        if is_replaced(character) { push_picture(character, &mut shown) } else { shown.push(character) }
    }
    Cow::Owned(shown)
}

/// Whether a terminal executes the character instead of showing it: C0 except tab and line feed, DEL, C1, and
/// characters that change the text direction, so that displayed code would differ from its real order.
pub(crate) fn is_unprintable(character: char) -> bool {
    match character {
        '\t' | '\n' => false,
        '\u{2028}' | '\u{2029}' => true,
        '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}' => true,
        other => other.is_control(),
    }
}

/// Appends the visible form of an unprintable character: `␛` for ESC, `<9B>` for U+009B.
pub(crate) fn push_picture(character: char, text: &mut String) {
    let code = u32::from(character);
    let picture = match character {
        '\u{7f}' => Some('␡'),
        '\0'..' ' => char::from_u32(PICTURES + code),
        _ => None,
    };
    match picture {
        Some(picture) => text.push(picture),
        None => {
            // Writing to a string cannot fail.
            let _ = write!(text, "<{code:02X}>");
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn control_characters_are_visible() {
        let text = "a\u{1b}[2J\u{7}\u{0}\r\u{7f}\u{9b}31m\u{202e}é\t\n";
        assert_eq!(pictured(text), "a␛[2J␇␀␍␡<9B>31m<202E>é\t\n");
        assert_eq!(one_line("a\n::error::b"), "a␊::error::b");
    }

    #[test]
    fn other_texts_are_unchanged() {
        assert!(matches!(pictured("é → 中\t\n"), Cow::Borrowed(_)));
        assert!(matches!(one_line("é → 中\t"), Cow::Borrowed(_)));
    }
}
