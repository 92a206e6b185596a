//! What a user can set in the editor. What concerns the programs themselves belongs into a `val3.toml`.

use serde::Deserialize;
use serde_json::Value;
use val3_check::settings::{Selection, meant_by};
use val3_fmt::{Indent, Style};

/// The section of the editor's settings.
pub(crate) const SECTION: &str = "val3";

/// The settings of the editor.
#[derive(Debug, Clone, Default, PartialEq, Eq, Deserialize)]
#[serde(default, rename_all = "camelCase")]
pub(crate) struct Options {
    /// Findings.
    pub(crate) check: CheckOptions,
    /// Layout of code.
    pub(crate) format: FormatOptions,
}

/// Which findings are shown, and how they get to the editor.
#[derive(Debug, Clone, Default, PartialEq, Eq, Deserialize)]
#[serde(default, rename_all = "camelCase")]
pub(crate) struct CheckOptions {
    /// The only findings that are wanted, as codes, beginnings of codes or names; empty for all.
    pub(crate) select: Vec<String>,
    /// Findings that are not wanted.
    pub(crate) ignore: Vec<String>,
    /// Who begins: the server, the client, or whichever the client is made for.
    pub(crate) delivery: Delivery,
}

/// How findings get to the editor.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Delivery {
    /// The client asks if it can, otherwise the server sends.
    #[default]
    Auto,
    /// The server sends them.
    Push,
    /// The client asks for them.
    Pull,
}

/// The layout of code; what is not set is as `val3 fmt` has it.
#[derive(Debug, Clone, Default, PartialEq, Eq, Deserialize)]
#[serde(default, rename_all = "camelCase")]
pub(crate) struct FormatOptions {
    around_assignment: Option<bool>,
    around_operators: Option<bool>,
    after_comma: Option<bool>,
    blank_lines: Option<usize>,
}

impl Options {
    /// Reads what the client sent: the section itself, or an object that holds it. What cannot be read is as usual,
    /// and the second value says why.
    pub(crate) fn read(value: &Value) -> (Self, Option<String>) {
        let value = value.get(SECTION).unwrap_or(value);
        if value.is_null() {
            return (Self::default(), None);
        }
        match Self::deserialize(value) {
            Ok(options) => (options, None),
            Err(error) => (Self::default(), Some(format!("the settings of `{SECTION}` cannot be read: {error}"))),
        }
    }

    /// The findings that are wanted.
    pub(crate) fn selection(&self) -> Selection {
        let CheckOptions { select, ignore, .. } = &self.check;
        let codes =
            |words: &[String]| words.iter().flat_map(|word| meant_by(word)).map(|(rule, _)| rule.code).collect();
        let only = (!select.is_empty()).then(|| codes(select));
        let named = only.clone().unwrap_or_default();
        Selection { only, named, never: codes(ignore) }
    }

    /// The layout of code, with the indentation that the editor uses for the document.
    pub(crate) fn style(&self, tab_size: u32, insert_spaces: bool) -> Style {
        let usual = Style::default();
        let FormatOptions { around_assignment, around_operators, after_comma, blank_lines } = self.format;
        Style {
            indent: if insert_spaces { Indent::Blanks(u8::try_from(tab_size).unwrap_or(2)) } else { Indent::Tab },
            around_assignment: around_assignment.unwrap_or(usual.around_assignment),
            around_operators: around_operators.unwrap_or(usual.around_operators),
            after_comma: after_comma.unwrap_or(usual.after_comma),
            blank_lines: blank_lines.unwrap_or(usual.blank_lines),
        }
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn with_and_without_the_section() {
        let inner = json!({ "check": { "ignore": ["V0101"], "delivery": "push" } });
        let (options, fault) = Options::read(&inner);
        assert_eq!(fault, None);
        assert_eq!(options.check.delivery, Delivery::Push);
        assert!(options.selection().never.contains("V0101"));
        assert_eq!(Options::read(&json!({ "val3": inner })), (options, None));
    }

    #[test]
    fn what_cannot_be_read_is_as_usual() {
        assert_eq!(Options::read(&Value::Null), (Options::default(), None));
        let (options, fault) = Options::read(&json!({ "check": 3 }));
        assert_eq!(options, Options::default());
        assert!(fault.is_some());
    }
}
