//! Reading the text of a `val3.toml`.

use std::collections::BTreeMap;
use std::ops::Range;

use camino::{Utf8Path, Utf8PathBuf};
use serde::Deserialize;
use toml::de::{DeTable, DeValue, Deserializer};

use crate::error::line_of;
use crate::faults::first_fault;
use crate::schema::schema;
use crate::{Config, ConfigError};

/// The name of a configuration file.
pub const FILE_NAME: &str = "val3.toml";

/// A configuration with the file it stands in.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct ConfigFile {
    /// The file.
    pub path: Utf8PathBuf,
    /// Its text.
    pub text: String,
    /// What it says.
    pub config: Config,
    /// Where each key stands (`rules.V0301`), in bytes of the text.
    places: BTreeMap<String, Range<usize>>,
}

impl ConfigFile {
    /// Reads `text`, which stands in the file `path`.
    ///
    /// # Errors
    /// If it is no TOML, has an unknown key, or a value that its key does not take: the first of these faults.
    pub fn parse(path: &Utf8Path, text: &str) -> Result<Self, ConfigError> {
        let error = |range: Range<usize>, message: String, help: String| ConfigError {
            path: path.to_owned(),
            text: text.to_owned(),
            range,
            message,
            help,
        };
        let of_toml = |fault: toml::de::Error| {
            error(fault.span().unwrap_or_default(), fault.message().trim().to_owned(), String::new())
        };
        let table = DeTable::parse(text)
            .map_err(|fault| error(fault.span().unwrap_or_default(), no_toml(fault.message()), String::new()))?;
        if let Some(fault) = first_fault(table.get_ref(), &schema()) {
            return Err(error(fault.range, fault.message, fault.help));
        }
        let mut places = BTreeMap::new();
        collect_places(table.get_ref(), "", &mut places);
        let config = Config::deserialize(Deserializer::from(table)).map_err(of_toml)?;
        Ok(Self { path: path.to_owned(), text: text.to_owned(), config, places })
    }

    /// The folder that paths in the file count from.
    pub fn folder(&self) -> &Utf8Path {
        self.path.parent().unwrap_or(Utf8Path::new(""))
    }

    /// The line of a key (`rules.V0301`), from 1; `None` where the file does not say it.
    pub fn line(&self, key: &str) -> Option<usize> {
        self.places.get(key).map(|place| line_of(&self.text, place.start))
    }

    /// A fault of the setting `key` that only its reader can see.
    pub fn fault(&self, key: &str, message: String, help: String) -> ConfigError {
        let range = self.places.get(key).cloned().unwrap_or_default();
        ConfigError { path: self.path.clone(), text: self.text.clone(), range, message, help }
    }

    /// Whether the file excludes what lies at `path` from being checked.
    pub fn excludes(&self, path: &Utf8Path) -> bool {
        path.strip_prefix(self.folder()).is_ok_and(|inside| self.config.exclude.contains(inside))
    }
}

fn no_toml(reason: &str) -> String {
    format!("this is not TOML: {}", reason.trim())
}

fn collect_places(table: &DeTable<'_>, path: &str, places: &mut BTreeMap<String, Range<usize>>) {
    for (key, value) in table {
        let name = key.get_ref();
        let path = if path.is_empty() { name.to_string() } else { format!("{path}.{name}") };
        if let DeValue::Table(table) = value.get_ref() {
            collect_places(table, &path, places);
        }
        places.insert(path, key.span());
    }
}

#[cfg(test)]
mod tests {
    use expect_test::{Expect, expect};

    use super::*;
    use crate::Level;

    const FULL: &str = r#"
version = "s8.12"
arm = "tx2-60l"
disk = "usr/usrapp"
roots = { USB0 = "usb" }
add-ons = ["tables/val3.file.anthro.cfx"]
exclude = ["old/**", "**/backup"]
baseline = "val3-baseline.json"

[rules]
V0301 = "off"
argument-range = "error"

[lint]
line-length = 120

[lint.prefixes]
num = "n"
"#;

    fn parse(text: &str) -> Result<ConfigFile, ConfigError> {
        ConfigFile::parse(Utf8Path::new("cell/val3.toml"), text)
    }

    #[track_caller]
    fn refused(text: &str, expected: Expect) {
        expected.assert_eq(&format!("{}\n", parse(text).unwrap_err()));
    }

