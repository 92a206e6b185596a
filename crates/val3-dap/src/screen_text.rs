//! Text that programs write on user pages (`put`, `putln`), as lines of the debug console.

/// Text on user pages.
#[derive(Debug, Default)]
pub(crate) struct ScreenText {
    pub(crate) is_hidden: bool,
    /// Page and cell after the last text, if the cursor did not move to the next line.
    end: Option<(String, usize, u8)>,
}

impl ScreenText {
    /// Returns the output for text at a cell (column, row). If the text does not directly follow the last text, it
    /// begins a new line.
    pub(crate) fn put(&mut self, page: &str, x: u8, y: u8, text: &str, ends_line: bool) -> Option<String> {
        if self.is_hidden {
            return None;
        }
        let begin = (page.to_owned(), usize::from(x), y);
        let separator = if self.end.as_ref().is_some_and(|end| *end != begin) { "\n" } else { "" };
        self.end = (!ends_line).then(|| (page.to_owned(), usize::from(x) + text.chars().count(), y));
        Some(format!("{separator}{text}{}", if ends_line { "\n" } else { "" }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_continues_a_line_only_where_the_cursor_is() {
        let mut screen = ScreenText::default();
        let mut put = |page, (x, y): (u8, u8), text, ends_line| screen.put(page, x, y, text, ends_line).unwrap();
        assert_eq!(put("", (0, 0), "count ", false), "count ");
        assert_eq!(put("", (6, 0), "5", true), "5\n");
        assert_eq!(put("", (0, 1), "left", false), "left");
        assert_eq!(put("", (20, 1), "right", false), "\nright");
        assert_eq!(put("scMain", (25, 1), "other page", false), "\nother page");
        assert_eq!(put("", (0, 3), "", true), "\n\n");
        assert_eq!(put("", (0, 4), "end", true), "end\n");
    }

    #[test]
    fn hidden_text_is_no_output() {
        let mut screen = ScreenText { is_hidden: true, end: None };
        assert_eq!(screen.put("", 0, 0, "text", true), None);
    }
}
