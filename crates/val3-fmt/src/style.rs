//! What a user may choose.

/// The layout of code.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Style {
    /// One level of indentation.
    pub indent: Indent,
    /// A blank on both sides of `=`.
    pub around_assignment: bool,
    /// A blank on both sides of `+`, `==` and the other operators; `and`, `or` and `xor` always have them.
    pub around_operators: bool,
    /// A blank behind `,`.
    pub after_comma: bool,
    /// Blank lines in a row that are kept.
    pub blank_lines: usize,
}

/// One level of indentation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Indent {
    /// So many blanks.
    Blanks(u8),
    /// A tab.
    Tab,
}

/// What most programs look like, and what the vendor's editor writes.
impl Default for Style {
    fn default() -> Self {
        Self {
            indent: Indent::Blanks(2),
            around_assignment: false,
            around_operators: false,
            after_comma: false,
            blank_lines: 2,
        }
    }
}

impl Indent {
    /// The blanks before a line that stands `levels` deep.
    pub(crate) fn text(self, levels: usize) -> String {
        match self {
            Self::Blanks(width) => " ".repeat(levels * usize::from(width)),
            Self::Tab => "\t".repeat(levels),
        }
    }
}
