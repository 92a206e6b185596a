//! The settings of the layout.

use val3_config::{Format, IndentStyle};

/// The layout of code.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Style {
    /// One level of indentation.
    pub indent: Indent,
    /// A blank on both sides of `=`.
    pub around_assignment: bool,
    /// A blank on both sides of `+`, `==` and the other operators; `and`, `or` and `xor` always have them.
    pub around_operators: bool,
    /// A blank after `,`.
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

impl Style {
    /// The style that `format` asks for; `elsewhere` says what it leaves open about the indentation.
    pub fn new(format: &Format, elsewhere: IndentOverride) -> Self {
        let indent = match format.indent_style.or(elsewhere.style) {
            Some(IndentStyle::Tab) => Indent::Tab,
            _ => Indent::Blanks(format.indent_size.or(elsewhere.size).unwrap_or(2)),
        };
        Self {
            indent,
            around_assignment: format.blanks_around_assignment,
            around_operators: format.blanks_around_operators,
            after_comma: format.blank_after_comma,
            blank_lines: format.blank_lines,
        }
    }
}

/// The layout of most programs and of the vendor's editor.
impl Default for Style {
    fn default() -> Self {
        Self::new(&Format::default(), IndentOverride::default())
    }
}

/// Indentation settings from a source other than `val3.toml`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct IndentOverride {
    /// Blanks or tabs.
    pub style: Option<IndentStyle>,
    /// Blanks of one level.
    pub size: Option<u8>,
}

impl Indent {
    /// The blanks at the start of a line with `levels` levels of indentation.
    pub fn text(self, levels: usize) -> String {
        match self {
            Self::Blanks(width) => " ".repeat(levels * usize::from(width)),
            Self::Tab => "\t".repeat(levels),
        }
    }
}
