//! `$0` for the cursor and `^^^` for a place with a remark.

use crate::indent::dedent;

/// A text freed of its marks.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct MarkedText {
    /// The text, without shared indentation and without marks.
    pub text: String,
    /// Byte offset of `$0` in [`MarkedText::text`].
    pub cursor: Option<usize>,
    /// The remarks, in their order.
    pub notes: Vec<Note>,
}

/// A remark below a line: `   ^^^ the remark`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Note {
    /// The line above the carets, from 1.
    pub line: usize,
    /// The first column the carets cover, in bytes from 0.
    pub column: usize,
    /// How many columns they cover.
    pub width: usize,
    /// The text after the carets.
    pub text: String,
}

/// Takes the marks out of `text`: one `$0` at most, and lines that begin with `^`, which speak about the line
/// above them.
///
/// # Panics
/// If the text has two `$0`, or a remark has no line above it.
#[track_caller]
pub fn extract_markers(text: &str) -> MarkedText {
    let mut lines: Vec<String> = Vec::new();
    let mut notes = Vec::new();
    for line in dedent(text).lines() {
        if line.trim_start().starts_with('^') {
            assert!(!lines.is_empty(), "a remark needs a line above it: {line:?}");
            notes.push(note(line, lines.len()));
        } else {
            lines.push(line.to_owned());
        }
    }
    let (text, cursor) = take_cursor(&lines.join("\n"));
    MarkedText { text, cursor, notes }
}

fn note(line: &str, above: usize) -> Note {
    let carets = line.trim_start();
    let column = line.len() - carets.len();
    let text = carets.trim_start_matches('^');
    Note { line: above, column, width: carets.len() - text.len(), text: text.trim().to_owned() }
}

#[track_caller]
fn take_cursor(text: &str) -> (String, Option<usize>) {
    match text.split_once("$0") {
        None => (text.to_owned(), None),
        Some((before, after)) => {
            assert!(!after.contains("$0"), "the cursor mark `$0` stands in the text twice");
            (format!("{before}{after}"), Some(before.len()))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Note, extract_markers};

    #[test]
    fn cursor_and_remarks() {
        let marked = extract_markers("\n    nA$0=sB\n       ^^ V0202 no num\n    nC=1");
        assert_eq!(marked.text, "\nnA=sB\nnC=1");
        assert_eq!(marked.cursor, Some(3));
        let expected = Note { line: 2, column: 3, width: 2, text: "V0202 no num".to_owned() };
        assert_eq!(marked.notes, [expected]);
    }

    #[test]
    #[should_panic(expected = "twice")]
    fn two_cursors() {
        extract_markers("a$0b$0");
    }
}
