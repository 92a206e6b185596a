//! Functions of string instructions (3.4.3, `getDisplayLen` of 4.3).
//!
//! Positions and sizes count characters (code points) from 0 and are rounded like an index. A result above 128 bytes is
//! cut between characters.

use unicode_width::UnicodeWidthChar;

use super::{Text, numbers};
use crate::fault::Result;

/// `chr`: character with this rounded code point; empty for an invalid code point, for example one half of a surrogate
/// pair.
#[must_use]
pub fn chr(code_point: f64) -> Text {
    let code_point = numbers::count_from_zero(code_point).and_then(|code| u32::try_from(code).ok());
    match code_point.and_then(char::from_u32) {
        Some(character) => Text::from(&*character.encode_utf8(&mut [0; 4])),
        None => Text::new(),
    }
}

/// `asc`: code point of the character at `position`, or -1 beyond the end.
#[must_use]
pub fn asc(text: &str, position: f64) -> f64 {
    let character = numbers::count_from_zero(position).and_then(|position| text.chars().nth(position));
    character.map_or(-1.0, |character| f64::from(u32::from(character)))
}

/// `left`: the first `size` characters, or all if there are fewer.
///
/// # Errors
/// 70: `size` is negative.
pub fn left(text: &str, size: f64) -> Result<Text> {
    let (left, _) = split(text, numbers::count(size)?);
    Ok(Text::from(left))
}

/// `right`: the last `size` characters, or all if there are fewer.
///
/// # Errors
/// 70: `size` is negative.
pub fn right(text: &str, size: f64) -> Result<Text> {
    let dropped = len(text).saturating_sub(numbers::count(size)?);
    let (_, right) = split(text, dropped);
    Ok(Text::from(right))
}

/// `mid`: `size` characters from `position` on, fewer at the end of the string.
///
/// # Errors
/// 70: `size` or `position` is negative.
pub fn mid(text: &str, size: f64, position: f64) -> Result<Text> {
    let [_, middle, _] = cut_out(text, size, position)?;
    Ok(Text::from(middle))
}

/// `insert`: inserts `insertion` before the character at `position`, or at the end.
///
/// # Errors
/// 70: `position` is negative.
pub fn insert(text: &str, insertion: &str, position: f64) -> Result<Text> {
    let (before, behind) = split(text, numbers::count(position)?);
    Ok(Text::from_iter([before, insertion, behind]))
}

/// `delete`: removes `size` characters from `position` on.
///
/// # Errors
/// 70: `size` or `position` is negative.
pub fn delete(text: &str, size: f64, position: f64) -> Result<Text> {
    let [before, _, behind] = cut_out(text, size, position)?;
    Ok(Text::from_iter([before, behind]))
}

/// `replace`: replaces `size` characters from `position` on by `replacement`.
///
/// Beyond the end, the string is unchanged. Directly at the end, the replacement is appended.
///
/// # Errors
/// 70: `size` or `position` is negative.
pub fn replace(text: &str, replacement: &str, size: f64, position: f64) -> Result<Text> {
    let [before, _, behind] = cut_out(text, size, position)?;
    let beyond = numbers::count(position)? > len(text);
    Ok(Text::from_iter([before, if beyond { "" } else { replacement }, behind]))
}

/// `find`: first position of `wanted` in `text`, or -1 if `text` does not contain it. The empty string is at 0.
#[must_use]
pub fn find(text: &str, wanted: &str) -> f64 {
    let before = first_occurrence(text, wanted).and_then(|at| text.get(..at));
    before.map_or(-1.0, |before| len(before) as f64)
}

/// Byte offset of the first occurrence of `wanted`. Strings are so short that a simple search is faster than
/// [`str::find`], which prepares tables.
fn first_occurrence(text: &str, wanted: &str) -> Option<usize> {
    let (text, wanted) = (text.as_bytes(), wanted.as_bytes());
    let Some((first, rest)) = wanted.split_first() else { return Some(0) };
    let mut starts = text.iter().enumerate().filter(|(_, byte)| *byte == first).map(|(at, _)| at);
    starts.find(|at| text.get(at + 1..).is_some_and(|behind| behind.starts_with(rest)))
}

/// `len`: number of characters in a string.
#[must_use]
pub fn len(text: &str) -> usize {
    text.chars().count()
}

/// `getDisplayLen`: number of columns that a string occupies on the pendant.
#[must_use]
pub fn display_len(text: &str) -> usize {
    text.chars().map(columns).sum()
}

/// Character width in columns: 2 for a wide character, such as Chinese, 0 for a combining character, otherwise 1.
/// A control character occupies one column, because the pendant shows a symbol for it.
#[must_use]
pub fn columns(character: char) -> usize {
    character.width().unwrap_or(1)
}

/// Splits the text before the character at `position`.
fn split(text: &str, position: usize) -> (&str, &str) {
    let at = if text.is_ascii() {
        position.min(text.len())
    } else {
        text.char_indices().nth(position).map_or(text.len(), |(at, _)| at)
    };
    text.split_at_checked(at).unwrap_or((text, ""))
}

/// Splits the text into the parts before, in and after the `size` characters from `position` on.
fn cut_out(text: &str, size: f64, position: f64) -> Result<[&str; 3]> {
    let (before, rest) = split(text, numbers::count(position)?);
    let (middle, behind) = split(rest, numbers::count(size)?);
    Ok([before, middle, behind])
}

#[cfg(test)]
mod tests;
