//! Editor settings. Settings of the programs themselves belong in `val3.toml`.

use std::collections::BTreeSet;

use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};
use val3_check::settings::{RuleSelection, meant_by};
use val3_ide::InlayHintSettings;
use val3_lang::suggest::{nearest, question};

/// Section name in the editor's settings.
pub(crate) const SECTION: &str = "val3";

/// Settings in this section that editors use themselves and also send.
const OF_EDITORS: [&str; 5] = ["codeView", "commands", "dataEditor", "server", "trace"];

/// Editor settings.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default, rename_all = "camelCase")]
pub(crate) struct Options {
    /// Findings.
    pub(crate) check: CheckOptions,
    /// Code lenses.
    pub(crate) code_lens: CodeLensOptions,
    /// Inlay hints.
    pub(crate) inlay_hints: InlayHintOptions,
}

/// Selection and delivery of findings.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default, rename_all = "camelCase")]
pub(crate) struct CheckOptions {
    /// Selected findings, as codes, code prefixes or names; empty selects all.
    pub(crate) select: Vec<String>,
    /// Ignored findings, in the same form.
    pub(crate) ignore: Vec<String>,
    /// Whether the server pushes findings, the client pulls them, or the client's capabilities decide.
    pub(crate) delivery: Delivery,
}

/// Delivery of findings.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Delivery {
    /// The client pulls if it supports that, otherwise the server pushes.
    #[default]
    Auto,
    /// The server pushes.
    Push,
    /// The client pulls.
    Pull,
}

/// Enabled code lenses with reference counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default, rename_all = "camelCase")]
pub(crate) struct CodeLensOptions {
    pub(crate) program_references: bool,
    /// Off by default, because a line of its own for each datum of a file makes the file twice as long.
    pub(crate) data_references: bool,
}

impl Default for CodeLensOptions {
    fn default() -> Self {
        Self { program_references: true, data_references: false }
    }
}

/// Enabled inlay hints; all are enabled by default.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
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
    /// Converts to the settings of the feature.
    pub(crate) fn settings(self) -> InlayHintSettings {
        let Self { parameter_names, literal_types, point_frames, blends } = self;
        InlayHintSettings { parameter_names, literal_types, point_frames, blends }
    }
}

impl Options {
    /// Reads the settings from the client: the section itself, or an object that contains it. Invalid settings keep
    /// their default, and the second value contains the error messages.
    pub(crate) fn read(value: &Value) -> (Self, Vec<String>) {
        let value = value.get(SECTION).unwrap_or(value);
        let mut faults = Vec::new();
        let mut settings = serde_json::to_value(Self::default()).unwrap_or_default();
        match (&mut settings, value) {
            (Value::Object(settings), Value::Object(given)) => merge(settings, given, &[], &mut faults),
            (_, Value::Null) => {}
            _ => faults.push(format!("the settings of `{SECTION}` must be an object")),
        }
        let options = Self::deserialize(settings).unwrap_or_default();
        faults.extend(options.check.unknown_words());
        (options, faults)
    }

    /// Like [`read`](Self::read), for settings that the client pushes. Some clients push the settings of all servers,
    /// so an object without any known key is ignored.
    pub(crate) fn read_sent(value: &Value) -> (Self, Vec<String>) {
        match value.as_object().is_some_and(|given| given.keys().any(|key| is_ours(key))) {
            true => Self::read(value),
            false => (Self::default(), Vec::new()),
        }
    }

    /// Selected findings.
    pub(crate) fn selection(&self) -> RuleSelection {
        let CheckOptions { select, ignore, .. } = &self.check;
        let only = (!select.is_empty()).then(|| codes(select));
        let named = only.clone().unwrap_or_default();
        RuleSelection { only, named, never: codes(ignore), target: None }
    }
}

impl CheckOptions {
    /// Words in `select` and `ignore` that match no rule.
    fn unknown_words(&self) -> impl Iterator<Item = String> {
        let lists = [("select", &self.select), ("ignore", &self.ignore)];
        let words = lists.into_iter().flat_map(|(key, words)| words.iter().map(move |word| (key, word)));
        words
            .filter(|(_, word)| meant_by(word).is_empty())
            .map(|(key, word)| format!("the setting `{SECTION}.check.{key}`: no rule has the code or name `{word}`"))
    }
}

/// Whether the section has this key.
/// Codes of the rules that the words name.
fn codes(words: &[String]) -> BTreeSet<&'static str> {
    words.iter().flat_map(|word| meant_by(word)).map(|(rule, _)| rule.code).collect()
}

/// Whether the key belongs to the settings of this server or its editor extensions.
fn is_ours(key: &str) -> bool {
    key == SECTION || OF_EDITORS.contains(&key) || is_known(key)
}

fn is_known(key: &str) -> bool {
    serde_json::to_value(Options::default()).is_ok_and(|settings| settings.get(key).is_some())
}

