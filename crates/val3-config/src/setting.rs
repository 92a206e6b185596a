//! List of all settings, each with its value and its line.

use serde_json::Value;

use crate::schema::{property, schema_of};
use crate::{Config, ConfigFile};

/// A setting with its value.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Setting {
    /// Key, for example `lint.line-length`.
    pub key: String,
    /// Value in TOML syntax; empty without a value.
    pub value: String,
    /// Line that sets the value, from 1; `None` for a default.
    pub line: Option<usize>,
}

/// Returns all settings, tables last. Without a file, all settings have their defaults.
pub fn settings(file: Option<&ConfigFile>) -> Vec<Setting> {
    let default = ConfigFile::default();
    let file = file.unwrap_or(&default);
    let mut found = Vec::new();
    let (schema, value) = (schema_of::<Config>(), value_of(&file.config));
    collect(file, &schema, &value, "", &mut found);
    found
}

fn value_of(config: &Config) -> Value {
    serde_json::to_value(config).unwrap_or_default()
}

fn collect(file: &ConfigFile, schema: &Value, value: &Value, path: &str, found: &mut Vec<Setting>) {
    let named = schema.get("properties").and_then(Value::as_object).into_iter().flatten().map(|(key, _)| key);
    let given = value.as_object().into_iter().flatten().map(|(key, _)| key);
    let mut keys: Vec<&String> = named.chain(given).collect();
    // Single values come before tables, as in a TOML file.
    keys.sort_by_key(|key| (property(schema, key).is_some_and(is_table), *key));
    keys.dedup();
    for key in keys {
        let path = if path.is_empty() { key.clone() } else { format!("{path}.{key}") };
        let inner = value.get(key).unwrap_or(&Value::Null);
        match property(schema, key) {
            Some(schema) if is_table(schema) && has_keys(schema, inner) => collect(file, schema, inner, &path, found),
            _ => found.push(Setting { value: written(inner), line: file.line(&path), key: path }),
        }
    }
}

fn is_table(schema: &Value) -> bool {
    schema.get("type").is_some_and(|ty| ty == "object")
}

fn has_keys(schema: &Value, value: &Value) -> bool {
    schema.get("properties").is_some() || value.as_object().is_some_and(|object| !object.is_empty())
}

fn written(value: &Value) -> String {
    match value {
        Value::Null => String::new(),
        value => value.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use camino::Utf8Path;
    use expect_test::{Expect, expect};

    use super::*;

    #[track_caller]
    fn listed(text: &str, expected: Expect) {
        let file = ConfigFile::parse(Utf8Path::new("val3.toml"), text).unwrap();
        expected.assert_eq(&settings(Some(&file)).iter().map(shown).collect::<String>());
    }

    fn shown(Setting { key, value, line }: &Setting) -> String {
        match line {
            Some(line) => format!("{key} = {value} (line {line})\n"),
            None => format!("{key} = {value}").trim_end().to_owned() + "\n",
        }
    }

    #[test]
    fn settings_are_listed_with_their_source() {
        listed(
            "version = \"s8.12\"\nroots.USB0 = \"usb\"\n[rules]\nV03 = \"off\"\n[lint]\ncomplexity = 9\n",
            expect![[r#"
                add-ons = []
                arm =
                baseline =
                disk =
                exclude = []
                version = "s8.12" (line 1)
                format.blank-after-comma = false
                format.blank-lines = 2
                format.blanks-around-assignment = false
                format.blanks-around-operators = false
                format.indent-size =
                format.indent-style =
                lint.complexity = 9 (line 6)
                lint.entry-points = ["start","stop"]
                lint.entry-prefixes = []
                lint.line-length = 259
                lint.local-prefix = "l_"
                lint.motion = false
                lint.parameter-prefix = "x_"
                lint.parameters = 10
                lint.target-version =
                lint.task-words = ["todo","fixme","xxx","hack"]
                lint.prefixes.aio = "a"
                lint.prefixes.bool = "b"
                lint.prefixes.config = "c"
                lint.prefixes.dio = "d"
                lint.prefixes.frame = "f"
                lint.prefixes.joint = "j"
                lint.prefixes.mdesc = "m"
                lint.prefixes.num = "n"
                lint.prefixes.point = "p"
                lint.prefixes.screen = "sc"
                lint.prefixes.sio = "si"
                lint.prefixes.string = "s"
                lint.prefixes.tool = "t"
                lint.prefixes.trsf = "tr"
                roots.USB0 = "usb" (line 2)
                rules.V03 = "off" (line 4)
                run.cell =
                run.line-cost =
                run.monitor-speed =
                run.network = false
                run.power = false
                run.profile =
                run.start =
                run.add-ons = {}
                run.default.application =
                run.default.export =
                run.default.plot =
                run.default.script =
                run.default.times = false
                run.default.until =
                run.default.until-ok = false
                run.licences = {}
                run.lines = {}
                run.profiles = {}
                run.shapes = {}
                run.units = {}
                test.applications = []
                test.limit =
                test.replace = {}
            "#]],
        );
    }

    #[test]
    fn without_a_file_everything_is_default() {
        assert!(settings(None).iter().all(|setting| setting.line.is_none()));
    }
}
