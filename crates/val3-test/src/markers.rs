//! Marks in test texts: `$0` for the cursor and `^^^` for a range with a note.

use crate::indent::dedent;

/// A text without its marks.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct MarkedText {
    /// Text without common indentation and marks.
    pub text: String,
    /// Byte offset of `$0` in [`MarkedText::text`].
    pub cursor: Option<usize>,
    /// Notes, in order.
    pub notes: Vec<Note>,
}

/// A note below a line: `   ^^^ the note`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Note {
    /// Number of the line above the carets, from 1.
    pub line: usize,
    /// First column under which there are carets, in bytes from 0.
    pub column: usize,
    /// Number of carets.
    pub width: usize,
    /// Text after the carets.
    pub text: String,
}

/// Removes the marks from `text`: at most one `$0`, and lines that begin with `^`, which refer to the line above.
///
/// # Panics
/// If the text has two `$0`, or a note has no line above it.
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
