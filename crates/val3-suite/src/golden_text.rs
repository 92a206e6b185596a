//! Texts to compare with recorded texts: the page at the end of a test, and the printed lines.

use crate::failure::{Failure, FailureLocation};

/// Help for a missing or outdated file.
const RECORD: &str = "record it with `val3 test --update`";

/// Kind of a recorded text.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum GoldenKind {
    /// Title and lines of the page displayed at the end.
    Screen,
    /// Lines printed by `?`.
    Prints,
}

impl GoldenKind {
    /// First line in this kind of file.
    fn heading(self) -> &'static str {
        match self {
            Self::Screen => "# Screen at the end of a test",
            Self::Prints => "# Printed lines of a test",
        }
    }

    fn name(self) -> &'static str {
        match self {
            Self::Screen => "screen",
            Self::Prints => "printed text",
        }
    }

    /// Key of the expectation.
    pub(crate) fn key(self) -> &'static str {
        match self {
            Self::Screen => "expect.screen_file",
            Self::Prints => "expect.print_file",
        }
    }
}

/// A text of a test, and the file with the recorded text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct GoldenText {
    pub(crate) kind: GoldenKind,
    /// File relative to the test's file.
    pub(crate) file: String,
    /// Expectation.
    pub(crate) place: FailureLocation,
    /// Lines of the test, without trailing blanks.
    pub(crate) lines: Vec<String>,
}

impl GoldenText {
    /// File relative to the test's file.
    #[must_use]
    pub fn file(&self) -> &str {
        &self.file
    }

    /// Key of the expectation.
    #[must_use]
    pub fn key(&self) -> &'static str {
        self.kind.key()
    }

    /// Text of the file.
    #[must_use]
    pub fn text(&self) -> String {
        let lines = self.lines.iter().map(|line| format!("{line}\n"));
        format!("{}\n{}", self.kind.heading(), lines.collect::<String>())
    }

    /// Whether the text is a recorded text of this kind, so that its file may be replaced.
    #[must_use]
    pub fn is_recorded(&self, text: &str) -> bool {
        text.lines().next() == Some(self.kind.heading())
    }

    /// Failure of a test without output, for which nothing would be compared.
    #[must_use]
    pub fn empty(&self) -> Option<Failure> {
        let message = format!("the {} is empty, so there is nothing to compare with `{}`", self.kind.name(), self.file);
        self.lines.iter().all(String::is_empty).then(|| self.failure(message))
    }

    /// Compares the text with its file's content.
    #[must_use]
    pub fn judge(&self, text: &str) -> Option<Failure> {
        if !self.is_recorded(text) {
            return Some(self.failure(format!("`{}` is no recorded {}; {RECORD}", self.file, self.kind.name())));
        }
        let recorded: Vec<&str> = text.lines().skip(1).map(str::trim_end).collect();
        let count = recorded.len().max(self.lines.len());
        let line = |number: usize| (self.lines.get(number).map(String::as_str), recorded.get(number).copied());
        let first = (0..count).find(|number| line(*number).0 != line(*number).1)?;
        let shown = |line: Option<&str>| line.map_or_else(|| "no line".to_owned(), |line| format!("{line:?}"));
        let (actual, expected) = line(first);
        let message = format!(
            "the {} is not that of `{}`, from line {}\n  actual    {}\n  expected  {}",
            self.kind.name(),
            self.file,
            first + 2,
            shown(actual),
            shown(expected)
        );
        Some(self.failure(message))
    }

    /// Failure of a file that does not exist.
    #[must_use]
    pub fn missing(&self) -> Failure {
        self.failure(format!("there is no recorded {} `{}`: {RECORD}", self.kind.name(), self.file))
    }

    /// Failure of a file that cannot be read.
    #[must_use]
    pub fn refused(&self, reason: &str) -> Failure {
        self.failure(format!("the recorded {} `{}` cannot be read: {reason}", self.kind.name(), self.file))
    }

    fn failure(&self, message: String) -> Failure {
        Failure { message, places: vec![self.place.clone()] }
    }
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    fn screen(lines: &[&str]) -> GoldenText {
        let place = FailureLocation { program: String::new(), file: String::new(), line: 1 };
        let lines = lines.iter().map(|line| (*line).to_owned()).collect();
        GoldenText { kind: GoldenKind::Screen, file: "end.txt".to_owned(), place, lines }
    }

    #[test]
    fn the_first_difference_is_named() {
        let recorded = screen(&["Cell", "State running"]).text();
        assert_eq!(screen(&["Cell", "State running"]).judge(&recorded), None);
        let message = |lines: &[&str], text: &str| screen(lines).judge(text).unwrap().message;
        expect![[r#"
            the screen is not that of `end.txt`, from line 3
              actual    "State stopped"
              expected  "State running""#]]
        .assert_eq(&message(&["Cell", "State stopped"], &recorded));
        assert!(message(&["Cell"], &recorded).ends_with("actual    no line\n  expected  \"State running\""));
        assert!(message(&["Cell", "State running", "x"], &recorded).ends_with("expected  no line"));
        assert!(message(&["Cell"], "text").starts_with("`end.txt` is no recorded screen"));
    }

    #[test]
    fn an_empty_screen_proves_nothing() {
        assert!(screen(&["", ""]).empty().is_some());
        assert!(screen(&["Cell"]).empty().is_none());
    }
}
