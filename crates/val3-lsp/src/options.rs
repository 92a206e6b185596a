//! What a user can set in the editor. What concerns the programs themselves belongs into a `val3.toml`.

use serde::Deserialize;
use serde_json::Value;
use val3_check::settings::{Selection, meant_by};
use val3_ide::InlayHintSettings;

/// The section of the editor's settings.
pub(crate) const SECTION: &str = "val3";

/// The settings of the editor.
#[derive(Debug, Clone, Default, PartialEq, Eq, Deserialize)]
#[serde(default, rename_all = "camelCase")]
pub(crate) struct Options {
    /// Findings.
    pub(crate) check: CheckOptions,
    /// Short remarks between the words of the code.
    pub(crate) inlay_hints: InlayHintOptions,
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

/// Which remarks are shown; all that are not switched off.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(default, rename_all = "camelCase")]
pub(crate) struct InlayHintOptions {
    parameter_names: bool,
    literal_types: bool,
    point_frames: bool,
    blends: bool,
}

impl Default for InlayHintOptions {
    fn default() -> Self {
        let InlayHintSettings { parameter_names, literal_types, point_frames, blends } = InlayHintSettings::default();
        Self { parameter_names, literal_types, point_frames, blends }
    }
}

impl InlayHintOptions {
    /// As the hints take them.
    pub(crate) fn settings(self) -> InlayHintSettings {
        let Self { parameter_names, literal_types, point_frames, blends } = self;
        InlayHintSettings { parameter_names, literal_types, point_frames, blends }
    }
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
