//! Text that programs write on user pages (`put`, `putln`), as lines of the debug console.
//!
//! Programs redraw pages in each round of a loop. Text is therefore output only where it changes the page.

mod page_cells;

use std::collections::BTreeMap;

use page_cells::PageCells;

/// Text on user pages.
#[derive(Debug, Default)]
pub(crate) struct ScreenText {
    pub(crate) is_hidden: bool,
    /// Whether the run repeats a part that was already output, because it has gone back.
    pub(crate) is_repeated: bool,
    pages: BTreeMap<String, PageCells>,
    /// Position after the last output text, if the console is not at the beginning of a line.
    end: Option<Position>,
    /// Text that has not changed its page. It is the beginning of the line if changed text directly follows it.
    unchanged: Option<Piece>,
}

/// Text that an instruction writes on a page.
#[derive(Debug, Clone, Copy)]
pub(crate) struct PutText<'t> {
    /// Column of the first character.
    pub(crate) x: u8,
    /// Row.
    pub(crate) y: u8,
    pub(crate) text: &'t str,
    /// Whether the cursor is at the beginning of the next row afterwards.
    pub(crate) ends_line: bool,
    /// Time in seconds.
    pub(crate) time: f64,
}

/// Page and cell (column, row).
type Position = (String, usize, u8);

/// Text on a page.
#[derive(Debug)]
struct Piece {
    begin: Position,
    text: String,
    end: Position,
}

impl ScreenText {
    /// Returns the output for text on a page; `None` if the text does not change the page. Text that does not directly
    /// follow the last output begins a new line.
    pub(crate) fn put(&mut self, page: &str, put: PutText<'_>) -> Option<String> {
        let PutText { x, y, text, ends_line, .. } = put;
        if self.is_hidden {
            return None;
        }
        let is_changed = self.pages.entry(page.to_owned()).or_default().write(put);
        let begin = (page.to_owned(), usize::from(x), y);
        let end = (page.to_owned(), usize::from(x) + text.chars().count(), y);
        let before = self.unchanged.take().filter(|piece| piece.end == begin);
        if self.is_repeated {
            return None;
        }
        if !is_changed {
            let closes_line = ends_line && text.is_empty() && self.end.as_ref() == Some(&begin);
            if closes_line {
                self.end = None;
                return Some("\n".to_owned());
            }
            self.unchanged = (!ends_line).then(|| match before {
                Some(Piece { begin, text: first, .. }) => Piece { begin, text: first + text, end },
                None => Piece { begin, text: text.to_owned(), end },
            });
            return None;
        }
        let (begin, text) = before.map_or((begin, text.to_owned()), |piece| (piece.begin, piece.text + text));
        let separator = if self.end.as_ref().is_some_and(|end| *end != begin) { "\n" } else { "" };
        self.end = (!ends_line).then_some(end);
        Some(format!("{separator}{text}{}", if ends_line { "\n" } else { "" }))
    }

    /// Empties a page, at a time in seconds.
    pub(crate) fn clear(&mut self, page: &str, time: f64) {
        self.pages.entry(page.to_owned()).or_default().clear(time);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn put(screen: &mut ScreenText, page: &str, cell: (u8, u8), text: &str, ends_line: bool) -> Option<String> {
        let (x, y) = cell;
        screen.put(page, PutText { x, y, text, ends_line, time: 0.0 })
    }

    #[test]
    fn text_continues_a_line_only_where_the_cursor_is() {
        let mut screen = ScreenText::default();
        let mut put = |page, at, text, ends_line| put(&mut screen, page, at, text, ends_line);
        assert_eq!(put("", (0, 0), "count ", false).unwrap(), "count ");
        assert_eq!(put("", (6, 0), "5", true).unwrap(), "5\n");
        assert_eq!(put("", (0, 1), "left", false).unwrap(), "left");
        assert_eq!(put("", (4, 1), "", true).unwrap(), "\n");
        assert_eq!(put("", (20, 1), "right", false).unwrap(), "right");
        assert_eq!(put("scMain", (25, 1), "other page", false).unwrap(), "\nother page");
        assert_eq!(put("", (0, 3), "", true), None);
        assert_eq!(put("", (0, 4), "end", true).unwrap(), "\nend\n");
    }

    #[test]
    fn text_that_changes_nothing_is_no_output() {
        let mut screen = ScreenText::default();
        for (count, expected) in [("5", Some("count 5\n")), ("5", None), ("6", Some("count 6\n")), ("6", None)] {
            let label = put(&mut screen, "", (0, 2), "count ", false);
            let shown = label.into_iter().chain(put(&mut screen, "", (6, 2), count, true)).collect::<String>();
            assert_eq!(shown, expected.unwrap_or_default());
        }
    }

    /// A page that is cleared and drawn again has not changed, but text that appears after a while is new.
    #[test]
    fn a_redrawn_page_is_no_output() {
        let ready = |time| PutText { x: 0, y: 0, text: "ready", ends_line: true, time };
        let mut screen = ScreenText::default();
        let mut draw = |time: f64| {
            screen.clear("", time);
            screen.put("", ready(time + 0.01))
        };
        assert!(draw(1.0).is_some());
        assert_eq!(draw(2.0), None);
        screen.clear("", 3.0);
        assert!(screen.put("", ready(9.0)).is_some());
    }

    /// The last line scrolls after `putln`.
    #[test]
    fn equal_lines_of_a_list_are_output() {
        let mut screen = ScreenText::default();
        for _ in 0..3 {
            assert_eq!(put(&mut screen, "", (0, 13), "part placed", true).unwrap(), "part placed\n");
        }
    }

    #[test]
    fn text_of_a_repeated_part_is_no_output() {
        let mut screen = ScreenText { is_repeated: true, ..ScreenText::default() };
        assert_eq!(put(&mut screen, "", (0, 0), "text", true), None);
        screen.is_repeated = false;
        assert_eq!(put(&mut screen, "", (0, 0), "text", true), None, "the page has this text");
    }

    #[test]
    fn hidden_text_is_no_output() {
        let mut screen = ScreenText { is_hidden: true, ..ScreenText::default() };
        assert_eq!(put(&mut screen, "", (0, 0), "text", true), None);
    }
}