/// Overwrites the defaults with the client's settings.
fn merge(settings: &mut Map<String, Value>, given: &Map<String, Value>, path: &[&str], faults: &mut Vec<String>) {
    let keys: Vec<String> = settings.keys().cloned().collect();
    for (key, value) in given.iter().filter(|(_, value)| !value.is_null()) {
        let path = [path, &[key.as_str()]].concat();
        let name = format!("{SECTION}.{}", path.join("."));
        match (settings.get_mut(key), value) {
            (None, _) if path.len() == 1 && OF_EDITORS.contains(&key.as_str()) => {}
            (None, _) => faults.push(unknown(&name, key, &keys)),
            (Some(Value::Object(settings)), Value::Object(given)) => merge(settings, given, &path, faults),
            (Some(Value::Object(_)), _) => faults.push(format!("the setting `{name}` must be an object")),
            (Some(setting), value) => match Options::deserialize(nested(&path, value)) {
                Ok(_) => *setting = value.clone(),
                Err(error) => faults.push(format!("the setting `{name}` cannot be read: {error}")),
            },
        }
    }
}

fn unknown(name: &str, key: &str, keys: &[String]) -> String {
    let help = question(nearest(key, keys.iter().map(String::as_str)))
        .unwrap_or_else(|| format!("known settings: {}", keys.join(", ")));
    format!("there is no setting `{name}`; {help}")
}

/// Settings that contain one value at the key path.
fn nested(path: &[&str], value: &Value) -> Value {
    path.iter().rev().fold(value.clone(), |inner, key| Map::from_iter([((*key).to_owned(), inner)]).into())
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn options_are_read_with_and_without_the_section() {
        let inner = json!({ "check": { "ignore": ["V0101"], "delivery": "push" } });
        let (options, faults) = Options::read(&inner);
        assert_eq!(faults, Vec::<String>::new());
        assert_eq!(options.check.delivery, Delivery::Push);
        assert!(options.selection().never.contains("V0101"));
        assert_eq!(Options::read(&json!({ "val3": inner })), (options, faults));
        assert_eq!(Options::read(&Value::Null), (Options::default(), Vec::new()));
    }

    #[test]
    fn unreadable_settings_have_their_default() {
        let given = json!({
            "check": { "ingore": ["V0101"], "delivery": "often", "select": 3, "ignore": ["V9999", "V0101"] },
            "inlayHints": { "blends": "no", "parameterNames": false, "literalTypes": null },
            "colour": true,
        });
        let (options, faults) = Options::read(&given);
        expect_test::expect![[r#"
            the setting `val3.check.delivery` cannot be read: unknown variant `often`, expected one of `auto`, `push`, `pull`
            there is no setting `val3.check.ingore`; did you mean `ignore`?
            the setting `val3.check.select` cannot be read: invalid type: integer `3`, expected a sequence
            there is no setting `val3.colour`; known settings: check, codeLens, inlayHints
            the setting `val3.inlayHints.blends` cannot be read: invalid type: string "no", expected a boolean
            the setting `val3.check.ignore`: no rule has the code or name `V9999`"#]]
        .assert_eq(&faults.join("\n"));
        // Valid settings next to an invalid one are applied.
        assert!(options.selection().never.contains("V0101"));
        assert!(!options.inlay_hints.parameter_names && options.inlay_hints.blends);
        let (options, faults) = Options::read(&json!({ "check": 3 }));
        assert_eq!((options, faults.len()), (Options::default(), 1));
    }

    #[test]
    fn settings_of_other_servers_are_ignored() {
        let others = json!({ "rust-analyzer": { "check": {} }, "python": {} });
        assert_eq!(Options::read_sent(&others), (Options::default(), Vec::new()));
        assert_eq!(Options::read_sent(&json!({})), (Options::default(), Vec::new()));
        assert_eq!(Options::read_sent(&json!({ "python": {}, "val3": { "chekc": {} } })).1.len(), 1);
        assert_eq!(Options::read_sent(&json!({ "check": { "ingore": [] } })).1.len(), 1);
    }

    #[test]
    fn every_setting_of_the_extension_is_known() {
        let manifest = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../editors/vscode/package.json");
        let manifest: Value = serde_json::from_str(&std::fs::read_to_string(manifest).unwrap()).unwrap();
        let groups = manifest["contributes"]["configuration"].as_array().unwrap();
        let settings = groups.iter().flat_map(|group| group["properties"].as_object().unwrap());
        let mut count = 0;
        for (name, setting) in settings {
            let path: Vec<&str> = name.split('.').collect();
            let (_, faults) = Options::read(&nested(&path, &setting["default"]));
            assert_eq!(faults, Vec::<String>::new(), "{name}");
            count += 1;
        }
        assert!(count > 5);
    }
}
