//! Text that code writes on user pages (`put`, `putln`), as lines of output.

use std::mem;

use val3_machine::event::{Event, EventKind};

/// The incomplete line of output.
#[derive(Debug, Default)]
pub(crate) struct PageText {
    line: String,
    /// Page and cell (column, row) after the line; `None` if there is no incomplete line.
    end: Option<(String, usize, u8)>,
}

impl PageText {
    /// Adds the text of an event. Returns the lines that are complete: text elsewhere on the page begins a new line.
    pub(crate) fn lines_of(&mut self, event: &Event) -> Vec<String> {
        let EventKind::Put { screen, x, y, text, ends_line } = &event.kind else { return Vec::new() };
        let (column, row) = (usize::from(*x), *y);
        let follows = |(page, end, last): &(String, usize, u8)| (page, *end, *last) == (screen, column, row);
        let mut lines = Vec::new();
        if !self.end.as_ref().is_none_or(follows) {
            lines.extend(self.take());
        }
        self.line.push_str(text);
        self.end = Some((screen.clone(), column + text.chars().count(), row));
        if *ends_line {
            lines.extend(self.take());
        }
        lines
    }

    /// Removes and returns the incomplete line.
    pub(crate) fn take(&mut self) -> Option<String> {
        self.end.take()?;
        Some(mem::take(&mut self.line))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn put(page: &mut PageText, screen: &str, cell: [u8; 2], text: &str, ends_line: bool) -> Vec<String> {
        let [x, y] = cell;
        let kind = EventKind::Put { screen: screen.to_owned(), x, y, text: text.to_owned(), ends_line };
        page.lines_of(&Event { t: 0.0, task: None, at: None, kind })
    }

    #[test]
    fn a_line_has_all_text_that_follows_on_the_page() {
        let mut page = PageText::default();
        assert!(put(&mut page, "", [0, 0], "n=", false).is_empty());
        assert_eq!(put(&mut page, "", [2, 0], "12", true), ["n=12"]);
        assert_eq!(put(&mut page, "", [0, 1], "", true), [""]);
        assert_eq!(page.take(), None);
    }

    #[test]
    fn text_elsewhere_begins_a_line() {
        let mut page = PageText::default();
        assert!(put(&mut page, "", [0, 0], "a", false).is_empty());
        assert_eq!(put(&mut page, "", [5, 3], "b", false), ["a"]);
        assert_eq!(put(&mut page, "scMenu", [6, 3], "c", false), ["b"]);
        assert_eq!(page.take().as_deref(), Some("c"));
    }
}
