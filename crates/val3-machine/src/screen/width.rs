//! Text width on the pendant, in columns.

use unicode_width::UnicodeWidthChar;

/// Returns the width of `text` in columns (`getDisplayLen`, 4.3).
///
/// Each ASCII character has one column, so that the result is the number of characters. Chinese, Japanese and Korean
/// characters have two columns, combining marks have no column. Characters whose width depends on the font, such as box
/// lines, count as one column.
#[must_use]
pub fn display_columns(text: &str) -> usize {
    text.chars().map(columns_of).sum()
}

/// Returns the beginning of `text` that fits into `columns`.
#[must_use]
pub fn fitting(text: &str, columns: usize) -> &str {
    let mut taken = 0;
    let beyond = text.char_indices().find(|(_, character)| {
        taken += columns_of(*character);
        taken > columns
    });
    beyond.and_then(|(at, _)| text.get(..at)).unwrap_or(text)
}

/// Width of a character in columns: 0, 1 or 2.
pub(super) fn columns_of(character: char) -> usize {
    character.width().unwrap_or(1)
}

#[cfg(test)]
mod tests {
    use super::{display_columns, fitting};

    #[test]
    fn a_text_is_cut_before_a_character() {
        assert_eq!([0, 1, 2, 3, 4].map(|columns| fitting("a中b", columns)), ["", "a", "a", "a中", "a中b"]);
    }

    #[test]
    fn ascii_counts_as_len_does() {
        assert_eq!(display_columns("Hello, world"), 12);
        assert_eq!(display_columns("a\u{7}b\n"), 4);
        assert_eq!(display_columns(""), 0);
    }

    #[test]
    fn chinese_takes_two_columns() {
        assert_eq!(display_columns("中文"), 4);
        assert_eq!(display_columns("F1:开"), 5);
    }

    #[test]
    fn accents_and_box_lines_have_their_width() {
        assert_eq!(display_columns("é"), 1);
        assert_eq!(display_columns("e\u{301}"), 1);
        assert_eq!(display_columns("│═"), 2);
    }
}
