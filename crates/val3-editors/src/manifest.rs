//! The one generated value within the hand-written manifest of the VS Code extension.

use anyhow::{Context as _, Result};
use serde_json::Value;

/// The line that opens the value, and the one that closes it: the file is laid out with two blanks a level.
const OPEN: &str = "\n    \"configuration\": [";
const CLOSE: &str = "\n    ]";

/// The manifest with `settings` as its `contributes.configuration`; all else stays as it is.
///
/// # Errors
/// If there is no such value.
pub(crate) fn with_settings(manifest: &str, settings: &Value) -> Result<String> {
    let open = manifest.find(OPEN).context("the manifest has no line `    \"configuration\": [`")?;
    let (before, rest) = manifest.split_at(open);
    let close = rest.find(CLOSE).context("the value of `configuration` is not closed")?;
    let (_, after) = rest.split_at(close + CLOSE.len());
    let value = format!("{settings:#}").replace('\n', "\n    ");
    Ok(format!("{before}\n    \"configuration\": {value}{after}"))
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn only_the_settings_change() {
        let manifest = "{\n  \"contributes\": {\n    \"configuration\": [\n    ],\n    \"b\": []\n  }\n}\n";
        let once = with_settings(manifest, &json!([{ "title": "a" }])).unwrap();
        assert_eq!(
            once,
            "{\n  \"contributes\": {\n    \"configuration\": [\n      {\n        \"title\": \"a\"\n      }\n    ],\n    \"b\": []\n  }\n}\n"
        );
        assert_eq!(with_settings(&once, &json!([{ "title": "a" }])).unwrap(), once);
    }

    #[test]
    fn a_manifest_without_settings_is_refused() {
        assert!(with_settings("{}", &json!([])).is_err());
    }
}
