//! Generated values in the hand-written manifest of the VS Code extension.

use anyhow::{Context as _, Result};
use serde_json::Value;

/// Line that closes a list of the contributions. The file is indented by two spaces per level.
const CLOSE: &str = "\n    ]";

/// Returns the manifest with `list` as `contributes.{key}`, and otherwise unchanged.
///
/// # Errors
/// There is no such list.
pub(crate) fn with_list(manifest: &str, key: &str, list: &Value) -> Result<String> {
    let open = manifest.find(&format!("\n    \"{key}\": ["));
    let open = open.with_context(|| format!("the manifest has no line `    \"{key}\": [`"))?;
    let (before, rest) = manifest.split_at(open);
    let close = rest.find(CLOSE).with_context(|| format!("the value of `{key}` is not closed"))?;
    let (_, after) = rest.split_at(close + CLOSE.len());
    let value = format!("{list:#}").replace('\n', "\n    ");
    Ok(format!("{before}\n    \"{key}\": {value}{after}"))
}

/// Returns the manifest with the version, address and publisher from `Cargo.toml`. The publisher is the owner of the
/// repository.
///
/// # Errors
/// The manifest does not contain these values, or the address has no owner.
pub(crate) fn with_origin(manifest: &str) -> Result<String> {
    let repository = env!("CARGO_PKG_REPOSITORY");
    let publisher = repository.rsplit('/').nth(1).context("the address of the repository has no owner")?;
    let manifest = with_text(manifest, "\n  \"version\": ", env!("CARGO_PKG_VERSION"))?;
    let manifest = with_text(&manifest, "\n  \"publisher\": ", publisher)?;
    with_text(&manifest, "\n    \"url\": ", repository)
}

/// Returns the manifest with `text` as the string after `key`.
fn with_text(manifest: &str, key: &str, text: &str) -> Result<String> {
    let missing = || format!("the manifest has no line `{}\"…\"`", key.trim_start());
    let (before, rest) = manifest.split_once(key).with_context(missing)?;
    let (_, after) = rest.strip_prefix('"').and_then(|rest| rest.split_once('"')).with_context(missing)?;
    Ok(format!("{before}{key}\"{text}\"{after}"))
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn only_the_list_changes() {
        let manifest = "{\n  \"contributes\": {\n    \"configuration\": [\n    ],\n    \"b\": []\n  }\n}\n";
        let once = with_list(manifest, "configuration", &json!([{ "title": "a" }])).unwrap();
        assert_eq!(
            once,
            "{\n  \"contributes\": {\n    \"configuration\": [\n      {\n        \"title\": \"a\"\n      }\n    ],\n    \"b\": []\n  }\n}\n"
        );
        assert_eq!(with_list(&once, "configuration", &json!([{ "title": "a" }])).unwrap(), once);
    }

    #[test]
    fn a_manifest_without_the_list_is_refused() {
        assert!(with_list("{}", "configuration", &json!([])).is_err());
    }

    #[test]
    fn the_version_and_the_address_are_those_of_the_workspace() {
        let manifest = |version: &str, publisher: &str, url: &str| {
            format!(
                "{{\n  \"version\": {version},\n  \"publisher\": {publisher},\n  \"r\": {{\n    \"url\": {url}\n  }}\n}}\n"
            )
        };
        let found: Value = serde_json::from_str(&with_origin(&manifest("\"\"", "\"a\"", "\"b\"")).unwrap()).unwrap();
        assert_eq!(found["version"], env!("CARGO_PKG_VERSION"));
        assert_eq!(found["r"]["url"], env!("CARGO_PKG_REPOSITORY"));
        let owner = found["publisher"].as_str().unwrap();
        assert!(env!("CARGO_PKG_REPOSITORY").contains(&format!("/{owner}/")));
        assert!(with_origin(&manifest("1", "\"a\"", "\"b\"")).is_err());
    }
}
