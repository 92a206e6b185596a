//! Layout of code.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Layout of code: the table `[format]`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields, default)]
pub struct CodeLayout {
    /// The indentation character, "space" or "tab". The default is that of `.editorconfig`, otherwise "space".
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(with = "IndentStyle")]
    pub indent_style: Option<IndentStyle>,
    /// The number of blanks per level. The default is the value in `.editorconfig`, otherwise 2.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(with = "u8")]
    pub indent_size: Option<u8>,
    /// A blank on both sides of the `=` of assignments.
    pub blanks_around_assignment: bool,
    /// A blank on both sides of `+`, `==` and the other operators; `and`, `or` and `xor` always have them.
    pub blanks_around_operators: bool,
    /// A blank after `,`.
    pub blank_after_comma: bool,
    /// The largest number of consecutive blank lines.
    pub blank_lines: usize,
}

/// The indentation character.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
#[schemars(inline)]
pub enum IndentStyle {
    /// Blanks.
    Space,
    /// One tab for each level.
    Tab,
}

/// The layout of most programs and of the vendor's editor.
impl Default for CodeLayout {
    fn default() -> Self {
        Self {
            indent_style: None,
            indent_size: None,
            blanks_around_assignment: false,
            blanks_around_operators: false,
            blank_after_comma: false,
            blank_lines: 2,
        }
    }
}
