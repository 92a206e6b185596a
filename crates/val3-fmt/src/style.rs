//! Format settings.

use val3_config::{CodeLayout, IndentStyle};

/// Format style of code.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct CodeStyle {
    /// One level of indentation.
    pub indent: Indent,
    /// Whether `=` has spaces on both sides.
    pub around_assignment: bool,
    /// Whether `+`, `==` and similar operators have spaces on both sides; `and`, `or` and `xor` always have them.
    pub around_operators: bool,
    /// Whether a space follows `,`.
    pub after_comma: bool,
    /// Limit of consecutive blank lines.
    pub blank_lines: usize,
}

/// One level of indentation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Indent {
    /// This number of spaces.
    Blanks(u8),
    /// A tab.
    Tab,
}

impl CodeStyle {
    /// Style defined by `format`; `elsewhere` provides indentation settings that `format` does not contain.
    pub fn new(format: &CodeLayout, elsewhere: IndentOverride) -> Self {
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

/// The style of most programs and of the vendor's editor.
impl Default for CodeStyle {
    fn default() -> Self {
        Self::new(&CodeLayout::default(), IndentOverride::default())
    }
}

/// Indentation settings from a source other than `val3.toml`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct IndentOverride {
    /// Spaces or tabs.
    pub style: Option<IndentStyle>,
    /// Number of spaces per level.
    pub size: Option<u8>,
}

impl Indent {
    /// Whitespace at the start of a line with `levels` levels of indentation.
    pub fn text(self, levels: usize) -> String {
        match self {
            Self::Blanks(width) => " ".repeat(levels * usize::from(width)),
            Self::Tab => "\t".repeat(levels),
        }
    }
}