    #[test]
    fn everything_that_can_be_said() {
        let file = parse(FULL).unwrap();
        assert_eq!(file.config.version.map(|version| version.to_string()).as_deref(), Some("s8.12"));
        assert_eq!(file.config.rules.get("V0301"), Some(&Level::Off));
        assert_eq!((file.config.lint.line_length, file.config.lint.complexity), (120, 20));
        assert!(file.excludes(Utf8Path::new("cell/old/app/app.pjx")));
        assert!(!file.excludes(Utf8Path::new("old/app/app.pjx")));
        assert_eq!(
            (file.line("version"), file.line("rules.V0301"), file.line("lint.complexity")),
            (Some(2), Some(11), None)
        );
        assert_eq!((file.line("roots.USB0"), file.line("lint.prefixes.num")), (Some(5), Some(18)));
    }

    #[test]
    fn an_empty_file_says_nothing() {
        assert_eq!(parse("").unwrap().config, Config::default());
    }

    #[test]
    fn unknown_keys() {
        refused(
            "verison = \"s8\"\n",
            expect![[r#"
            there is no setting `verison`
             --> cell/val3.toml:1
              |
            1 | verison = "s8"
              | ^^^^^^^
              help: did you mean `version`?
        "#]],
        );
        refused(
            "[lint]\nline_length = 100\n",
            expect![[r#"
            there is no setting `lint.line_length`
             --> cell/val3.toml:2
              |
            2 | line_length = 100
              | ^^^^^^^^^^^
              help: did you mean `line-length`?
        "#]],
        );
        refused(
            "[lint.naming]\nnum = \"n\"\n",
            expect![[r#"
            there is no setting `lint.naming`
             --> cell/val3.toml:1
              |
            1 | [lint.naming]
              |       ^^^^^^
              help: known here: complexity, entry-points, entry-prefixes, line-length, local-prefix, parameter-prefix, prefixes, task-words
        "#]],
        );
    }

    #[test]
    fn wrong_types() {
        refused(
            "version = 8.12\n",
            expect![[r#"
            `version` must be a text in quotes, and this is a number with a fraction
             --> cell/val3.toml:1
              |
            1 | version = 8.12
              |           ^^^^
        "#]],
        );
        refused(
            "add-ons = \"a.cfx\"\n",
            expect![[r#"
            `add-ons` must be a list in square brackets, and this is a text in quotes
             --> cell/val3.toml:1
              |
            1 | add-ons = "a.cfx"
              |           ^^^^^^^
        "#]],
        );
        refused(
            "exclude = [1]\n",
            expect![[r#"
            each entry of `exclude` must be a text in quotes, and this is a whole number
             --> cell/val3.toml:1
              |
            1 | exclude = [1]
              |            ^
        "#]],
        );
        refused(
            "[lint]\ncomplexity = -3\n",
            expect![[r#"
            `lint.complexity` cannot be negative
             --> cell/val3.toml:2
              |
            2 | complexity = -3
              |              ^^
        "#]],
        );
        refused(
            "rules = \"off\"\n",
            expect![[r#"
            `rules` must be a table, and this is a text in quotes
             --> cell/val3.toml:1
              |
            1 | rules = "off"
              |         ^^^^^
        "#]],
        );
    }

    #[test]
    fn wrong_words() {
        refused(
            "[rules]\nV0301 = \"eror\"\n",
            expect![[r#"
            `rules.V0301` must be one of off, on, info, warning, error, default, not "eror"
             --> cell/val3.toml:2
              |
            2 | V0301 = "eror"
              |         ^^^^^^
              help: did you mean "error"?
        "#]],
        );
        refused(
            "version = \"8.12\"\n",
            expect![[r#"
            `8.12` is no version of VAL 3; write it like "s7.11"
             --> cell/val3.toml:1
              |
            1 | version = "8.12"
              |           ^^^^^^
        "#]],
        );
        refused(
            "arm = \"kr210\"\n",
            expect![[r#"
            `kr210` is no arm; write "six-axis", "scara", "other", or a model such as "tx2-60l"
             --> cell/val3.toml:1
              |
            1 | arm = "kr210"
              |       ^^^^^^^
        "#]],
        );
        refused(
            "exclude = [\"a[\"]\n",
            expect![[r#"
            the pattern `a[` cannot be read: unclosed character class; missing ']'
             --> cell/val3.toml:1
              |
            1 | exclude = ["a["]
              |           ^^^^^^
        "#]],
        );
    }

    #[test]
    fn no_toml() {
        refused(
            "version = s8.12\n",
            expect![[r#"
            this is not TOML: string values must be quoted, expected literal string
             --> cell/val3.toml:1
              |
            1 | version = s8.12
              |           ^^^^^
        "#]],
        );
        refused(
            "disk = 'a'\ndisk = 'b'\n",
            expect![[r#"
            this is not TOML: duplicate key
             --> cell/val3.toml:2
              |
            2 | disk = 'b'
              | ^^^^
        "#]],
        );
    }
}
