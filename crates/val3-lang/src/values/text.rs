//! Value of a `string`: at most 128 bytes of UTF-8, stored inline (3.4.1).

use std::fmt::{self, Write};
use std::ops::{Add, AddAssign, Deref};

use arrayvec::ArrayString;

/// Value of a `string`.
///
/// A longer text is cut between characters, and nothing can be appended after the cut. Strings are ordered by code
/// points, which is also the order of their bytes: `"Z"` comes before `"a"`. The keys of a collection have this order
/// (2.5.6).
#[derive(Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Text(ArrayString<{ Text::CAPACITY }>);

impl Text {
    /// Capacity of a string in bytes.
    pub const CAPACITY: usize = 128;

    /// Creates an empty string, the initial value of a `string`.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Characters.
    #[must_use]
    pub fn as_str(&self) -> &str {
        &self.0
    }

    /// Removes all characters.
    #[inline]
    pub fn clear(&mut self) {
        self.0.clear();
    }

    /// Appends as many characters as fit. Returns whether all of `part` was appended.
    #[inline]
    fn push(&mut self, part: &str) -> bool {
        let fits = part.get(..part.floor_char_boundary(self.0.remaining_capacity())).unwrap_or(part);
        self.0.try_push_str(fits).is_ok() && fits.len() == part.len()
    }
}

impl From<&str> for Text {
    fn from(text: &str) -> Self {
        Self::from_iter([text])
    }
}

/// Concatenates the parts.
impl<'a> FromIterator<&'a str> for Text {
    fn from_iter<I: IntoIterator<Item = &'a str>>(parts: I) -> Self {
        let mut text = Self::new();
        for part in parts {
            if !text.push(part) {
                break;
            }
        }
        text
    }
}

/// Formats the arguments; the result is cut at the capacity.
impl From<fmt::Arguments<'_>> for Text {
    fn from(arguments: fmt::Arguments<'_>) -> Self {
        let mut text = Self::new();
        match text.write_fmt(arguments) {
            Ok(()) | Err(fmt::Error) => text,
        }
    }
}

/// `+` of strings (3.4.2): the first 128 bytes of both.
impl Add<&str> for Text {
    type Output = Self;

    fn add(mut self, right: &str) -> Self {
        self += right;
        self
    }
}

impl AddAssign<&str> for Text {
    #[inline]
    fn add_assign(&mut self, right: &str) {
        self.push(right);
    }
}

impl Deref for Text {
    type Target = str;

    fn deref(&self) -> &str {
        &self.0
    }
}

impl AsRef<str> for Text {
    fn as_ref(&self) -> &str {
        self
    }
}

/// Returns an error if text was cut.
impl Write for Text {
    fn write_str(&mut self, part: &str) -> fmt::Result {
        if self.push(part) { Ok(()) } else { Err(fmt::Error) }
    }
}

impl fmt::Display for Text {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self)
    }
}

impl fmt::Debug for Text {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Debug::fmt(self.as_str(), f)
    }
}

#[cfg(test)]
mod tests {
    use super::Text;

    fn joined(left: &str, right: &str) -> String {
        (Text::from(left) + right).to_string()
    }

    #[test]
    fn holds_128_bytes() {
        assert_eq!(Text::from("a".repeat(127).as_str()).len(), 127);
        assert_eq!(Text::from("a".repeat(128).as_str()).len(), 128);
        assert_eq!(Text::from("a".repeat(129).as_str()).len(), 128);
    }

    #[test]
    fn holds_42_chinese_characters() {
        assert_eq!(*Text::from("机".repeat(42).as_str()), *"机".repeat(42));
        assert_eq!(*Text::from("机".repeat(43).as_str()), *"机".repeat(42));
    }

    #[test]
    fn starts_empty() {
        assert_eq!(Text::new().as_str(), "");
    }

    #[test]
    fn plus_keeps_the_first_128_bytes() {
        assert_eq!(joined("hello", " world"), "hello world");
        assert_eq!(joined("", ""), "");
        let long = "a".repeat(127);
        assert_eq!(joined(&long, "b"), format!("{long}b"));
        assert_eq!(joined(&long, "bc"), format!("{long}b"));
        assert_eq!(joined("b", &"a".repeat(128)), format!("b{long}"));
    }

    #[test]
    fn is_cut_at_a_character_and_ends_there() {
        let long = "a".repeat(127);
        assert_eq!(joined(&long, "éb"), long);
        assert_eq!(Text::from_iter([long.as_str(), "é", "b"]).as_str(), long);
    }

    #[test]
    fn is_ordered_by_code_point() {
        let sorted = ["", "Z", "a", "aa", "b", "é", "机", "🤖"].map(Text::from);
        assert!(sorted.is_sorted_by(|left, right| left < right));
    }

    #[test]
    fn is_padded_like_any_text() {
        assert_eq!(format!("[{:>3}]", Text::from("a")), "[  a]");
        assert_eq!(format!("{:?}", Text::from("a\"")), r#""a\"""#);
    }

    #[test]
    fn equal_texts_have_the_same_characters() {
        assert_eq!(Text::from("ab"), Text::from("a") + "b");
        assert_ne!(Text::from("ab"), Text::from("aB"));
        assert_ne!(Text::from("a"), Text::from("a "));
    }
}
