//! Layout of code.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Layout of code: the table `[format]`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields, default)]
pub struct Format {
    /// What lines are indented with, "space" or "tab". Without it `.editorconfig` counts, then "space".
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(with = "IndentStyle")]
    pub indent_style: Option<IndentStyle>,
    /// Blanks of one level. Without it `.editorconfig` counts, then 2.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(with = "u8")]
    pub indent_size: Option<u8>,
    /// A blank on both sides of the `=` of assignments.
    pub blanks_around_assignment: bool,
    /// A blank on both sides of `+`, `==` and the other operators; `and`, `or` and `xor` always have them.
    pub blanks_around_operators: bool,
    /// A blank behind `,`.
    pub blank_after_comma: bool,
    /// The most blank lines in a row.
    pub blank_lines: usize,
}

/// What lines are indented with.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
#[schemars(inline)]
pub enum IndentStyle {
    /// Blanks.
    Space,
    /// One tab a level.
    Tab,
}

/// What most programs look like, and what the vendor's editor writes.
impl Default for Format {
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
